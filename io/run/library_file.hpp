// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <filesystem>

namespace gyro {

/// Writes DIRECTORY/library.h5, which must exist: a group a rock, /rocks/NAME, with datasets centres
/// (n x 3) [m], radii [m], bonds (m x 2, rows of centres), bond_length [m], bond_radius [m] and the figures
/// of the rock as attributes. @throws OutputError
void write_library(const RockLibrary& library, const std::filesystem::path& directory);

/// Writes a picture for ParaView, DIRECTORY/{particles,bonds}.pvd: the rocks side by side along x.
/// @throws OutputError
void write_library_preview(const RockLibrary& library, const std::filesystem::path& directory);

}  // namespace gyro

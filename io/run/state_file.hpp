// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"

#include <filesystem>

namespace gyro {

/// Form of checkpoint.h5: raised when a new program can no longer continue from an older file.
inline constexpr std::uint64_t state_format = 5;

/// Writes a state as an HDF5 file: every column a dataset; the digest of all bytes stands behind them. The file is
/// replaced in one piece: at any moment, also after a kill or on a full disk, PATH is the old state or the new one.
/// @throws OutputError
void write_state(const std::filesystem::path& path, const SavedState& state);

/// @throws BadInput, with the path, for a file that is missing, cut off, damaged or of another form
SavedState read_state(const std::filesystem::path& path);

}  // namespace gyro

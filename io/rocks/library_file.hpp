// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"

#include <filesystem>
#include <string>

namespace gyro {

/// Writes a library as HDF5. For each rock there is a group /rocks/NAME (NAME#2 and so on where rocks share a name):
/// datasets centres (n x 3) [m], radii [m], bonds (m x 2, rows of centres), bond_length [m], bond_radius [m],
/// colour_begin (rows of bonds), hull_vertices (v x 3) [m], hull_faces (f x 3, rows of hull_vertices), and the other
/// members of RockTemplate as attributes. /names holds the names in the order of the library, /notes its notes.
/// @param recipe  text that the library was made from (recipe_text), kept in /recipe
/// @throws OutputError
void write_library(const RockLibrary& library, const std::filesystem::path& file, const std::string& recipe = {});

/// A library as a file holds it.
struct StoredLibrary {
  std::string recipe;
  RockLibrary library;
};

/// Reads what write_library has written, bit for bit. The digest of all bytes stands behind them.
/// @throws BadInput if the file is missing or damaged, or of another format
StoredLibrary read_library(const std::filesystem::path& file);

/// Writes a picture for ParaView, DIRECTORY/{particles,bonds}.pvd: the rocks side by side along x.
/// @throws OutputError
void write_library_preview(const RockLibrary& library, const std::filesystem::path& directory);

}  // namespace gyro

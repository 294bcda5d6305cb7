// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"

#include <filesystem>
#include <string>

namespace gyro {

/// Writes a library as HDF5. Each rock has a group /rocks/NAME (NAME#2 and so on if rocks share a name) with the
/// datasets centres (n x 3) [m], radii [m], bonds (m x 2, rows of centres), bond_length [m], bond_radius [m],
/// colour_begin (rows of bonds), hull_vertices (v x 3) [m] and hull_faces (f x 3, rows of hull_vertices). The other
/// members of RockTemplate are attributes of the group. /names contains the names in the order of the library, /notes
/// its notes.
/// @param recipe  text from which the library was made (recipe_text); written to /recipe
/// @throws OutputError
void write_library(const RockLibrary& library, const std::filesystem::path& file, const std::string& recipe = {});

/// The contents of a library file.
struct StoredLibrary {
  std::string recipe;
  RockLibrary library;
};

/// Reads what write_library has written, identical to the bit. The digest at the end of the file is checked first.
/// @throws BadInput if the file is missing or damaged, or of another format
StoredLibrary read_library(const std::filesystem::path& file);

/// Writes snapshots for ParaView, DIRECTORY/{particles,bonds}.pvd, which show the rocks side by side along x.
/// @throws OutputError
void write_library_preview(const RockLibrary& library, const std::filesystem::path& directory);

}  // namespace gyro

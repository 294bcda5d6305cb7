// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace gyro {

/// Appends to a file the digest of its content. HDF5 ignores bytes after its data.
/// @throws OutputError
void seal(const std::filesystem::path& file);

/// Whether a file ends with the digest of all bytes before it. The HDF5 library can crash or hang on a damaged file.
/// Therefore files that are written only once are checked with this function before the library opens them.
bool is_sealed(const std::filesystem::path& file);

}  // namespace gyro

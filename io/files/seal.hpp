// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace gyro {

/// Appends the digest of a file's content to it. HDF5 ignores what stands behind its data.
/// @throws OutputError
void seal(const std::filesystem::path& file);

/// Whether a file ends with the digest of what stands before it. The HDF5 library can crash or hang on a damaged file,
/// so files that are written once are checked with this before the library opens them.
bool is_sealed(const std::filesystem::path& file);

}  // namespace gyro

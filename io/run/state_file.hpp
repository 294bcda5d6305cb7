// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"

#include <filesystem>
#include <string>

namespace gyro {

/// Format of checkpoint.h5. It is raised when a new version can no longer continue from an older file.
inline constexpr std::uint64_t state_format = 11;

/// Writes a state as an HDF5 file in which every column is a dataset, followed by the digest of all bytes. The file is
/// replaced as a whole: at any time, also after a kill or on a full disk, PATH is either the old state or the new one.
/// @throws OutputError
void write_state(const std::filesystem::path& path, const SavedState& state);

/// Reads a state. @throws BadInput, with the path, for a file that is missing, cut off, damaged or of another format
/// @param advice  what to do about a file that cannot be read
SavedState read_state(const std::filesystem::path& path,
                      const std::string& advice = "restore the file, or use --overwrite to start the run again");

}  // namespace gyro

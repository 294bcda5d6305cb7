// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace gyro {

/// Writes a file so that a reader sees either the old or the new content but never a part of it, also after a crash of
/// the machine: writes PATH.tmp and then renames it. @param sync  also wait until the content is on the disk
/// @throws OutputError with path and reason
void replace_file(const std::filesystem::path& path, std::string_view content, bool sync = false);

/// Waits until PATH.tmp, a file that has been written and closed, is on the disk, and then renames it to PATH.
/// @throws OutputError with path and reason; PATH is then unchanged
void put_in_place(const std::filesystem::path& path);

/// Waits until everything that was written to a file is on the disk. @throws OutputError
void sync_file(const std::filesystem::path& path);

}  // namespace gyro

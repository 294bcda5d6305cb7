// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace gyro {

/// Writes a file so that a reader, or a machine that goes down, sees the old content or the new one but
/// never a part: PATH.tmp, then rename. @param sync also waits until the disk has it
/// @throws OutputError with path and reason
void replace_file(const std::filesystem::path& path, std::string_view content, bool sync = false);

/// Puts a file that is written and closed, PATH.tmp, in the place of PATH, once the disk has it.
/// @throws OutputError with path and reason; PATH is then as it was
void put_in_place(const std::filesystem::path& path);

/// Waits until the disk has what was written to a file. @throws OutputError
void sync_file(const std::filesystem::path& path);

}  // namespace gyro

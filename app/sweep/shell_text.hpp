// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace gyro {

/// A word of a shell's command line, in quotes where it needs them.
std::string shell_word(const std::string& word);

/// A command line for a shell.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/command_line.hpp"

#include <string>

namespace gyro {

/// The manual page gyrosim(1), in roff.
std::string manual_page(const CommandText& program, const std::string& version);

/// Completion of commands, options and their values for bash; other words complete as files.
std::string bash_completion(const CommandText& program);

/// The same for zsh, with descriptions.
std::string zsh_completion(const CommandText& program);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace gyro {

/// What a command line asks for.
struct CommandLine {
  std::function<int()>
      command;        ///< returns the exit code; empty after help, the version or a mistake, which are printed
  int exit_code = 0;  ///< of the program where there is no command
};

CommandLine parse_command_line(int argc, char** argv);

/// An option or a positional argument, for the manual page and the shells' completions.
struct OptionText {
  std::string name;   ///< with its dashes, "--out"; a positional argument has none, "case"
  std::string value;  ///< what kind of value follows, such as TEXT or INT; empty for flags and positionals
  std::string description;
  std::vector<std::string> choices;  ///< the values that are allowed; empty: any
  bool positional = false;
  bool takes_value = false;
};

/// A command with its options; the program itself has the name "" and the commands below it.
struct CommandText {
  std::string name, description;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;
};

/// The command line as data. It is that of the parser, so the pages written from it are complete.
CommandText command_line_text();

}  // namespace gyro

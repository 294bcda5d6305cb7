// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/pages.hpp"
#include "app/commands/commands.hpp"

namespace gyro {
namespace {

/// Text for roff: dashes that stay dashes, no line that reads as a request.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
  }
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string option_entry(const OptionText& o) {
  std::string head = o.positional ? italic(o.name) : bold(o.name);
  if (!o.value.empty()) head += " " + italic(o.value);
  std::string text = ".TP\n" + head + "\n" + roff(o.description);
  if (!o.choices.empty() && o.description.find(o.choices.front()) == std::string::npos)
    text += "; one of " + roff(joined(o.choices));
  return text + "\n";
}

/// A command, or each of the commands below it, with its synopsis and options.
std::string command_entry(const CommandText& command, const std::string& before) {
  const std::string name = before + " " + command.name;
  std::string text;
  if (command.commands.empty()) {
    text = ".SS \"" + roff(name);
    for (const OptionText& o : command.options)
      if (o.positional) text += " " + roff(o.name);
    text += " [options]\"\n" + roff(command.description) + "\n";
    for (const OptionText& o : command.options)
      if (o.name != "--help") text += option_entry(o);
  }
  for (const CommandText& below : command.commands) text += command_entry(below, name);
  return text;
}

std::string exit_codes() {
  const std::pair<int, const char*> codes[] = {
      {exit_done, "done"},
      {exit_internal, "internal error"},
      {exit_bad_input, "bad usage or bad input"},
      {exit_check_failed, "a check of verify failed"},
      {exit_stopped, "stopped by a guard or by the energy balance; the last good checkpoint is kept"},
      {exit_output, "output or system error, such as a full disk"},
      {exit_no_device, "no such device, or out of memory"},
      {exit_interrupted, "stopped early with a checkpoint; continue with run --resume"},
      {130, "ended at once by a second Ctrl-C"}};
  std::string text;
  for (const auto& [code, meaning] : codes) text += ".TP\n.B " + std::to_string(code) + "\n" + roff(meaning) + "\n";
  return text;
}

}  // namespace

std::string manual_page(const CommandText& program, const std::string& version) {
  std::string text =
      ".\\\" Written from the command line's own description when gyrosim was built.\n"
      ".TH GYROSIM 1 \"\" \"gyrosim " +
      roff(version) +
      "\" \"User Commands\"\n"
      ".SH NAME\ngyrosim \\- rock breakage in gyratory crushers\n"
      ".SH SYNOPSIS\n.B gyrosim\n.I command\n[options]\n"
      ".SH DESCRIPTION\n"
      "gyrosim computes how rock breaks in a gyratory crusher and what that does to the machine.\n"
      "Rock is spheres joined by breakable bonds, the liners are profiles or meshes, and the mantle is\n"
      "driven by a motor, a gear and an eccentric that slow down as the rock resists.\n"
      "A case is a YAML file; \\fBgyrosim describe\\fR documents its keys, and \\fBgyrosim init\\fR prints\n"
      "a case to start from. Results are HDF5 and VTK files.\n"
      "Quantities on the command line are plain SI numbers or have a unit, as in \"20 ms\".\n"
      ".SH OPTIONS\n";
  for (const OptionText& o : program.options) text += option_entry(o);
  text += ".SH COMMANDS\n";
  for (const CommandText& command : program.commands) text += command_entry(command, "gyrosim");
  return text + ".SH EXIT STATUS\n" + exit_codes();
}

}  // namespace gyro

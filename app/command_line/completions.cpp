// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/pages.hpp"

#include <functional>

namespace gyro {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Calls `visit` for the program and every command, with the words that lead there: "", "run", "export fmu".
void for_each_command(const CommandText& command, const std::string& words,
                      const std::function<void(const CommandText&, const std::string&)>& visit) {
  visit(command, words);
  for (const CommandText& below : command.commands)
    for_each_command(below, words.empty() ? below.name : words + " " + below.name, visit);
}

/// A word of a shell's script within single quotes.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// Text in an entry of zsh's _arguments or _describe, where brackets and colons separate.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

/// What may stand at an argument: one of its choices or a file.
std::string zsh_values(const OptionText& o) {
  return o.choices.empty() ? "_files" : "(" + joined(o.choices, " ") + ")";
}

std::string zsh_entry(const OptionText& o) {
  if (o.positional) return quoted(":" + zsh_text(o.name) + ":" + zsh_values(o));
  std::string entry = "*" + o.name + "[" + zsh_text(o.description) + "]";
  if (o.takes_value) entry += ":" + zsh_text(o.value) + ":" + zsh_values(o);
  return quoted(entry);
}

/// A function that completes the words behind a command, which zsh has as $words[1].
void add_zsh_function(const CommandText& command, const std::string& words, std::string& text) {
  std::string name = "_gyrosim" + (words.empty() ? "" : " " + words);
  for (char& c : name)
    if (c == ' ') c = '_';
  text += name + (words.empty() ? "_command" : "") + "() {\n";
  if (command.commands.empty()) {
    text += "  _arguments -S";
    for (const OptionText& o : command.options) text += " \\\n    " + zsh_entry(o);
    text += "\n}\n";
    return;
  }
  text += "  local -a commands=(\n";
  for (const CommandText& below : command.commands)
    text += "    " + quoted(below.name + ":" + zsh_text(below.description)) + "\n";
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    _arguments";
  for (const OptionText& o : command.options) text += " \\\n      " + zsh_entry(o);
  text +=
      "\n    return\n  fi\n  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
      "  (( $+functions[" +
      name + "_$command] )) && " + name + "_$command\n}\n";
}

}  // namespace

std::string bash_completion(const CommandText& program) {
  std::string known, values, words;
  for_each_command(program, "", [&](const CommandText& command, const std::string& name) {
    if (!name.empty()) known += (known.empty() ? "" : " | ") + quoted(name);
    std::vector<std::string> below, options;
    for (const CommandText& c : command.commands) below.push_back(c.name);
    for (const OptionText& o : command.options) {
      if (!o.positional) options.push_back(o.name);
      if (!o.positional && o.takes_value)
        values += "    " + quoted(name + " " + o.name) + ") words=" + quoted(joined(o.choices, " ")) + " ;;\n";
    }
    words += "    " + quoted(name) + ") words=" + quoted(joined(below, " ")) +
             " options=" + quoted(joined(options, " ")) + " ;;\n";
  });
  return "# Completion of gyrosim for bash, written from the command line's own description when gyrosim was built.\n"
         "_gyrosim() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} command='' word words='' options=''\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \"${command:+$command }$word\" in\n"
         "    " +
         known +
         ") command=${command:+$command }$word ;;\n"
         "    esac\n"
         "  done\n"
         "  case \"$command ${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
         values +
         "    *)\n"
         "    case \"$command\" in\n" +
         words +
         "    esac\n"
         "    if [[ $current == -* ]]; then words=$options; fi ;;\n"
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o default -F _gyrosim gyrosim  # files where nothing else fits\n";
}

std::string zsh_completion(const CommandText& program) {
  std::string text =
      "#compdef gyrosim\n"
      "# Written from the command line's own description when gyrosim was built.\n";
  for_each_command(program, "", [&](const CommandText& command, const std::string& words) {
    add_zsh_function(command, words, text);
  });
  return text + "_gyrosim_command \"$@\"\n";
}

}  // namespace gyro

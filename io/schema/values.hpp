// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/schema/schema.hpp"

namespace gyro {

/// Reads single values and lists according to their keys, and reports their problems.
class ValueReader {
 public:
  explicit ValueReader(std::vector<MarkedProblem>& problems) : problems_(problems) {}

  /// Reads a key's value into setting; reports a value that does not fit the key and returns false.
  /// The key must not be a section.
  /// @param path  of the value in the file, for messages
  bool read(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);

  bool read_word(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  /// Reports a value of the wrong form, such as a list instead of a map; returns false.
  bool wrong_form(const Key& key, const YamlNode& node, const std::string& path);
  void problem(Mark mark, std::string message) { problems_.push_back({mark, std::move(message)}); }

 private:
  bool read_text(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool read_number(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool read_numbers(Setting& setting, const Key& key, const YamlNode& node, const std::string& path, std::size_t count);
  bool read_interval(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool read_quantities(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool read_integers(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool read_texts(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool read_passing(Setting& setting, const Key& key, const YamlNode& node, const std::string& path);
  bool wrong_count(const Key& key, const YamlNode& node, const std::string& path);

  std::vector<MarkedProblem>& problems_;
};

/// What the value of a key looks like, as a phrase after "give" or "use": "a whole number", "a list of paths".
std::string form_of(const Key& key);

/// Names of the keys directly below a section: "a, b or c"
std::string names_below(std::string_view section);

/// Words as a choice: "a, b or c"
std::string choice(const std::vector<std::string_view>& words);

std::string in_quotes(std::string_view text);

}  // namespace gyro

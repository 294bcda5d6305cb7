// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/case/parts.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// Reads single values of a sweep file and reports what is wrong with them.
class MapReader {
 public:
  explicit MapReader(CaseProblems& problems) : problems_(problems) {}

  void problem(const Mark& mark, std::string message) { problems_.add(mark, std::move(message)); }

  /// Reports the keys of a map that are not among `names`. @param where  " in slurm"; empty at the top
  void refuse_unknown(const YamlNode& map, const std::vector<std::string_view>& names, const std::string& where);

  /// Entry of a map if it is there and not empty; an empty one is reported. @param form  what to give, "a list of ..."
  const YamlEntry* given(const YamlNode& map, std::string_view key, std::string_view form);

  /// Whether a value has the kind; otherwise reports it.
  bool has_kind(const YamlEntry& entry, YamlNode::Kind kind, std::string_view form);

  /// A text on one line.
  std::string text(const YamlNode& map, std::string_view key, std::string_view form);

  /// A whole number within limits.
  std::optional<std::int64_t> integer(const YamlNode& node, const std::string& name, std::int64_t low,
                                      std::int64_t high);

  /// A key of the case as `vary` and `set` name it. @returns false, with a problem, for a text that is none
  bool case_key(const std::string& key, const Mark& mark);

 private:
  CaseProblems& problems_;
};

}  // namespace gyro

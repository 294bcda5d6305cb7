// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// A place in the input. Lines and columns are counted from 1.
struct Mark {
  int source = 0;  ///< 0: the case file; k: the k-th override
  int line = 1;
  int column = 1;
};

/// A problem at a place. The message has the form "problem; what to do".
struct MarkedProblem {
  Mark mark = {};
  std::string message;
};

struct YamlEntry;

/// A YAML node with its place: null, the text of a scalar, a list, or a map in the order of the file.
struct YamlNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  Mark mark = {};
  std::string text = {};                ///< of a scalar
  std::vector<YamlNode> items = {};     ///< of a list
  std::vector<YamlEntry> entries = {};  ///< of a map; keys are unique

  YamlEntry* find(std::string_view key);  ///< entry of a map; null if there is no such key
  const YamlEntry* find(std::string_view key) const;
};

/// A key of a map and its value.
struct YamlEntry {
  std::string key;
  Mark mark;  ///< of the key
  YamlNode value;
};

/// One YAML document, and its problems: syntax errors, and what a case file may not contain: duplicate keys, merge
/// keys, anchors, aliases, tags, a second document, text that is not UTF-8.
struct YamlDocument {
  YamlNode root;
  std::vector<MarkedProblem> problems;
};

/// Parses a text. Bad text becomes a problem and is never thrown. A byte-order mark of UTF-8 is skipped.
/// @param first  place where the text begins; all places of the result are relative to it
YamlDocument parse_yaml(std::string_view text, Mark first = {});

}  // namespace gyro

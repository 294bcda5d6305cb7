// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/yaml/units.hpp"
#include "io/yaml/yaml_tree.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

// One table of all keys of the case file. It drives reading, checking, defaults, the resolved case,
// `gyrosim describe` and the JSON Schema; a new key is one line in keys.cpp,
// a member of io/case/case.hpp and its use in io/case/build.cpp.

namespace gyro {

/// What the value of a key looks like.
enum class KeyType {
  section,   ///< map of known keys
  named,     ///< map of names the user chooses
  quantity,  ///< number, or text with a unit
  integer,
  text,
  word,        ///< one of a list of words
  file,        ///< path, relative to the case file
  vector,      ///< list of three quantities
  interval,    ///< list of two quantities, the second larger
  quantities,  ///< list of at least two quantities, increasing
  integers,    ///< list of whole numbers, not empty, each once
  words,       ///< list of words, not empty
  files,       ///< list of paths, not empty
  passing,     ///< list of pairs [size, passing]
  values,      ///< map of names the user chooses to plain numbers or truth values
};

/// Limits of a number, in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool holds(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};

/// No length of a crusher is longer: a larger one is a mistake in the unit [m]. Keys with an upper limit have that one.
constexpr double longest_length = 1000;

/// A key of the case file.
struct Key {
  std::string_view path;  ///< `bonds.radius.relative`; `<name>` stands for a name the user chooses
  KeyType type = KeyType::section;
  Dimension dimension = Dimension::number;
  bool required = false;           ///< in its section
  bool defaulted = false;          ///< a section that is always there, with its keys' defaults
  std::string_view fallback = {};  ///< default as YAML text; empty: none
  Range range = {};
  std::string_view words = {};  ///< `a|b`: words that may stand here; for quantities and sections beside their own form
  /// `model=droop|curve`: only where the neighbour key says so, and required there; `fmu`: only beside that key;
  /// `!fmu`: only without it.
  std::string_view when = {};
  std::string_view one_of = {};  ///< `a+b|c`: exactly one of these groups of keys, of a section
  std::string_view doc = {};

  std::string_view name() const;    ///< last part of the path
  std::string_view parent() const;  ///< path without the last part
};

/// Every key, sections before their keys, in the order in which a case is written.
const std::vector<Key>& schema_keys();

/// Keys directly below a section ("" for the file itself).
std::vector<const Key*> keys_below(std::string_view section);

/// Key of a path of the table, or null.
const Key* find_key(std::string_view path);

/// Key that a path of a case file, `materials.rock.density`, stands for, or null.
const Key* match_key(std::string_view path);

/// Parts of `a|b` or `a.b`.
std::vector<std::string_view> split(std::string_view text, char separator);

/// "> 0", "between 0 and 1", "> 0 m and <= 2 m"; empty for no limits.
std::string range_text(const Range& range, Dimension dimension);

/// Shortest text that reads back to the same double, as every YAML reader takes it: 1.0e-3, not 1e-3.
std::string number_text(double value);

/// The candidate that a misspelt word most likely means, or empty.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

/// A checked value of the case: what the file or the table's default says, in SI.
struct Setting {
  const Key* key = nullptr;
  std::string name = {};  ///< last part of its path in the file
  Mark mark = {};         ///< of the value; of the section for a default
  bool given = false;     ///< not a default
  std::vector<double> numbers =
      {};  ///< quantity: 1; vector: 3; interval: 2; integers; passing: size, share, size, share ...
  std::vector<std::string> texts = {};  ///< text, word, file: 1; words, files; a word beside a quantity
  std::vector<Mark> item_marks = {};    ///< of the items of a list
  std::vector<Setting> children = {};   ///< of a section
  std::vector<std::string> lost = {};   ///< keys of a section that are given but cannot be used, or are misspelt

  /// The setting at a path below this one, `radius.relative`; null where there is none.
  const Setting* find(std::string_view path) const;
  /// Whether the file does not mention this key of the section at all.
  bool lacks(std::string_view child) const;
  /// First number or text of the setting at a path. @throws std::logic_error where there is none
  double number(std::string_view path) const { return needed(path).numbers.at(0); }
  const std::string& text(std::string_view path) const { return needed(path).texts.at(0); }

 private:
  const Setting& needed(std::string_view path) const;
};

/// Checks a document against the table and fills in defaults. Problems are added in the order of the
/// document; wrong settings are left out of the result.
Setting read_settings(const YamlNode& root, std::vector<MarkedProblem>& problems);

/// The settings as YAML: SI numbers, all defaults, in the table's order.
std::string write_settings(const Setting& root);

}  // namespace gyro

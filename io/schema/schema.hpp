// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/yaml/units.hpp"
#include "io/yaml/yaml_tree.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

// One table of all keys of the case file. Reading, checking, defaults, the resolved case, `gyrosim describe` and the
// JSON Schema follow from it. A new key needs one line in keys.cpp, a member in io/case/case.hpp and its use in
// io/case/build.cpp.

namespace gyro {

/// What the value of a key looks like.
enum class KeyType {
  section,   ///< map of known keys
  named,     ///< map of sections whose names the user chooses
  quantity,  ///< number, or text with a unit
  integer,
  text,
  word,        ///< one of a list of words
  file,        ///< path, relative to the case file
  vector,      ///< list of three quantities
  interval,    ///< list of two quantities, the second larger
  quantities,  ///< list of at least two quantities, increasing
  integers,    ///< list of distinct whole numbers, not empty
  words,       ///< list of words, not empty
  files,       ///< list of paths, not empty
  passing,     ///< list of pairs [size, passing]
  values,      ///< map from names the user chooses to plain numbers or truth values
};

/// Limits of a number, in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool holds(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};

/// Upper limit of all lengths whose key has no upper limit of its own [m]. A longer one is a mistake in the unit.
constexpr double longest_length = 1000;

/// A key of the case file.
struct Key {
  std::string_view path;  ///< `bonds.radius.relative`; `<name>` stands for a name the user chooses
  KeyType type = KeyType::section;
  Dimension dimension = Dimension::number;
  bool required = false;           ///< in its section
  bool defaulted = false;          ///< a section that always exists, with the defaults of its keys
  std::string_view fallback = {};  ///< default as YAML text; empty: none
  Range range = {};
  std::string_view words = {};  ///< `a|b`: words that are allowed; for quantities and sections beside their own form
  /// Condition on another key of the section. `model=droop|curve`: allowed only if `model` is one of these words, and
  /// then required unless it has a default; `fmu`: allowed only together with `fmu`; `!fmu`: allowed only without
  /// `fmu`.
  std::string_view when = {};
  std::string_view one_of = {};  ///< `a+b|c`: groups of keys of which the section must have exactly one
  std::string_view doc = {};

  std::string_view name() const;    ///< last part of the path
  std::string_view parent() const;  ///< path without the last part
};

/// Every key, sections before their keys, in the order in which a case is written.
const std::vector<Key>& schema_keys();

/// Keys directly below a section ("" for the file itself).
std::vector<const Key*> keys_below(std::string_view section);

/// Key with a path of the table, such as `materials.<name>.density`, or null.
const Key* find_key(std::string_view path);

/// Key of a path in a case file, such as `materials.rock.density`, or null.
const Key* match_key(std::string_view path);

/// Parts of a text such as `a|b` or `a.b`.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Text such as "> 0", "between 0 and 1" or "> 0 and <= 2 m"; empty if there are no limits.
std::string range_text(const Range& range, Dimension dimension);

/// Shortest text that reads back to the same double and that every YAML reader accepts as a number: 1.0e-09, not 1e-09.
std::string number_text(double value);

/// The candidate that a misspelt word most likely means, or empty.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

/// A checked value of the case in SI, from the file or from the default of the table.
struct Setting {
  const Key* key = nullptr;
  std::string name = {};  ///< last part of its path in the file
  Mark mark = {};         ///< place of the value; for a default, place of the section
  bool given = false;     ///< not a default
  std::vector<double> numbers =
      {};  ///< quantity: 1; vector: 3; interval: 2; integers; passing: size, share, size, share ...
  std::vector<std::string> texts = {};  ///< text, word, file: 1; words, files; a word beside a quantity
  std::vector<Mark> item_marks = {};    ///< of the items of a list
  std::vector<Setting> children = {};   ///< of a section
  std::vector<std::string> lost = {};   ///< keys of a section that are given but cannot be used, or are misspelt

  /// The setting at a path below this one, such as `radius.relative`; null if there is none.
  const Setting* find(std::string_view path) const;
  /// Whether the file does not mention this key of the section at all.
  bool lacks(std::string_view child) const;
  /// First number or text of the setting at a path. @throws std::logic_error if there is no such setting
  double number(std::string_view path) const { return needed(path).numbers.at(0); }
  const std::string& text(std::string_view path) const { return needed(path).texts.at(0); }

 private:
  const Setting& needed(std::string_view path) const;
};

/// Checks a document against the table and fills in defaults. Problems are appended; settings with problems are left
/// out of the result.
Setting read_settings(const YamlNode& root, std::vector<MarkedProblem>& problems);

/// The settings as YAML, in the order of the table, with SI numbers and all defaults.
std::string write_settings(const Setting& root);

}  // namespace gyro

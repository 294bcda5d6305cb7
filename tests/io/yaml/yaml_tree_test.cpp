// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/yaml/yaml_tree.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <ctime>

using gyro::parse_yaml;
using gyro::YamlDocument;
using Kind = gyro::YamlNode::Kind;

TEST_CASE("A document becomes a tree with lines and columns from 1") {
  const YamlDocument document = parse_yaml("# first\na: {b: [1, x y]}\nc:\n  d: 'two words'\n  e: ~\n");
  REQUIRE(document.problems.empty());
  const auto& root = document.root;
  REQUIRE(root.kind == Kind::map);
  REQUIRE(root.entries.size() == 2);
  const auto& b = root.entries[0].value.entries.at(0);
  CHECK((b.mark.line == 2 && b.mark.column == 5));
  REQUIRE(b.value.kind == Kind::list);
  CHECK(b.value.items.at(1).text == "x y");
  CHECK((b.value.items[1].mark.line == 2 && b.value.items[1].mark.column == 12));
  const gyro::YamlNode& c = root.entries[1].value;
  CHECK(c.find("d")->value.text == "two words");
  CHECK(c.find("e")->value.kind == Kind::null);
  CHECK(c.find("f") == nullptr);
}

TEST_CASE("A text inside a longer line keeps its column") {
  const YamlDocument document = parse_yaml("{a: 1, a: 2}", {3, 3, 10});
  REQUIRE(document.problems.size() == 1);
  CHECK(document.problems[0].mark.source == 3);
  CHECK(document.problems[0].mark.line == 3);
  CHECK(document.problems[0].mark.column == 17);
}

TEST_CASE("Very deep nesting is refused") {
  std::string indents;
  for (int k = 0; k < 500; ++k) indents += std::string(static_cast<std::size_t>(k), ' ') + "a:\n";
  std::string dashes;
  for (int k = 0; k < 100000; ++k) dashes += "- ";
  for (const std::string& text : {std::string(200000, '['), std::string(200000, '{'), indents, dashes}) {
    const YamlDocument document = parse_yaml(text);
    REQUIRE(document.problems.size() == 1);
    CHECK(document.problems[0].message == "nested too deeply; use at most 64 levels");
  }
}

TEST_CASE("Text that is not UTF-8 is refused at its first invalid byte") {
  for (const std::string& bad : {std::string("\xB5"), std::string("\xC0\xAF"), std::string("\xED\xA0\x80"),
                                 std::string("\xF5\x80\x80\x80"), std::string("\xE2\x82"), std::string(1, '\0')}) {
    const YamlDocument document = parse_yaml("a: 1\nb: " + bad + "\n");
    REQUIRE(document.problems.size() == 1);
    CHECK((document.problems[0].mark.line == 2 && document.problems[0].mark.column == 4));
  }
  CHECK(parse_yaml("a: \u00b5m \u20ac \U0001F600\n").problems.empty());
}

TEST_CASE("Parsing damaged text never throws") {
  // Every prefix of a case, and every case with one byte replaced.
  const std::string text =
      "time: {duration: 2 s, step: auto}\nwalls:\n  a: {plane: {point: [0, 0, 1]}, material: 'x'}\n";
  for (std::size_t k = 0; k < text.size(); ++k) CHECK_NOTHROW(parse_yaml(text.substr(0, k)));
  for (std::size_t k = 0; k < text.size(); ++k)
    for (const char c :
         {'[', ']', '{', '}', ':', '&', '*', '!', '\t', '\n', '"', '\'', '%', '@', '-', '?', '|', '\xff'}) {
      std::string spoilt = text;
      spoilt[k] = c;
      CHECK_NOTHROW(parse_yaml(spoilt));
    }
}

TEST_CASE("The time to read keys grows with their number, not with its square") {
  std::string text;
  for (int k = 0; k < 100000; ++k) text += "key" + std::to_string(k) + ": 1\n";
  const auto seconds = [](std::string_view part) {
    double quickest = 1e300;
    for (int attempt = 0; attempt < 3; ++attempt) {
      const std::clock_t begin = std::clock();
      CHECK(gyro::parse_yaml(part).problems.empty());
      quickest = std::min(quickest, double(std::clock() - begin));
    }
    return quickest;
  };
  // The part has a twentieth of the keys: if the time grew with the square, the whole would take 400 times as long.
  CHECK(seconds(text) < 80 * seconds(text.substr(0, text.find("key5000:"))));
  CHECK(gyro::parse_yaml(text + "key7: 2\n").problems.size() == 1);
}

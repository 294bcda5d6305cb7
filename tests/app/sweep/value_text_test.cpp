// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/value_text.hpp"

#include "app/sweep/shell_text.hpp"
#include "tests/catch.hpp"

namespace {

using namespace gyro;

std::string round_trip(const std::string& yaml) {
  return value_text(parse_yaml(yaml).root);
}

}  // namespace

TEST_CASE("Values of a sweep become YAML on one line that reads back to the same value") {
  CHECK(round_trip("0.5") == "0.5");
  CHECK(round_trip("\"90 mm\"") == "90 mm");
  CHECK(round_trip("null") == "null");
  CHECK(round_trip("\"null\"") == "\"null\"");
  CHECK(round_trip("[1, [2, a b]]") == "[1, [2, a b]]");
  CHECK(round_trip("{a: {b: 1}, c: [x]}") == "{a: {b: 1}, c: [x]}");
  for (const std::string text : {"a: b", "x, y", "[1]", "#", "- x", "\"q\"", "a\nb", "%", "~", "", " x", "'"}) {
    YamlNode node{.kind = YamlNode::Kind::scalar};
    node.text = text;
    const YamlDocument back = parse_yaml(value_text(node));
    INFO(text);
    CHECK(back.problems.empty());
    CHECK(back.root.kind == YamlNode::Kind::scalar);
    CHECK(back.root.text == text);
  }
}

TEST_CASE("Words for a shell are quoted where they need it") {
  CHECK(shell_line({"run", "a=0.5"}) == "run a=0.5");
  CHECK(shell_word("90 mm") == "'90 mm'");
  CHECK(shell_word("it's $x") == "'it'\\''s $x'");
  CHECK(shell_word("") == "''");
}

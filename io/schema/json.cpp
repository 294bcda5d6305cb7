// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/describe.hpp"
#include "io/schema/schema.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace gyro {
namespace {

using Json = nlohmann::ordered_json;

Json words_schema(std::string_view words) {
  Json schema = {{"enum", Json::array()}};
  for (const std::string_view word : split(words, '|')) schema["enum"].push_back(word);
  return schema;
}

void add_range(Json& schema, const Range& range) {
  if (std::isfinite(range.low)) schema[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) schema[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
}

/// Regular expression for a number with or without a unit of the dimension.
std::string quantity_pattern(Dimension dimension) {
  std::string names;
  for (const Unit& unit : units()) {
    if (unit.dimension != dimension || unit.name == "1") continue;
    names += names.empty() ? "" : "|";
    for (const char c : unit.name) names += c == ' ' ? std::string("[ *]") : std::string(1, c);
  }
  return "^[ ]*[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]+)?[ ]*(" + names + ")?[ ]*$";
}

/// A number in SI within its limits, or a text with a unit. Only the program checks the limits of the latter.
Json quantity_schema(const Key& key) {
  Json number = {{"type", "number"}};
  add_range(number, key.range);
  Json schema = {{"anyOf", {number, {{"type", "string"}, {"pattern", quantity_pattern(key.dimension)}}}}};
  if (!key.words.empty()) schema["anyOf"].push_back(words_schema(key.words));
  return schema;
}

Json list_schema(const Json& item, int minimum, int maximum) {
  Json schema = {{"type", "array"}, {"items", item}, {"minItems", minimum}};
  if (maximum > 0) schema["maxItems"] = maximum;
  return schema;
}

Json section_schema(std::string_view pattern, std::string_view one_of);

Json value_schema(const Key& key) {
  const Json text = {{"type", "string"}, {"minLength", 1}};
  switch (key.type) {
    case KeyType::section: {
      const Json map = section_schema(key.path, key.one_of);
      return key.words.empty() ? map : Json{{"anyOf", {words_schema(key.words), map}}};
    }
    case KeyType::named: {
      const bool pairs = key.path == "contacts";
      const std::string name = "[A-Za-z_][A-Za-z0-9_-]*";
      return {{"type", "object"},
              {"propertyNames", {{"pattern", "^" + name + (pairs ? "/" + name : "") + "$"}}},
              {"additionalProperties", section_schema(std::string(key.path) + (pairs ? ".<pair>" : ".<name>"), {})}};
    }
    case KeyType::values:
      return {{"type", "object"}, {"additionalProperties", {{"type", {"number", "boolean"}}}}};
    case KeyType::quantity:
      return quantity_schema(key);
    case KeyType::integer: {
      Json schema = {{"type", "integer"}};
      add_range(schema, key.range);
      return schema;
    }
    case KeyType::word:
      return words_schema(key.words);
    case KeyType::vector:
      return list_schema(quantity_schema(key), 3, 3);
    case KeyType::interval:
      return list_schema(quantity_schema(key), 2, 2);
    case KeyType::quantities:
      return list_schema(quantity_schema(key), 2, 0);
    case KeyType::integers: {
      Json item = {{"type", "integer"}};
      add_range(item, key.range);
      return list_schema(item, 1, 0);
    }
    case KeyType::words:
      return list_schema(words_schema(key.words), 1, 0);
    case KeyType::files:
      return list_schema(text, 1, 0);
    case KeyType::passing: {
      const Key share{.path = "share", .type = KeyType::quantity, .range = {.low = 0, .high = 1}};
      const Json pair = {{"type", "array"},
                         {"items", {quantity_schema(key), quantity_schema(share)}},
                         {"minItems", 2},
                         {"maxItems", 2}};
      return list_schema(pair, 2, 0);
    }
    case KeyType::text:
      return {{"type", {"string", "number", "boolean"}}};
    case KeyType::file:
      return text;
  }
  return {};
}

/// Condition of a key that is allowed only together with another key, or only without it.
Json neighbour_schema(const Key& key) {
  const bool wanted = !key.when.starts_with('!');
  const Json neighbour = {{"required", Json::array({std::string(key.when.substr(wanted ? 0 : 1))})}};
  const Json there = {{"required", Json::array({std::string(key.name())})}}, barred = {{"not", there}};
  const Json allowed = key.required ? there : Json::object();
  return {{"if", neighbour}, {"then", wanted ? allowed : barred}, {"else", wanted ? barred : allowed}};
}

Json section_schema(std::string_view pattern, std::string_view one_of) {
  Json properties = Json::object(), required = Json::array(), cases = Json::array();
  for (const Key* key : keys_below(pattern)) {
    const std::string name(key->name());
    properties[name] = value_schema(*key);
    properties[name]["description"] = key->doc;
    if (!key->fallback.empty()) properties[name]["default"] = key->fallback;
    if (key->required && key->when.empty()) required.push_back(name);
    if (key->when.empty()) continue;
    const std::size_t equals = key->when.find('=');
    if (equals == std::string_view::npos) {
      cases.push_back(neighbour_schema(*key));
      continue;
    }
    const std::string neighbour(key->when.substr(0, equals));
    const Json there = {{"required", Json::array({name})}};
    cases.push_back({{"if",
                      {{"properties", {{neighbour, words_schema(key->when.substr(equals + 1))}}},
                       {"required", Json::array({neighbour})}}},
                     {"then", key->fallback.empty() ? there : Json::object()},
                     {"else", {{"not", there}}}});
  }
  Json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  if (!cases.empty()) schema["allOf"] = cases;
  for (const std::string_view group : split(one_of, '|')) schema["oneOf"].push_back({{"required", split(group, '+')}});
  return schema;
}

}  // namespace

std::string json_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Case of gyrosim"}};
  schema.update(section_schema("", {}));
  return schema.dump(2) + "\n";
}

}  // namespace gyro

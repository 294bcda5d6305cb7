// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/case_facts.hpp"

#include "core/base/errors.hpp"
#include "io/case/case.hpp"
#include "io/yaml/yaml_tree.hpp"

#include <cstdlib>
#include <initializer_list>
#include <string_view>

namespace gyro::report {
namespace {

/// The node at a path of keys; null if there is none.
const YamlNode* at(const YamlNode& root, std::initializer_list<std::string_view> path) {
  const YamlNode* node = &root;
  for (const std::string_view key : path) {
    const YamlEntry* entry = node->kind == YamlNode::Kind::map ? node->find(key) : nullptr;
    if (!entry) return nullptr;
    node = &entry->value;
  }
  return node;
}

std::optional<double> number_at(const YamlNode& root, std::initializer_list<std::string_view> path) {
  const YamlNode* node = at(root, path);
  if (!node || node->kind != YamlNode::Kind::scalar) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(node->text.c_str(), &end);
  return end == node->text.c_str() ? std::nullopt : std::optional(value);
}

std::optional<SizeLaw> passing_table(const YamlNode& points) {
  PassingTable table;
  for (const YamlNode& point : points.items)
    if (point.items.size() == 2)
      table.points.push_back(
          {std::strtod(point.items[0].text.c_str(), nullptr), std::strtod(point.items[1].text.c_str(), nullptr)});
  return table.points.size() < 2 ? std::nullopt : std::optional<SizeLaw>(table);
}

/// The law of rocks.sizes. @returns nothing where its file of sieves is gone
std::optional<SizeLaw> feed_law(const YamlNode& root, const std::filesystem::path& file) {
  const YamlNode* sizes = at(root, {"rocks", "sizes"});
  if (!sizes) return std::nullopt;
  const auto number = [&](std::initializer_list<std::string_view> path) { return number_at(*sizes, path).value_or(0); };
  if (const YamlNode* points = at(*sizes, {"passing"})) return passing_table(*points);
  if (at(*sizes, {"rosin_rammler"}))
    return RosinRammler{number({"rosin_rammler", "x63"}), number({"rosin_rammler", "m"}),
                        number({"rosin_rammler", "min"}), number({"rosin_rammler", "max"})};
  if (at(*sizes, {"gates_gaudin_schuhmann"}))
    return GatesGaudinSchuhmann{number({"gates_gaudin_schuhmann", "xmax"}), number({"gates_gaudin_schuhmann", "m"}),
                                number({"gates_gaudin_schuhmann", "min"})};
  if (at(*sizes, {"vendor"})) return vendor_feed(number({"vendor", "feed_opening"}), number({"vendor", "min"}));
  const CaseReport report = load_case(file, {});
  if (report.loaded && report.loaded->rocks) return report.loaded->rocks->sizes;
  return std::nullopt;
}

void read_wall_friction(const YamlNode& root, CaseFacts& facts) {
  const YamlNode* walls = at(root, {"walls"});
  if (!walls) return;
  for (const YamlEntry& wall : walls->entries) {
    const YamlNode* material = at(wall.value, {"material"});
    if (!material) continue;
    for (const std::string& pair : {"rock/" + material->text, material->text + "/rock"})
      if (const auto friction = number_at(root, {"contacts", pair, "friction"}))
        facts.wall_friction[wall.key] = *friction;
  }
}

}  // namespace

CaseFacts case_facts(const std::string& yaml, const std::filesystem::path& file) {
  const YamlNode root = parse_yaml(yaml).root;
  CaseFacts facts;
  facts.closed_setting = number_at(root, {"crusher", "closed_side_setting"});
  if (const auto eccentricity = number_at(root, {"crusher", "eccentricity"}); eccentricity && facts.closed_setting)
    facts.open_setting = *facts.closed_setting + 2 * *eccentricity;
  try {
    facts.feed = feed_law(root, file);
    if (facts.feed) SizeDistribution{*facts.feed};  // a law that it refuses has no curve
  } catch (const BadInput&) {
    facts.feed.reset();
  }
  facts.wear_coefficient = number_at(root, {"output", "liners", "wear_coefficient"});
  read_wall_friction(root, facts);
  return facts;
}

}  // namespace gyro::report

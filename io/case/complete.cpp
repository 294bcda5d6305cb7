// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/parts.hpp"

#include <algorithm>

namespace gyro {
namespace {

namespace fs = std::filesystem;

Setting* find_child(Setting& section, std::string_view name) {
  for (Setting& child : section.children)
    if (child.name == name) return &child;
  return nullptr;
}

/// Adds a setting to a section, at its place in the order of the table of keys.
Setting& add_child(Setting& section, const Key& key, const std::string& name, Mark mark) {
  Setting made{.key = &key, .name = name, .mark = mark};
  auto at = section.children.end();
  if (section.key == nullptr || section.key->type != KeyType::named)
    at = std::find_if(section.children.begin(), section.children.end(),
                      [&](const Setting& child) { return child.key > &key; });
  return *section.children.insert(at, std::move(made));
}

void add_text(Setting& section, std::string_view path, const std::string& text, Mark mark) {
  const Key& key = *find_key(path);
  add_child(section, key, std::string(key.name()), mark).texts = {text};
}

void add_number(Setting& section, std::string_view path, double number) {
  const Key& key = *find_key(path);
  add_child(section, key, std::string(key.name()), section.mark).numbers = {number};
}

void resolve_paths(Setting& setting, const fs::path& folder, CaseProblems& problems) {
  for (Setting& child : setting.children) resolve_paths(child, folder, problems);
  if (setting.key == nullptr || (setting.key->type != KeyType::file && setting.key->type != KeyType::files)) return;
  for (std::size_t k = 0; k < setting.texts.size(); ++k) {
    const Mark mark = k < setting.item_marks.size() ? setting.item_marks[k] : setting.mark;
    fs::path path = (folder / setting.texts[k]).lexically_normal();
    std::error_code error;
    if (setting.key->path == "feed.initial_from" && fs::is_directory(path, error)) {  // of a run
      path = (path / "checkpoint.h5").lexically_normal();
      if (!fs::exists(path, error)) {
        problems.add(mark, setting.name + ": \"" + setting.texts[k] +
                               "\" is a directory without checkpoint.h5; give the directory of a run that wrote one");
        continue;
      }
    }
    const fs::file_status status = fs::status(path, error);
    const std::string name = setting.name + ": \"" + setting.texts[k] + "\"";
    if (!fs::exists(status))
      problems.add(mark, name + " does not exist (" + path.string() + "); give the path of a file");
    else if (fs::is_directory(status))
      problems.add(mark, name + " is a directory; give the path of a file");
    else if (!fs::is_regular_file(status))  // it is read more than once
      problems.add(mark, name + " is a pipe or a device; give the path of a file");
    setting.texts[k] = path.string();
  }
}

/// The floor of the fill for numerics.fidelity: survey, unless the case has its own.
void add_floor(Setting& root, Setting& fill) {
  const Setting *fidelity = root.find("numerics.fidelity"), *setting = root.find("crusher.closed_side_setting");
  if (fidelity == nullptr || fidelity->texts.empty() || fidelity->texts[0] != "survey") return;
  if (setting == nullptr || setting->numbers.empty() || fill.lacks("ratio") || !fill.lacks("floor")) return;
  add_number(fill, "rocks.fill.floor", setting->numbers[0] / 6);
}

/// Adds the liners of a profile as walls if the case does not name them.
void add_liners(Setting& root, const Setting& profile) {
  Setting* walls = find_child(root, "walls");
  if (walls == nullptr) walls = &add_child(root, *find_key("walls"), "walls", profile.mark);
  for (const char* name : {"concave", "mantle"}) {
    if (find_child(*walls, name) != nullptr) continue;
    Setting& liner = add_child(*walls, *find_key("walls"), name, profile.mark);
    add_text(liner, "walls.<name>.material", "steel", profile.mark);
  }
}

void add_motions(Setting& walls, bool profile) {
  for (Setting& wall : walls.children) {
    if (find_child(wall, "motion") != nullptr) continue;
    const bool turns = profile && wall.name == "mantle";
    add_text(wall, "walls.<name>.motion", turns ? "gyration" : "fixed", wall.mark);
  }
}

}  // namespace

void complete_settings(Setting& root, const fs::path& case_file, CaseProblems& problems) {
  std::error_code error;
  const fs::path absolute = fs::absolute(case_file, error);
  resolve_paths(root, absolute.parent_path(), problems);
  complete_intervals(root);

  if (Setting* identity = find_child(root, "case"); identity != nullptr && find_child(*identity, "title") == nullptr)
    add_text(*identity, "case.title", absolute.stem().string(), identity->mark);

  // A copy, because adding walls moves the settings of the root in memory.
  const Setting* found = root.find("crusher.profile");
  const std::optional<Setting> profile = found == nullptr ? std::nullopt : std::optional<Setting>(*found);
  if (profile) add_liners(root, *profile);
  Setting* walls = find_child(root, "walls");
  if (walls != nullptr) add_motions(*walls, profile.has_value());

  Setting* rocks = find_child(root, "rocks");
  Setting* fill = rocks == nullptr ? nullptr : find_child(*rocks, "fill");
  if (fill != nullptr && find_child(*fill, "sizes") != nullptr && fill->lacks("exponent"))
    add_number(*fill, "rocks.fill.exponent", RangeFill{}.exponent);
  if (fill != nullptr) add_floor(root, *fill);

  Setting* feed = find_child(root, "feed");
  if (feed != nullptr && find_child(*feed, "above") == nullptr && find_child(*feed, "rocks") == nullptr &&
      walls != nullptr && find_child(*walls, "concave") != nullptr)
    add_text(*feed, "feed.above", "concave", feed->mark);
}

}  // namespace gyro

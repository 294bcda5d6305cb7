// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/values.hpp"

#include <algorithm>
#include <cctype>

namespace gyro {
namespace {

using Kind = YamlNode::Kind;

bool is_name(std::string_view text) {
  const auto begins = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
  const auto continues = [&](unsigned char c) { return begins(c) || std::isdigit(c) || c == '-'; };
  return !text.empty() && begins(text[0]) && std::all_of(text.begin(), text.end(), continues);
}

bool is_pair(std::string_view text) {
  const std::size_t slash = text.find('/');
  return slash != std::string_view::npos && is_name(text.substr(0, slash)) && is_name(text.substr(slash + 1));
}

/// Reads a document section by section, according to the table of keys.
class Reader {
 public:
  explicit Reader(std::vector<MarkedProblem>& problems) : values_(problems) {}

  /// Reads the keys below `pattern` from a map into `section`. `shown` is the section's path in the file.
  void read_section(Setting& section, std::string_view pattern, const YamlNode& map, const std::string& shown) {
    const std::vector<const Key*> keys = keys_below(pattern);
    refuse_unknown(section, map, keys, shown);
    for (const Key* key : keys) read_key(section, *key, map, shown);
  }

 private:
  void problem(Mark mark, std::string message) { values_.problem(mark, std::move(message)); }

  /// Whether a key is missing, or removed by an override.
  static bool absent(const YamlEntry* entry) {
    return entry == nullptr || (entry->value.kind == Kind::null && entry->value.mark.source > 0);
  }

  void refuse_unknown(Setting& section, const YamlNode& map, const std::vector<const Key*>& keys,
                      const std::string& shown) {
    std::vector<std::string_view> names;
    for (const Key* key : keys) names.push_back(key->name());
    for (const YamlEntry& entry : map.entries) {
      if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
      std::string message = "unknown key " + in_quotes(entry.key) + (shown.empty() ? "" : " in " + shown) + "; ";
      if (const std::string_view meant = closest(entry.key, names); !meant.empty()) {
        message += "did you mean " + in_quotes(meant) + "? ";
        section.lost.emplace_back(meant);
      } else if (const Key* elsewhere = key_named(entry.key)) {
        message += in_quotes(entry.key) + " belongs to " +
                   (elsewhere->parent().empty() ? "the top of the file" : std::string(elsewhere->parent())) + "; ";
      }
      problem(entry.mark, message + "valid keys: " + choice(names));
    }
  }

  static const Key* key_named(std::string_view name) {
    for (const Key& key : schema_keys())
      if (key.name() == name) return &key;
    return nullptr;
  }

  void read_key(Setting& section, const Key& key, const YamlNode& map, const std::string& shown) {
    const std::string path = shown.empty() ? std::string(key.name()) : shown + "." + std::string(key.name());
    const YamlEntry* entry = map.find(key.name());
    bool required = key.required;
    if (!key.when.empty() && !applies(section, key, map, path, required)) return;
    if (!absent(entry)) {
      Setting setting{.key = &key, .name = std::string(key.name()), .mark = entry->value.mark, .given = true};
      if (read_value(setting, key, *entry, path))
        section.children.push_back(std::move(setting));
      else
        section.lost.emplace_back(key.name());
    } else if (key.defaulted || !key.fallback.empty()) {
      section.children.push_back(default_of(key, section.mark));
    } else if (required && section.lacks(key.name())) {
      problem(section.mark, "required key " + in_quotes(key.name()) + " is missing" +
                                (shown.empty() ? "" : " in " + shown) + "; give " + form_of(key) + ": " +
                                std::string(key.doc));
    }
  }

  /// Whether a key with a condition is allowed here. A key that depends on the word of another key is then also
  /// required.
  bool applies(const Setting& section, const Key& key, const YamlNode& map, const std::string& path, bool& required) {
    const YamlEntry* entry = map.find(key.name());
    const std::size_t equals = key.when.find('=');
    if (equals == std::string_view::npos) return stands_beside(key, map, path);
    const std::string_view neighbour = key.when.substr(0, equals);
    const Setting* said = section.find(neighbour);
    if (said == nullptr) return false;  // already reported
    const std::vector<std::string_view> words = split(key.when.substr(equals + 1), '|');
    required = std::find(words.begin(), words.end(), said->texts.at(0)) != words.end();
    if (!required && !absent(entry))
      problem(entry->mark, path + " does not belong to " + std::string(neighbour) + ": " + said->texts[0] +
                               "; it belongs to " + std::string(neighbour) + ": " + choice(words));
    return required;
  }

  /// Whether a key is allowed here: the other key that it needs is present, or the one that it excludes is absent.
  bool stands_beside(const Key& key, const YamlNode& map, const std::string& path) {
    const bool wanted = !key.when.starts_with('!');
    const std::string neighbour(key.when.substr(wanted ? 0 : 1));
    if (absent(map.find(neighbour)) != wanted) return true;
    if (const YamlEntry* entry = map.find(key.name()); !absent(entry))
      problem(entry->mark, path + (wanted ? " needs the key " + neighbour + "; add " + neighbour + " or remove it"
                                          : " cannot be combined with " + neighbour + "; remove one of the two"));
    return false;
  }

  Setting default_of(const Key& key, Mark mark) {
    Setting setting{.key = &key, .name = std::string(key.name()), .mark = mark};
    if (key.type == KeyType::section) {
      read_section(setting, key.path, YamlNode{.kind = Kind::map, .mark = mark}, std::string(key.path));
    } else {
      const YamlDocument document = parse_yaml(key.fallback, mark);
      read_value(setting, key, {std::string(key.name()), mark, document.root}, std::string(key.path));
      setting.mark = mark;
    }
    return setting;
  }

  bool read_value(Setting& setting, const Key& key, const YamlEntry& entry, const std::string& path) {
    const YamlNode& node = entry.value;
    if (node.kind == Kind::null) {
      problem(entry.mark, path + " is empty; give " + form_of(key));
      return false;
    }
    if (key.type == KeyType::section) return read_map(setting, key, entry, path);
    if (key.type == KeyType::named) return read_named(setting, key, entry, path);
    if (key.type == KeyType::values) return read_values(setting, key, entry, path);
    return values_.read(setting, key, node, path);
  }

  bool read_map(Setting& setting, const Key& key, const YamlEntry& entry, const std::string& path) {
    const YamlNode& node = entry.value;
    if (node.kind == Kind::scalar && !key.words.empty()) return values_.read_word(setting, key, node, path);
    if (node.kind != Kind::map) return values_.wrong_form(key, node, path);
    setting.mark = entry.mark;
    read_section(setting, key.path, node, path);
    return key.one_of.empty() || one_group(key, entry, path);
  }

  /// Checks that exactly one group of `one_of` is given, with all its keys.
  bool one_group(const Key& key, const YamlEntry& entry, const std::string& path) {
    const YamlNode& map = entry.value;
    std::vector<std::string_view> begun;
    std::string missing, all;
    for (const std::string_view group : split(key.one_of, '|')) {
      std::string absentees, names;
      bool any = false;
      for (const std::string_view name : split(group, '+')) {
        names += (names.empty() ? "" : " with ") + std::string(name);
        if (absent(map.find(name)))
          absentees += (absentees.empty() ? "" : " and ") + in_quotes(name);
        else
          any = true;
      }
      all += (all.empty() ? "" : ", or ") + names;
      if (any) {
        begun.push_back(group);
        missing = absentees;
      }
    }
    const std::string advice = "; give exactly one of: " + all;
    if (begun.size() > 1)
      problem(entry.mark, path + " gives alternatives that exclude each other" + advice);
    else if (begun.empty())
      problem(entry.mark, path + " gives none of its alternatives" + advice);
    else if (!missing.empty())
      problem(entry.mark, path + " lacks the key " + missing + advice);
    return begun.size() == 1 && missing.empty();
  }

  bool read_named(Setting& setting, const Key& key, const YamlEntry& entry, const std::string& path) {
    const YamlNode& node = entry.value;
    if (node.kind != Kind::map) return values_.wrong_form(key, node, path);
    setting.mark = entry.mark;
    const bool pairs = key.path == "contacts";
    const std::string pattern = std::string(key.path) + (pairs ? ".<pair>" : ".<name>");
    for (const YamlEntry& named : node.entries) {
      if (absent(&named)) continue;
      if (pairs ? !is_pair(named.key) : !is_name(named.key)) {
        problem(named.mark, in_quotes(named.key) + " is not a valid name in " + path + "; " +
                                (pairs ? "use two names with a slash, such as rock/steel"
                                       : "use letters, digits, - and _, with a letter or _ first"));
        setting.lost.push_back(named.key);
        continue;
      }
      const std::string shown = path + "." + named.key;
      if (named.value.kind != Kind::map) {
        problem(named.value.kind == Kind::null ? named.mark : named.value.mark,
                shown + " is not a map; give a map of the keys " + names_below(pattern));
        setting.lost.push_back(named.key);
        continue;
      }
      Setting child{.key = &key, .name = named.key, .mark = named.mark, .given = true};
      read_section(child, pattern, named.value, shown);
      setting.children.push_back(std::move(child));
    }
    return true;
  }

  /// Names are not restricted, because another program defines them.
  bool read_values(Setting& setting, const Key& key, const YamlEntry& entry, const std::string& path) {
    if (entry.value.kind != Kind::map) return values_.wrong_form(key, entry.value, path);
    setting.mark = entry.mark;
    const Key number{.path = key.path, .type = KeyType::quantity};
    for (const YamlEntry& named : entry.value.entries) {
      if (absent(&named)) continue;
      Setting child{.key = &key, .name = named.key, .mark = named.mark, .given = true};
      const std::string& text = named.value.text;
      if (named.value.kind == Kind::scalar && (text == "true" || text == "false"))
        child.numbers = {text == "true" ? 1.0 : 0.0};
      else if (!values_.read(child, number, named.value, path + "." + named.key))
        continue;
      child.key = &key;
      setting.children.push_back(std::move(child));
    }
    return true;
  }

  ValueReader values_;
};

}  // namespace

Setting read_settings(const YamlNode& root, std::vector<MarkedProblem>& problems) {
  Setting settings{.mark = root.mark, .given = true};
  if (root.kind != Kind::map) {
    problems.push_back({root.mark, "the document is not a map; write keys such as `time: {duration: 2 s}`"});
    return settings;
  }
  settings.mark = {0, 1, 1};
  Reader(problems).read_section(settings, "", root, "");
  return settings;
}

}  // namespace gyro

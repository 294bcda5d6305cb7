// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/yaml/yaml_tree.hpp"

#include "core/base/encoding.hpp"
#include "core/base/printable.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>
#include <sstream>
#include <unordered_map>

namespace gyro {
namespace {

constexpr std::size_t deepest = 64;  // levels of nesting; a case file has 6

struct TooDeep {};

/// Builds the tree from yaml-cpp's events. The events contain anchors, aliases, tags and duplicate keys, which
/// yaml-cpp's own node tree does not.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(Mark first, YamlDocument& document) : first_(first), document_(document) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnAnchor(const YAML::Mark&, const std::string&) override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    attach(node(YamlNode::Kind::null, mark));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    problem(place(mark), "aliases (*name) are not supported; write the value itself");
    attach(node(YamlNode::Kind::null, mark));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    YamlNode scalar = node(YamlNode::Kind::scalar, mark);
    scalar.text = value;
    attach(std::move(scalar));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(YamlNode::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(YamlNode::Kind::map, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

  Mark place(const YAML::Mark& mark) const {
    if (mark.is_null()) return first_;
    const bool first_line = mark.line == 0;
    return {first_.source, first_.line + mark.line, mark.column + (first_line ? first_.column : 1)};
  }
  void problem(Mark mark, std::string message) { document_.problems.push_back({mark, std::move(message)}); }

 private:
  /// A list or map that is still open.
  struct Frame {
    YamlNode node;
    bool has_key = false;  ///< the key of an entry has been read, but not yet its value
    bool drop = false;     ///< the value belongs to a key that was refused
    std::string key;
    Mark key_mark;
    std::unordered_map<std::string, Mark> keys;  ///< keys of a map so far, and their places
  };

  YamlNode node(YamlNode::Kind kind, const YAML::Mark& mark) const {
    YamlNode made;
    made.kind = kind;
    made.mark = place(mark);
    return made;
  }
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != 0) problem(place(mark), "anchors (&name) are not supported; write the value wherever it is needed");
  }
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (!tag.empty() && tag != "?" && tag != "!")
      problem(place(mark), "tags (!" + tag.substr(tag.find_last_of(":!") + 1) + ") are not supported; remove the tag");
  }
  void open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (frames_.size() >= deepest) {
      problem(place(mark), "nested too deeply; use at most " + std::to_string(deepest) + " levels");
      throw TooDeep{};
    }
    frames_.push_back({node(kind, mark), false, false, {}, {}, {}});
  }
  void close() {
    YamlNode done = std::move(frames_.back().node);
    frames_.pop_back();
    attach(std::move(done));
  }
  void attach(YamlNode child) {
    if (frames_.empty()) {
      document_.root = std::move(child);
    } else if (Frame& frame = frames_.back(); frame.node.kind == YamlNode::Kind::list) {
      frame.node.items.push_back(std::move(child));
    } else if (!frame.has_key) {
      take_key(frame, child);
    } else {
      if (!frame.drop) frame.node.entries.push_back({frame.key, frame.key_mark, std::move(child)});
      frame.has_key = false;
    }
  }
  void take_key(Frame& frame, const YamlNode& key) {
    frame.has_key = true;
    frame.drop = true;
    if (key.kind != YamlNode::Kind::scalar)
      return problem(key.mark, "a key must be a name; a list, a map or null cannot be a key");
    if (key.text == "<<") return problem(key.mark, "merge keys (<<) are not supported; write the keys themselves");
    const auto [before, first] = frame.keys.try_emplace(key.text, key.mark);
    if (!first)
      return problem(key.mark, "key \"" + key.text + "\" is given twice (first at " +
                                   std::to_string(before->second.line) + ":" + std::to_string(before->second.column) +
                                   "); give it once");
    frame.drop = false;
    frame.key = key.text;
    frame.key_mark = key.mark;
  }

  Mark first_;
  YamlDocument& document_;
  std::vector<Frame> frames_;
};

/// Whether a text is UTF-8. @param mark  place where the text begins; moved to the first invalid byte
bool is_utf8(std::string_view text, Mark& mark) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    if (text.front() == '\n') {
      ++mark.line;
      mark.column = 1;
    } else {
      ++mark.column;
    }
    text.remove_prefix(length);
  }
  return true;
}

void parse_into(std::string_view text, TreeBuilder& builder, Mark first) {
  std::istringstream stream{std::string(text)};
  YAML::Parser parser(stream);
  if (!parser.HandleNextDocument(builder)) return builder.problem(first, "no YAML document; write a map of keys");
  YamlDocument second;
  TreeBuilder ignored(first, second);
  if (parser.HandleNextDocument(ignored))
    builder.problem(second.root.mark, "a second YAML document begins here; a case is one document");
}

}  // namespace

YamlEntry* YamlNode::find(std::string_view key) {
  for (YamlEntry& entry : entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

const YamlEntry* YamlNode::find(std::string_view key) const {
  return const_cast<YamlNode*>(this)->find(key);
}

YamlDocument parse_yaml(std::string_view text, Mark first) {
  YamlDocument document;
  document.root.mark = first;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (is_utf16(text)) {
    document.problems.push_back({first, utf16_problem});
    return document;
  }
  if (Mark bad = first; !is_utf8(text, bad)) {
    document.problems.push_back({bad, "not a text in UTF-8; save the file as UTF-8"});
    return document;
  }
  TreeBuilder builder(first, document);
  try {
    parse_into(text, builder, first);
  } catch (const YAML::Exception& error) {
    builder.problem(builder.place(error.mark), "not valid YAML: " + error.msg + "; write `key: value` lines");
  } catch (const TooDeep&) {
    // the problem has already been added
  }
  return document;
}

}  // namespace gyro

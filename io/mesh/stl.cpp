// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh/stl.hpp"

#include "core/base/encoding.hpp"
#include "core/base/errors.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <ranges>

namespace gyro {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little endian");

constexpr std::size_t header_size = 84;    // 80 bytes of text and the number of triangles
constexpr std::size_t triangle_size = 50;  // normal, three corners, 2 bytes of attributes

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw BadInput(name + ": " + problem + "; an ASCII or binary STL file with at least one triangle is needed");
}

void add_corner(TriangleMesh& mesh, const Vec3d& p, const std::string& name) {
  if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
    refuse(name, "triangle " + std::to_string(mesh.vertices.size() / 3 + 1) + " has a coordinate that is not finite");
  }
  if (mesh.vertices.size() >= static_cast<std::size_t>(std::numeric_limits<Index>::max()) - 3) {
    refuse(name, "more than 7e8 triangles");
  }
  mesh.vertices.push_back(p);
  const Index n = static_cast<Index>(mesh.vertices.size());
  if (n % 3 == 0) mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

std::uint32_t announced_triangles(std::string_view bytes) {
  std::uint32_t count;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& name) {
  TriangleMesh mesh;
  for (std::size_t at = header_size; at + triangle_size <= bytes.size(); at += triangle_size) {
    float values[12];
    std::memcpy(values, bytes.data() + at, sizeof values);
    for (int k = 3; k < 12; k += 3) add_corner(mesh, {values[k], values[k + 1], values[k + 2]}, name);
  }
  return mesh;
}

bool same_word(std::string_view a, std::string_view lower) {
  return std::ranges::equal(a, lower, {}, [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
}

/// Reads the words of a text, without comments (lines that begin with # or ;). An empty word is the end.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next() {
    for (skip_blanks(); at_ < text_.size() && is_comment(); skip_blanks()) skip_line();
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(" \t\r\n\v\f", begin), text_.size());
    return text_.substr(begin, at_ - begin);
  }
  void skip_line() { at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()); }
  /// Skips the name of a solid: to the end of the line, or to where a facet begins on it, as in files of a single line.
  void skip_name() {
    Words line = rest_of_line();
    std::string_view end;
    for (std::string_view word = line.next(); !word.empty(); word = line.next()) {
      if (line.begins_facet(word)) return go_to(word);
      if (same_word(word, "endsolid")) end = word;
    }
    skip_line();
    if (!end.empty() && text_.find_first_not_of(" \t\r\n", at_) == std::string_view::npos)
      go_to(end);  // an empty solid
  }
  /// The same after `endsolid`: to the end of the line, or to where another solid with a facet begins on it.
  void skip_end_name() {
    Words line = rest_of_line();
    std::string_view solid;
    for (std::string_view word = line.next(); !word.empty(); word = line.next()) {
      if (same_word(word, "solid")) solid = word;
      if (line.begins_facet(word)) return go_to(solid.empty() ? word : solid);
    }
    skip_line();
  }
  /// Line of the word that next() returned last, from 1. Lines end with \n, \r\n or \r.
  std::size_t line() const {
    const std::string_view read = text_.substr(0, at_);
    const auto feeds = std::ranges::count(read, '\n');
    return 1 + static_cast<std::size_t>(feeds > 0 ? feeds : std::ranges::count(read, '\r'));
  }

 private:
  Words rest_of_line() const {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    return Words(text_.substr(at_, end - at_));
  }
  /// Whether a word that next() gave is `facet`, and `normal` or `outer` follows.
  bool begins_facet(std::string_view word) const {
    if (!same_word(word, "facet")) return false;
    Words ahead = *this;
    const std::string_view following = ahead.next();
    return same_word(following, "normal") || same_word(following, "outer");
  }
  /// Makes this word the next one.
  void go_to(std::string_view word) { at_ = static_cast<std::size_t>(word.data() - text_.data()); }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n\v\f", at_), text_.size()); }
  bool is_comment() const {
    if (text_[at_] != '#' && text_[at_] != ';') return false;
    const std::size_t before = text_.substr(0, at_).find_last_not_of(" \t");
    return before == std::string_view::npos || text_[before] == '\n' || text_[before] == '\r';
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// ASCII STL: solids one after the other, each from `solid NAME` to `endsolid NAME`. A name is the rest of its line.
class AsciiStl {
 public:
  AsciiStl(std::string_view text, const std::string& name) : words_(text), name_(name) {}

  TriangleMesh read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (!same_word(word, "solid")) refuse_word(word, "'solid'");
      words_.skip_name();
      read_solid();
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse_here(const std::string& problem) const {
    refuse(name_ + ":" + std::to_string(words_.line()), problem);
  }
  [[noreturn]] void refuse_word(std::string_view word, const std::string& wanted) const {
    if (word.empty()) refuse_here("the text ends before 'endsolid': the file is truncated");
    refuse_here("'" + std::string(word.substr(0, 30)) + "' in place of " + wanted);
  }

  void read_solid() {
    for (std::string_view word = words_.next(); !same_word(word, "endsolid"); word = words_.next()) {
      if (same_word(word, "solid"))
        refuse_here("a solid begins before the 'endsolid' of the one above: a part of the file is missing");
      if (same_word(word, "facet"))
        read_facet();
      else if (same_word(word, "outer"))
        read_loop(word);
      else
        refuse_word(word, "'facet' or 'endsolid'");
    }
    words_.skip_end_name();
  }
  /// The normal is not used: the order of the corners decides which side is outside.
  void read_facet() {
    const std::size_t before = mesh_.triangles.size();
    std::string_view word = words_.next();
    if (same_word(word, "normal")) {
      for (int k = 0; k < 3; ++k) words_.next();
      word = words_.next();
    }
    for (; !same_word(word, "endfacet"); word = words_.next()) read_loop(word);
    if (mesh_.triangles.size() != before + 1) refuse_here("a facet does not have 3 corners");
  }
  /// From `outer loop`, whose first word has been read, to `endloop`.
  void read_loop(std::string_view word) {
    if (!same_word(word, "outer")) refuse_word(word, "'outer loop'");
    if (word = words_.next(); !same_word(word, "loop")) refuse_word(word, "'outer loop'");
    for (word = words_.next(); !same_word(word, "endloop"); word = words_.next()) {
      if (!same_word(word, "vertex")) refuse_word(word, "'vertex'");
      const double x = coordinate(), y = coordinate();
      add_corner(mesh_, {x, y, coordinate()}, name_);
    }
    if (mesh_.vertices.size() != 3 * mesh_.triangles.size()) refuse_here("a facet does not have 3 corners");
  }
  double coordinate() {
    std::string_view word = words_.next();
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc{} || end != word.data() + word.size()) refuse_word(word, "a coordinate");
    return value;
  }

  Words words_;
  const std::string& name_;
  TriangleMesh mesh_;
};

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// Whether bytes are ASCII STL: they begin with `solid`, and have no zero bytes where a binary file has its header,
/// unless these belong to a name.
bool is_ascii(std::string_view text) {
  Words words(text);
  if (!same_word(words.next().substr(0, 5), "solid")) return false;
  if (text.substr(0, header_size).find('\0') == std::string_view::npos) return true;
  words.skip_name();
  return same_word(words.next(), "facet");
}

/// Whether bytes after the last triangle of a binary file are ignored: fewer than a triangle has, or zeros and blanks.
bool is_filling(std::string_view bytes) {
  constexpr std::size_t block = 4096;  // [bytes] block size of disks and tapes
  return bytes.size() < triangle_size || (bytes.size() <= block && bytes.find_first_not_of(std::string_view(
                                                                       "\0 \t\r\n\x1a", 6)) == std::string_view::npos);
}

[[noreturn]] void refuse_binary(std::string_view bytes, std::uint64_t expected, const std::string& name) {
  const auto is_text = [](unsigned char c) { return std::isprint(c) || std::isspace(c); };
  if (!bytes.empty() && std::ranges::all_of(bytes.substr(0, 4 * header_size), is_text))
    refuse(name, "a text that does not begin with 'solid', as an ASCII STL file must");
  if (bytes.size() < header_size)
    refuse(name, "only " + std::to_string(bytes.size()) + " bytes, which is too short for an STL file");
  refuse(name, "the header announces " + std::to_string(announced_triangles(bytes)) + " triangles, which is " +
                   std::to_string(expected) + " bytes, but the file has " + std::to_string(bytes.size()) +
                   (bytes.size() < expected ? ": truncated or damaged" : ": damaged, or more than one file in it"));
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name, std::vector<std::string>* notes) {
  // The size decides, not the first word, because many binary files begin with "solid".
  const std::uint64_t expected =
      bytes.size() >= header_size ? header_size + triangle_size * std::uint64_t{announced_triangles(bytes)} : 0;
  const std::string_view text = bytes.starts_with(utf8_mark) ? bytes.substr(utf8_mark.size()) : bytes;
  TriangleMesh mesh;
  if (bytes.size() >= header_size && bytes.size() == expected) {
    mesh = parse_binary(bytes, name);
  } else if (is_utf16(bytes)) {
    throw BadInput(name + ": " + utf16_problem);
  } else if (is_ascii(text)) {
    mesh = AsciiStl(text, name).read();
  } else if (bytes.size() >= header_size && bytes.size() > expected && is_filling(bytes.substr(expected))) {
    mesh = parse_binary(bytes.substr(0, expected), name);
    if (notes != nullptr)
      notes->push_back(std::to_string(bytes.size() - expected) + " bytes after the last triangle ignored");
  } else {
    refuse_binary(bytes, expected, name);
  }
  if (mesh.triangles.empty()) refuse(name, "no triangles");
  return mesh;
}

void write_stl(const std::string& path, const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto put = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  const auto put_vector = [&](const Vec3d& v) {
    put(static_cast<float>(v.x)), put(static_cast<float>(v.y)), put(static_cast<float>(v.z));
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    const Vec3d a = mesh.vertices[t.x], b = mesh.vertices[t.y], c = mesh.vertices[t.z];
    const Vec3d n = cross(b - a, c - a);
    put_vector(norm(n) > 0 ? (1 / norm(n)) * n : Vec3d{0, 0, 0});
    put_vector(a), put_vector(b), put_vector(c);
    put(std::uint16_t{0});
  }
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw OutputError(path + ": cannot be written; check the folder and the free space of the disk");
}

}  // namespace gyro

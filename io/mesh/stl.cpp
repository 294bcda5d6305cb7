// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh/stl.hpp"

#include "core/base/errors.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

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

/// Words of a text, one after the other; empty at the end.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next() {
    constexpr const char* blanks = " \t\r\n\v\f";
    const std::size_t begin = std::min(text_.find_first_not_of(blanks, at_), text_.size());
    at_ = std::min(text_.find_first_of(blanks, begin), text_.size());
    return text_.substr(begin, at_ - begin);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

double coordinate(std::string_view word, const std::string& name, const TriangleMesh& mesh) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size()) {
    refuse(name, "triangle " + std::to_string(mesh.vertices.size() / 3 + 1) + " has '" +
                     std::string(word.substr(0, 30)) + "' in place of a coordinate");
  }
  return value;
}

TriangleMesh parse_ascii(std::string_view text, const std::string& name) {
  TriangleMesh mesh;
  Words words(text);
  bool inside = false;  // between outer loop and endloop
  bool ended = false;   // after endsolid
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "outer") {
      inside = true;
    } else if (word == "endloop") {
      if (mesh.vertices.size() != 3 * mesh.triangles.size()) refuse(name, "a facet does not have 3 corners");
      inside = false;
    } else if (word == "vertex" && inside) {
      const double x = coordinate(words.next(), name, mesh), y = coordinate(words.next(), name, mesh);
      add_corner(mesh, {x, y, coordinate(words.next(), name, mesh)}, name);
    } else if (word == "endsolid") {
      ended = true;
    }
  }
  if (inside || !ended) refuse(name, "the text ends before 'endsolid': the file is truncated");
  return mesh;
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name) {
  // The size decides, not the first word: many binary files begin with "solid".
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool text = first != std::string_view::npos && bytes.substr(first, 5) == "solid";
  const std::uint64_t expected =
      bytes.size() >= header_size ? header_size + triangle_size * std::uint64_t{announced_triangles(bytes)} : 0;
  TriangleMesh mesh;
  if (bytes.size() >= header_size && bytes.size() == expected) {
    mesh = parse_binary(bytes, name);
  } else if (text) {
    mesh = parse_ascii(bytes, name);
  } else if (bytes.size() < header_size) {
    refuse(name, "only " + std::to_string(bytes.size()) + " bytes, which is too short for an STL file");
  } else {
    refuse(name, "the header announces " + std::to_string(announced_triangles(bytes)) + " triangles, which is " +
                     std::to_string(expected) + " bytes, but the file has " + std::to_string(bytes.size()) +
                     ": truncated or damaged");
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
  if (!file.flush()) throw OutputError(path + ": cannot be written");
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh/obj.hpp"

#include "core/base/encoding.hpp"
#include "core/base/errors.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

/// Parses the lines of an OBJ file, and counts them for messages.
class ObjParser {
 public:
  explicit ObjParser(const std::string& name) : name_(name) {}

  /// Parses a line. @param lines  number of lines of the file that were joined to it
  void line(std::string_view text, std::size_t lines) {
    number_ = next_;
    next_ += lines;
    text_ = text.substr(0, text.find('#'));
    const std::string_view keyword = word();
    if (keyword == "v") {
      vertex();
    } else if (keyword == "f") {
      face();
    }  // textures, normals, groups, materials, points and lines are not part of the surface
  }

  /// The mesh of all lines so far.
  TriangleMesh finish() {
    if (mesh_.triangles.empty()) throw BadInput(name_ + ": no faces; an OBJ file with 'v' and 'f' lines is needed");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw BadInput(name_ + ":" + std::to_string(number_) + ": " + problem +
                   "; vertices are 'v x y z', faces 'f' with at least 3 of v, v/vt, v//vn or v/vt/vn");
  }

  std::string_view word() {
    constexpr const char* blanks = " \t\r\n\v\f\\";
    const std::size_t begin = std::min(text_.find_first_not_of(blanks), text_.size());
    const std::size_t end = std::min(text_.find_first_of(blanks, begin), text_.size());
    const std::string_view found = text_.substr(begin, end - begin);
    text_.remove_prefix(end);
    return found;
  }

  void vertex() {
    double x[3];
    for (double& value : x) {
      std::string_view w = word();
      if (w.starts_with('+')) w.remove_prefix(1);
      const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
      if (w.empty() || error != std::errc{} || end != w.data() + w.size()) refuse("a vertex without three numbers");
      if (!std::isfinite(value)) refuse("a coordinate that is not finite");
    }
    if (mesh_.vertices.size() >= static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      refuse("too many vertices");
    mesh_.vertices.push_back({x[0], x[1], x[2]});
  }

  /// Index of a vertex. In the file it counts from 1, or backwards from the last vertex read so far if negative.
  Index corner(std::string_view w) const {
    w = w.substr(0, w.find('/'));
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), n);
    const std::int64_t count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t index = n < 0 ? count + n : n - 1;
    if (w.empty() || error != std::errc{} || end != w.data() + w.size() || index < 0 || index >= count || n == 0) {
      refuse("a face refers to vertex '" + std::string(w.substr(0, 20)) + "', but there are " + std::to_string(count));
    }
    return static_cast<Index>(index);
  }

  /// A polygon becomes a fan of triangles about its first corner.
  void face() {
    std::vector<Index> corners;
    for (std::string_view w = word(); !w.empty(); w = word()) corners.push_back(corner(w));
    if (corners.size() < 3) refuse("a face with fewer than three corners");
    for (std::size_t k = 2; k < corners.size(); ++k) {
      mesh_.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }

  std::string name_;
  std::string_view text_;
  std::size_t number_ = 0, next_ = 1;
  TriangleMesh mesh_;
};

/// Whether a line ends with a backslash and therefore continues on the next one. A backslash at the end of a comment,
/// for example of a path, does not count.
bool continues(std::string_view line) {
  if (line.find('#') != std::string_view::npos) return false;
  const std::size_t last = line.find_last_not_of(" \t\r");
  return last != std::string_view::npos && line[last] == '\\';
}

/// An OBJ file does not say how many faces it has, so that one that was cut off may still be read.
void note_signs_of_a_cut(std::string_view text, const TriangleMesh& mesh, std::vector<std::string>& notes) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Vec3<Index>& triangle : mesh.triangles)
    for (const Index corner : {triangle.x, triangle.y, triangle.z}) used[static_cast<std::size_t>(corner)] = true;
  const auto unused = std::ranges::count(used, false);
  if (unused > 0)
    notes.push_back(std::to_string(unused) + " of " + std::to_string(used.size()) +
                    " vertices belong to no face; check that the file is complete");
  if (!text.ends_with('\n') && !text.ends_with('\r'))
    notes.push_back("the last line has no line end; check that the file is complete");
}

}  // namespace

TriangleMesh parse_obj(std::string_view text, const std::string& name, std::vector<std::string>* notes) {
  ObjParser parser(name);
  if (is_utf16(text)) throw BadInput(name + ": " + utf16_problem);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const char newline = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = std::min(text.find(newline, begin), text.size()), joined = 0;
    // word() skips the backslashes like blanks.
    for (std::size_t last = begin; end < text.size() && continues(text.substr(last, end - last)); ++joined) {
      last = end + 1;
      end = std::min(text.find(newline, last), text.size());
    }
    parser.line(text.substr(begin, end - begin), 1 + joined);
    begin = end + 1;
  }
  TriangleMesh mesh = parser.finish();
  if (notes != nullptr) note_signs_of_a_cut(text, mesh, *notes);
  return mesh;
}

}  // namespace gyro

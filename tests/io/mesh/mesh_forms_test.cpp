// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/mesh/obj.hpp"
#include "io/mesh/stl.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"
#include "tests/io/mesh/written.hpp"

#include <algorithm>
#include <cctype>

using namespace gyro;
using Catch::Matchers::Contains;

// Forms in which CAD programs and converters write the same mesh.

namespace {

const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string solid(const std::string& name, int facets = 1) {
  std::string text = "solid " + name + "\n";
  for (int k = 0; k < facets; ++k) text += facet;
  return text + "endsolid " + name + "\n";
}

std::size_t triangles(const std::string& text) {
  return parse_stl(text, "x.stl").triangles.size();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

void refused(const std::string& text, const std::string& reason) {
  INFO(text);
  CHECK_THROWS_AS(parse_stl(text, "x.stl"), BadInput);
  CHECK_THROWS_WITH(parse_stl(text, "x.stl"), Contains(reason) && Contains("x.stl"));
}

std::string binary(int count, const std::string& behind = {}) {
  const ScratchDirectory folder;
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int k = 0; k < count; ++k) mesh.triangles.push_back({0, 1, 2});
  const std::string path = (folder.path() / "b.stl").string();
  write_stl(path, mesh);
  return read_bytes(path) + behind;
}

}  // namespace

TEST_CASE("An ASCII STL file may contain several solids with any names") {
  CHECK(triangles(solid("a") + solid("b", 2)) == 3);
  for (const char* name : {"outer bowl", "liner set 3", "facet", "endsolid", "vertex 1 2", "", "endloop outer loop"}) {
    INFO(name);
    CHECK(triangles(solid(name) + "\n" + solid(name)) == 2);
  }
  CHECK(triangles("solid a\nendsolid a\n" + solid("b")) == 1);  // an empty solid
}

TEST_CASE("An ASCII STL file is refused wherever it is cut off") {
  const std::string text = solid("first") + solid("second");
  const std::size_t last = text.rfind("endsolid"), between = text.find("solid second");
  for (std::size_t length = 1; length < last; ++length) {
    if (length >= between - 7 && length <= between) continue;  // exactly the first solid is left
    INFO(length);
    CHECK_THROWS_AS(parse_stl(text.substr(0, length), "x.stl"), BadInput);
  }
  refused(text.substr(0, last), "truncated");
  refused(replaced(text, "endsolid first\n", ""), "x.stl:9: a solid begins before the 'endsolid'");
  refused(replaced(text, "vertex 0 1 0\n", ""), "3 corners");
  refused(replaced(text, "endfacet\n", ""), "'endsolid' in place of 'outer loop'");
  refused("solid\nfacet normal 0 0 1\nendfacet\nendsolid\n", "3 corners");
  refused(replaced(text, "vertex 0 1 0", "vertex 0 1,5 0"), "x.stl:6: '1,5' in place of a coordinate");
  refused(solid("a") + "rubbish", "x.stl:10: 'rubbish' in place of 'solid'");
}

TEST_CASE("ASCII STL is read in upper case, with a byte-order mark, comments and any line ends") {
  std::string upper = solid("Part");
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
  CHECK(triangles(upper) == 1);
  CHECK(triangles("\xEF\xBB\xBF" + solid("a")) == 1);
  CHECK(triangles("\xEF\xBB\xBF\r\n" + replaced(solid("outer a") + solid("b"), "\n", "\r\n")) == 2);
  CHECK(triangles(replaced(solid("outer a") + solid("b"), "\n", "\r")) == 2);
  CHECK(triangles("# solid of old\n ; facet\n" + replaced(solid("a"), "outer", "# outer loop\nouter")) == 1);
  CHECK(triangles(replaced(solid("#1 ; a"), "vertex 1 0 0", "vertex +1e0 -0.0 0.")) == 1);
  refused("facet normal 0 0 1\n" + solid("a"), "does not begin with 'solid'");
  refused(replaced(solid("a"), "solid", "object"), "does not begin with 'solid'");
}

TEST_CASE("A few bytes after the last triangle of a binary STL file are ignored with a note") {
  const std::string zeros(512, '\0');
  for (const std::string& behind : {std::string("\n"), std::string("\r\n\x1a"), std::string("end of part"), zeros}) {
    std::vector<std::string> notes;
    CHECK(parse_stl(binary(3, behind), "x.stl", &notes).triangles.size() == 3);
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Contains(std::to_string(behind.size()) + " bytes after the last triangle"));
  }
  refused(binary(3, binary(1)), "more than one file");
  refused(binary(3, std::string(50, 'x')), "damaged");
  refused(binary(3, std::string(5000, '\0')), "damaged");
  const ScratchDirectory folder;
  const RepairedMesh read = read_mesh(written(folder, "long.stl", binary(1, "\n")));
  REQUIRE(read.notes.size() == 1);
  CHECK_THAT(read.notes[0], Contains("long.stl: 1 bytes after"));
}

TEST_CASE("OBJ files are read in the forms in which other programs write them") {
  const std::string good =
      "# of C:\\parts\\\no one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"
      "g two\no second\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf -3/1 -2/1 -1/1\nf 1 \\\n2 \\\n4\n";
  for (const std::string& text :
       {good, "\xEF\xBB\xBF" + good.substr(good.find("v 0")), replaced(good, "\n", "\r\n"), replaced(good, "\n", "\r"),
        replaced(good, "v 0 0 1\n", "v 0 0 1 1.0 0.5 0.5 # colour\n")}) {
    INFO(text);
    const TriangleMesh mesh = parse_obj(text, "x.obj");
    REQUIRE(mesh.triangles.size() == 3);
    CHECK(mesh.vertices.size() == 6);
    CHECK(mesh.triangles[1].x == 3);
    CHECK(mesh.triangles[1].z == 5);
  }
  // Joined lines are counted in the line number of a message.
  CHECK_THROWS_WITH(parse_obj("v 0 0 0\nv 1 0 0\nf 1 \\\n2 \\\n1\nv 0 1,5 0\n", "x.obj"), Contains("x.obj:6:"));
}

TEST_CASE("A read error in a mesh file is reported and not taken for the end of the file") {
  const ScratchDirectory folder;
  const std::string path = (folder.path() / "broken.stl").string();
  std::filesystem::create_symlink("/proc/self/mem", path);  // its first read fails with EIO
  CHECK_THROWS_WITH(read_mesh(path), Contains("cannot be read: Input/output error"));
  std::filesystem::create_directory(folder.path() / "folder.stl");
  CHECK_THROWS_AS(read_mesh((folder.path() / "folder.stl").string()), BadInput);
}

TEST_CASE("An ASCII STL on a single line, or with any line ends, is read") {
  const std::string two = solid("outer bowl") + solid("b", 2);
  for (const char* end : {" ", "\r", "\r\n", "  "}) {
    const std::string text = replaced(two, "\n", end);
    INFO(text);
    CHECK(triangles(text) == 3);
    refused(text.substr(0, text.rfind("endsolid")), "truncated");
    refused(text.substr(0, text.rfind("endfacet")), "truncated");
    refused(replaced(text, "vertex 1 0 0", "vertex 1 0,5 0"), "'0,5' in place of a coordinate");
  }
  refused("solid a endsolid a", "no triangles");
  CHECK(triangles(replaced(solid("endsolid"), "\n", " ")) == 1);
}

TEST_CASE("A mesh in UTF-16 is refused with its cause") {
  const std::string text = solid("a"), corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto wide = [](const std::string& narrow, bool little, bool mark) {
    std::string bytes = mark ? (little ? "\xFF\xFE" : "\xFE\xFF") : "";
    for (const char c : narrow) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
  };
  for (const bool little : {true, false})
    for (const bool mark : {true, false}) {
      refused(wide(text, little, mark), "is a text in UTF-16; save it as UTF-8");
      CHECK_THROWS_WITH(parse_obj(wide(corners, little, mark), "x.obj"), Contains("x.obj: is a text in UTF-16"));
    }
}

TEST_CASE("What a message quotes of a mesh is printable") {
  refused(std::string("solid a\0b\nfacet nor\0mal 0 0 1\n", 30), "'nor\\x00mal' in place of");
  CHECK(triangles(replaced(solid("a"), "solid a\n", std::string("solid a\0b\n", 10))) == 1);
  refused(replaced(solid("a"), "vertex 1", "\x1b[31mvert\xE4x"), "'\\x1B[31mvert\\xE4x' in place of 'vertex'");
  CHECK_THROWS_WITH(parse_obj("v 0 0 0\nf 1\x07 1 1\n", "x.obj"), Contains("'1\\x07'"));
}

TEST_CASE("Coordinates that no drawing has are refused") {
  const ScratchDirectory folder;
  const std::string small =
      replaced(replaced(solid("a"), "vertex 1", "vertex 1e-200"), "vertex 0 1", "vertex 0 1e-200");
  CHECK_THROWS_WITH(read_mesh(written(folder, "s.stl", small)), Contains("s.stl: ") && Contains("coordinates"));
}

TEST_CASE("Signs that an OBJ file was cut off are noted") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  const auto notes_of = [](const std::string& text) {
    std::vector<std::string> notes;
    parse_obj(text, "x.obj", &notes);
    return notes;
  };
  CHECK(notes_of(vertices + "f 1 2 3\nf 2 4 3\n").empty());
  CHECK(notes_of(vertices + "f 1 2 3\r\nf 2 4 3\r\n").empty());
  const std::vector<std::string> fewer = notes_of(vertices + "f 1 2 3\n");
  REQUIRE(fewer.size() == 1);
  CHECK_THAT(fewer[0], Contains("1 of 4 vertices belong to no face"));
  const std::vector<std::string> open = notes_of(vertices + "f 1 2 3\nf 2 4 3");
  REQUIRE(open.size() == 1);
  CHECK_THAT(open[0], Contains("no line end"));
}

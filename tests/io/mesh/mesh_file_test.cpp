// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh/mesh_file.hpp"
#include "core/base/errors.hpp"
#include "core/geometry/mesh.hpp"
#include "core/math/random.hpp"
#include "io/mesh/obj.hpp"
#include "io/mesh/stl.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"
#include "tests/io/mesh/written.hpp"

#include <cstring>
#include <limits>
#include <sstream>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

std::string ascii_stl(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "solid block\n";
  for (const auto& t : mesh.triangles) {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (const Index v : {t.x, t.y, t.z}) {
      const Vec3d p = mesh.vertices[v];
      text << "   vertex " << p.x << " " << p.y << " " << p.z << "\n";
    }
    text << "  endloop\n endfacet\n";
  }
  text << "endsolid block\n";
  return text.str();
}

std::string binary_stl(const ScratchDirectory& folder, const TriangleMesh& mesh) {
  const std::string path = (folder.path() / "written.stl").string();
  write_stl(path, mesh);
  return read_bytes(path);
}

const char* cube_of_quads =
    "# a cube\no cube\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 # comment\nv 0 0 1\nv +1 0 1 1.0\nv 1 1 1\n"
    "v 0 1 1\nvt 0 0\nvn 0 0 1\ns off\nf 1/1/1 4/1/1 3/1/1 2/1/1\nf 5//1 6//1 7//1 8//1\nf 1/1 2/1 6/1 5/1\n"
    "f 2 3 7 \\\n 6\r\nf -6 -5 -1 -2\nf 4 1 5 8\n";

}  // namespace

TEST_CASE("ASCII STL, binary STL and OBJ files give the same solid") {
  const ScratchDirectory folder;
  const TriangleMesh mesh = block({2, 3, 5});
  const std::string binary = binary_stl(folder, mesh);
  CHECK(binary.size() == 84 + 50 * 12);
  for (const std::string& path : {written(folder, "a.stl", ascii_stl(mesh)), written(folder, "b.STL", binary)}) {
    const RepairedMesh read = read_solid(path);
    CHECK(read.mesh.vertices.size() == 8);
    CHECK(mass_properties(read.mesh).volume == Approx(30).epsilon(1e-6));
    CHECK(read.notes.empty());
  }
  const RepairedMesh cube = read_solid(written(folder, "cube.obj", cube_of_quads));
  CHECK(cube.mesh.triangles.size() == 12);
  CHECK(mass_properties(cube.mesh).volume == Approx(1));
}

TEST_CASE("A binary STL file may begin with the word solid") {
  const ScratchDirectory folder;
  std::string bytes = binary_stl(folder, block({1, 1, 1}));
  std::memcpy(bytes.data(), "solid", 5);
  CHECK(parse_stl(bytes, "x").triangles.size() == 12);
}

TEST_CASE("Meshes are repaired, and each repair is reported") {
  const ScratchDirectory folder;
  TriangleMesh mesh = block({1, 1, 1});
  for (auto& t : mesh.triangles) std::swap(t.x, t.y);
  const RepairedMesh turned = read_solid(written(folder, "inverted.stl", ascii_stl(mesh)));
  CHECK(mass_properties(turned.mesh).volume == Approx(1));
  REQUIRE(turned.notes.size() == 1);
  CHECK_THAT(turned.notes[0], Contains("12 triangles flipped"));

  mesh = block({1, 1, 1});
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({1, 1, 2});
  const RepairedMesh cleaned = read_solid(written(folder, "dirty.stl", ascii_stl(mesh)));
  CHECK(cleaned.mesh.triangles.size() == 12);
  CHECK(cleaned.notes.size() == 2);
}

TEST_CASE("An open mesh is accepted as a wall but not as a rock") {
  const ScratchDirectory folder;
  TriangleMesh mesh = block({1, 1, 1});
  mesh.triangles.resize(10);
  const std::string path = written(folder, "open.stl", ascii_stl(mesh));
  CHECK(read_mesh(path).mesh.triangles.size() == 10);
  CHECK_THROWS_WITH(read_solid(path), Contains("4 open edges") && Contains("open.stl"));
}

TEST_CASE("Files that do not contain a valid mesh are refused with the reason") {
  const ScratchDirectory folder;
  const auto refused = [&](const std::string& name, const std::string& bytes, const std::string& reason) {
    CAPTURE(name);
    const std::string path = written(folder, name, bytes);
    CHECK_THROWS_AS(read_mesh(path), BadInput);
    CHECK_THROWS_WITH(read_mesh(path), Contains(reason) && Contains(name));
  };
  const std::string good = binary_stl(folder, block({1, 1, 1}));
  CHECK_THROWS_WITH(read_mesh((folder.path() / "none.stl").string()), Contains("no such file"));
  CHECK_THROWS_AS(read_mesh(folder.path().string()), BadInput);
  refused("kind.ply", "ply", "only .stl and .obj");
  refused("empty.stl", "", "0 bytes");
  refused("empty.obj", "", "no faces");
  refused("cut.stl", good.substr(0, good.size() - 7), "truncated");
  refused("long.stl", good + std::string(50, 'x'), "damaged");
  std::string bogus = good;
  std::memset(bogus.data() + 80, 0xff, 4);  // 2^32 - 1 triangles
  refused("bogus.stl", bogus, "4294967295");
  std::string nothing = good.substr(0, 84);
  std::memset(nothing.data() + 80, 0, 4);
  refused("nothing.stl", nothing, "no triangles");
  std::string nan = good;
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(nan.data() + 84 + 50 * 2 + 12, &bad, 4);
  refused("nan.stl", nan, "triangle 3");
  const std::string text = ascii_stl(block({1, 1, 1}));
  refused("cut-text.stl", text.substr(0, text.size() / 2), "");
  refused("nan-text.stl", "solid\nfacet\nouter loop\nvertex 0 0 nan\n", "not finite");
  refused("word.stl", "solid\nfacet\nouter loop\nvertex 0 0 high\n", "high");
  refused("two.stl", "solid\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendsolid\n", "3 corners");
  refused("line.stl", "solid\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 0 0\nendloop\nendsolid\n",
          "no triangle has");
  refused("index.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "index.obj:3");
  refused("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "vertex '0'");
  refused("back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "vertex '-4'");
  refused("short.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "fewer than three");
  refused("number.obj", "v 0 0\n", "without three numbers");
  refused("huge.obj", "v 0 0 0\nv 1e308 0 0\nv -1e308 1e308 0\nf 1 2 3\n", "1e150");
}

TEST_CASE("Files with damaged bytes are read or refused without other exceptions") {
  const ScratchDirectory folder;
  const std::string originals[] = {binary_stl(folder, block({1, 1, 1})), ascii_stl(block({1, 1, 1})), cube_of_quads};
  int refused = 0;
  for (int k = 0; k < 3000; ++k) {
    std::string bytes = originals[k % 3];
    const auto draw = [&](std::uint32_t d) { return uniform(5, Stream::place, k, d); };
    for (std::uint32_t hit = 0; hit < 4; ++hit) {
      bytes[static_cast<std::size_t>(draw(2 * hit) * static_cast<double>(bytes.size()))] =
          static_cast<char>(256 * draw(2 * hit + 1));
    }
    bytes.resize(static_cast<std::size_t>(static_cast<double>(bytes.size()) * (k % 2 ? 1 : draw(9))));
    const std::string path = written(folder, k % 3 == 2 ? "f.obj" : "f.stl", bytes);
    try {
      read_solid(path);
    } catch (const BadInput&) {
      ++refused;
    }
  }
  CHECK(refused > 1000);  // at least every truncated STL file
}

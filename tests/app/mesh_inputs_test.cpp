// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes in another unit, frame or position than the machine's: reported, and corrected by keys of the case.
#include "core/geometry/mesh_frame.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/mesh/stl.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <numbers>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

constexpr double right = std::numbers::pi / 2;

/// A case with the liners of crush.yaml as meshes.
struct MeshCrusher : Workplace {
  MeshCrusher() {
    std::filesystem::copy(GYRO_APP_CASES "/stl.yaml", path());
    REQUIRE(gyrosim("liners '" GYRO_APP_CASES "/crush.yaml' --out liners").code == 0);
  }
  /// Draws a liner again: shifted first, then rotated, then scaled, the reverse of what the keys do.
  void redraw(const std::string& liner, const Vec3d& shift, const Vec3d& rotate, double scale) const {
    const std::string file = (path() / "liners" / (liner + ".stl")).string();
    const TriangleMesh moved = framed(read_mesh(file).mesh, {.shift = shift});
    write_stl(file, framed(moved, {.scale = scale, .rotate = rotate}));
  }
  void redraw_both(const Vec3d& shift, const Vec3d& rotate, double scale) const {
    redraw("concave", shift, rotate, scale);
    redraw("mantle", shift, rotate, scale);
  }
  std::string set(const std::string& key, const std::string& value) const {
    return " --set walls.concave." + key + "='" + value + "' --set walls.mantle." + key + "='" + value + "'";
  }
};

}  // namespace

TEST_CASE("Liners drawn in mm, with y upwards and beside the axis, are corrected by scale, rotate and shift") {
  const MeshCrusher place;
  const Outcome as_drawn = place.gyrosim("liners stl.yaml --out o --json");
  place.redraw_both({-0.3, 0.2, -0.1}, {-right, 0, 0}, 1000);
  const std::string keys = place.set("scale", "0.001") + place.set("rotate", "[90 deg, 0, 0]") +
                           place.set("shift", "[300 mm, -200 mm, 0.1]");
  const Outcome mended = place.gyrosim("liners stl.yaml --out p --json" + keys);
  INFO(mended.err);
  REQUIRE(mended.code == 0);
  const nlohmann::json a = nlohmann::json::parse(as_drawn.out), b = nlohmann::json::parse(mended.out);
  for (const char* figure : {"closed_side_setting", "open_side_setting", "volume", "capacity_tph"})
    CHECK(b[figure].get<double>() == Approx(a[figure].get<double>()).epsilon(1e-4));
  CHECK(a["notes"].size() == 3);  // extents of both, and the lift
  CHECK_THAT(a["notes"][0].get<std::string>(), Contains("concave.stl: x -240.") && Contains("z 0..400 mm"));

  const Outcome resolved = place.gyrosim("check stl.yaml" + keys);
  CHECK(resolved.code == 0);
  CHECK_THAT(resolved.out, Contains("scale: 0.001") && Contains("shift: [0.3, -0.2, 0.1]"));
  const Outcome plane = place.gyrosim(
      "check stl.yaml --set walls.floor='{plane: {point: [0,0,0], normal: [0,0,1]}, "
      "material: steel, scale: 2}'");
  CHECK(plane.code == 2);
  CHECK_THAT(plane.err, Contains("needs the key stl"));
}

TEST_CASE("Liners in the coordinates of a mine are brought to the axis by shift") {
  const MeshCrusher place;
  place.redraw_both({-2048, 2048, 0}, {0, 0, 0}, 1);
  const Outcome mended = place.gyrosim("liners stl.yaml --out p --json" + place.set("shift", "[2048 m, -2048 m, 0]"));
  INFO(mended.err);
  REQUIRE(mended.code == 0);
  CHECK(nlohmann::json::parse(mended.out)["closed_side_setting"].get<double>() == Approx(0.015).margin(1e-5));
  const Outcome refused = place.gyrosim("check stl.yaml" + place.set("shift", "[2e7 m, 0, 0]"));
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("shift[0] = 2e7 m is out of range; it must be between"));
  CHECK(place.gyrosim("check stl.yaml --set crusher.closed_side_setting='2048 m'").code == 2);
}

TEST_CASE("Liners in another frame are refused or noted, with the file and the key that corrects it") {
  const MeshCrusher place;
  SECTION("millimetres") {
    place.redraw_both({0, 0, 0}, {0, 0, 0}, 1e4);
    const Outcome refused = place.gyrosim("check stl.yaml");
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("concave.stl") && Contains("larger than 1 km") && Contains("scale"));
  }
  SECTION("y upwards") {
    place.redraw_both({0, 0, 0}, {-right, 0, 0}, 1);
    const Outcome doubted = place.gyrosim("check stl.yaml");
    CHECK_THAT(doubted.out + doubted.err, Contains("concave.stl: its axis seems to be y") &&
                                              Contains("walls.concave.rotate: [90 deg, 0, 0]") &&
                                              Contains("mantle.stl: its axis seems to be y"));
  }
  SECTION("beside the axis") {
    place.redraw("concave", {0.02, 0, 0}, {0, 0, 0}, 1);
    const Outcome doubted = place.gyrosim("liners stl.yaml --out o");
    CHECK_THAT(doubted.out + doubted.err, Contains("concave.stl: its middle is at x = 20 mm") &&
                                              Contains("walls.concave.shift") && !Contains("mantle.stl: its middle"));
  }
  SECTION("too low") {
    place.redraw("mantle", {0, 0, -0.1}, {0, 0, 0}, 1);
    const Outcome doubted = place.gyrosim("liners stl.yaml --out o");
    CHECK_THAT(doubted.out, Contains("moved by more than a tenth of the concave's height"));
  }
}

TEST_CASE("A wall in millimetres with small rock gives a note") {
  const Workplace place;
  place.write("case.yaml",
              "time: {duration: 1 ms}\n"
              "materials:\n  rock: {density: 2600, shear_modulus: 1e8, poisson_ratio: 0.3}\n"
              "contacts:\n  rock/rock: {friction: 0.5, restitution: 0.5}\n"
              "walls: {hopper: {stl: hopper.stl, material: rock}}\n"
              "particles: {file: p.csv}\n");
  place.write("p.csv", "id,x,y,z,r\n1,0,0,10,0.01\n");
  place.write("hopper.stl",
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex -30 -30 0\nvertex 30 -30 0\nvertex 0 30 1\nendloop\n"
              "endfacet\nendsolid a\n");
  const Outcome doubted = place.gyrosim("check case.yaml");
  CHECK(doubted.code == 0);
  CHECK_THAT(doubted.out, Contains("hopper.stl: x -30..30, y -30..30, z 0..1 m"));
  CHECK_THAT(doubted.out,
             Contains("hopper.stl: 60 m long, 3e+03 times the largest rock") && Contains("walls.hopper.scale: 0.001"));
  const Outcome mended = place.gyrosim("check case.yaml --set walls.hopper.scale=0.001");
  CHECK(mended.code == 0);
  CHECK_THAT(mended.out, Contains("x -30..30, y -30..30, z 0..1 mm") && !Contains("times the largest rock"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// H7 through the program: beds on both sides of a thin wall.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <sstream>

namespace {

using namespace gyro;

/// A square of half a metre at each height.
std::string squares(std::initializer_list<double> heights) {
  std::ostringstream stl;
  stl << "solid s\n";
  const auto facet = [&](const char* a, const char* b, const char* c, double z) {
    stl << "facet\nouter loop\n";
    for (const char* corner : {a, b, c}) stl << "vertex " << corner << ' ' << z << '\n';
    stl << "endloop\nendfacet\n";
  };
  for (const double z : heights) {
    facet("-0.25 -0.25", "0.25 -0.25", "0.25 0.25", z);
    facet("-0.25 -0.25", "0.25 0.25", "-0.25 0.25", z);
  }
  stl << "endsolid s\n";
  return stl.str();
}

/// Balls of 20 mm, so soft that an impact at 1 m/s lasts 2 ms, hit a thin wall or a plate.
Outcome thrown(const Workplace& place, std::initializer_list<double> heights, const std::string& balls) {
  place.write("s.stl", squares(heights));
  place.write("p.csv", "id,x,y,z,r,vx,vy,vz\n" + balls);
  place.write("c.yaml", R"(case: {title: thin wall}
time: {duration: 5 ms}
gravity: [0, 0, 0]
materials:
  rock:  {density: 2600 kg/m3, shear_modulus: 5 MPa, poisson_ratio: 0.3}
  steel: {density: 7800 kg/m3, shear_modulus: 70 GPa, poisson_ratio: 0.3}
contacts:
  rock/rock:  {friction: 0.5, restitution: 0.9}
  rock/steel: {friction: 0.5, restitution: 0.9}
walls: {plate: {stl: s.stl, material: steel}}
particles: {file: p.csv}
output: {series: 0.5 ms, probes: [1]}
)");
  return place.gyrosim("run c.yaml --out r --overwrite");
}

const std::string above = "1,0.01,0.02,0.0125,0.01,0,0,-1\n", below = "2,0.012,0.02,-0.0125,0.01,0,0,1\n",
                  far_below = "2,0.05,0.02,-0.0125,0.01,0,0,1\n";

}  // namespace

TEST_CASE("H7 a run in which particles touch through a thin wall is stopped with the pair", "[hard]") {
  const Workplace place;
  const Outcome run = thrown(place, {0}, above + below);
  INFO(run.err);
  CHECK(run.code == 4);
  const auto summary = summary_of(place.path() / "r");
  CHECK(summary["status"] == "stopped");
  const std::string reason = summary["reason"];
  INFO(reason);
  CHECK(reason.find("touch each other through wall plate") != std::string::npos);
  CHECK(
      (reason.find("particles 1 and 2") != std::string::npos || reason.find("particles 2 and 1") != std::string::npos));
}

TEST_CASE("H7 a plate thicker than the overlaps, or a gap between the balls, separates the sides", "[hard]") {
  const Workplace place;
  const auto course = [&](std::initializer_list<double> heights, const std::string& balls) {
    const Outcome run = thrown(place, heights, balls);
    INFO(run.err);
    REQUIRE(run.code == 0);
    return result_of(place.path() / "r", "series/probe_1_velocity");
  };
  CHECK(course({1e-3, -1e-3}, above + below) == course({1e-3, -1e-3}, above));
  CHECK(course({0}, above + far_below) == course({0}, above));
}

TEST_CASE("H7 particles may touch beside a thin wall", "[hard]") {
  const Workplace place;
  // They collide at the height of the wall, 3 mm beyond its rim, and touch the wall and each other.
  const Outcome run = thrown(place, {0}, "1,0.253,0,0.0125,0.01,0,0,-1\n2,0.253,0,-0.0125,0.01,0,0,1\n");
  INFO(run.err);
  CHECK(run.code == 0);
}

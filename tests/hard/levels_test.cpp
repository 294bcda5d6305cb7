// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of rocks that move as rigid bodies while they are loaded little: the cases in which their loads are
// sudden, local or large.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double hold = 4e-6;  // [s]; bonds take four steps in it

Scene rock_scene(bool levels) {
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.05;
  Scene scene = bonded_scene(hold, bonds, {0.5, 0.25, 0.001});
  scene.substeps = 4;
  if (levels) scene.rigid = rigid_pieces(bonds);
  return scene;
}

struct Hit {
  std::int64_t broken = 0, rigid_before = 0;
  double kinetic = 0, residual = 0;  ///< at the end; residual the largest [J]
};

/// A lattice of 64 particles falls on the floor on a corner. @param speed  [m/s]
Hit on_floor(double speed, bool levels) {
  Scene scene = rock_scene(levels);
  scene.walls = {floor_plane()};
  NewRock rock = placed(lattice(0, 4), 0, 0, {0, 0, 0.095}, rotation_about({0.6, 0.8, 0}, 0.6));
  scatter_strength(rock);
  for (NewParticle& p : rock.particles) p.velocity = {0, 0, -speed};
  Stage stage(scene, Precision::double_);
  stage.insert({rock});
  Hit hit;
  bool touched = false;
  for (int w = 0; w < 80; ++w) {
    touched = touched || stage.dem().energy().contact_elastic > 0;
    if (!touched) hit.rigid_before = stage.dem().counts().rigid_particles;
    stage.advance(50);
    hit.residual = std::max(hit.residual, std::abs(stage.dem().energy().residual()));
  }
  const Counts counts = stage.dem().counts();
  const EnergyTerms e = stage.dem().energy();
  hit.broken = counts.broken_tension + counts.broken_shear;
  hit.kinetic = e.kinetic;
  return hit;
}

}  // namespace

TEST_CASE("H5 a rigid rock that hits a wall breaks as one with bonds does, and its energy balances", "[hard][levels]") {
  const double speed = GENERATE(2.0, 10.0, 30.0);
  const double start = 0.5 * 64 * mass_of(lattice(0, 1).particles[0]) * speed * speed;
  const Hit rigid = on_floor(speed, true), bonded = on_floor(speed, false);
  INFO(speed << " m/s: " << rigid.broken << " and " << bonded.broken << " broken, residual " << rigid.residual / start
             << " and " << bonded.residual / start << ", kinetic " << rigid.kinetic / start << " and "
             << bonded.kinetic / start);
  CHECK(rigid.rigid_before == 64);
  CHECK(bonded.rigid_before == 0);
  CHECK(rigid.residual < 0.01 * start);
  CHECK(std::abs(static_cast<double>(rigid.broken - bonded.broken)) <= 0.15 * static_cast<double>(bonded.broken) + 2);
  // In between it depends on which bonds are left.
  if (bonded.broken == 0 || bonded.broken == 144) CHECK(rigid.kinetic == Approx(bonded.kinetic).margin(0.03 * start));
}

namespace {

struct FirstBreak {
  double force = 0, time = 0;  ///< of the plate [N], [s]
  ParticleId i = 0, j = 0;
};

/// A plate presses a corner particle that hangs on two bonds, of a block that rests on a floor.
FirstBreak pressed_corner(bool levels, double& rigid_share) {
  Scene scene = rock_scene(levels);
  NewRock rock = placed(block(0, {3, 3, 3}), 0, 0, {0, 0, 0.5 * grain});
  const auto corner = static_cast<Index>(rock.particles.size() - 1);  // the highest in x, y and z
  // The corner moves out along x, so that the plate meets it alone, and loses the bond below.
  for (NewBond& b : rock.bonds) b.strength = 1;
  const auto below = std::find_if(rock.bonds.begin(), rock.bonds.end(), [&](const NewBond& b) {
    const auto at = [&](Index n) { return rock.particles[static_cast<std::size_t>(n)].position; };
    return b.j == corner && std::abs(at(b.i).z - at(b.j).z) > 0.5 * grain;
  });
  const auto place = static_cast<Index>(below - rock.bonds.begin());
  rock.bonds.erase(below);
  for (Index& begin : rock.colour_begin) begin -= begin > place;
  const Vec3d top = rock.particles[static_cast<std::size_t>(corner)].position;
  scene.walls = {floor_plane(),
                 {"punch",
                  TriangleMesh{{{top.x - 0.4 * grain, top.y - 0.4 * grain, top.z + 0.5 * grain},
                                {top.x - 0.4 * grain, top.y + grain, top.z + 0.5 * grain},
                                {top.x + grain, top.y, top.z + 0.5 * grain}},
                               {{0, 1, 2}}},
                  LinearMotion{{0, 0, -0.05}}, 1}};
  scene.gravity = {0, 0, -9.81};
  Stage stage(scene, Precision::double_);
  stage.insert({rock});
  FirstBreak first;
  int windows = 0;
  double rigid = 0;
  while (stage.dem().counts().broken_tension + stage.dem().counts().broken_shear == 0 && stage.time() < 0.05) {
    stage.advance(10);
    rigid += static_cast<double>(stage.dem().counts().rigid_particles) / 27;
    ++windows;
    first.force = stage.dem().wall_loads()[1].force.z;
  }
  rigid_share = rigid / windows;
  const std::vector<Breakage> broken = stage.dem().take_breakages();
  if (!broken.empty()) first.time = broken.front().time, first.i = broken.front().i, first.j = broken.front().j;
  return first;
}

}  // namespace

TEST_CASE("A corner particle on two bonds breaks off a rigid rock at the same load", "[hard][levels]") {
  double rigid_share = 0, none_rigid = 0;
  const FirstBreak rigid = pressed_corner(true, rigid_share), bonded = pressed_corner(false, none_rigid);
  INFO("rigid " << rigid.force << " N at " << rigid.time << " s (" << rigid.i << ", " << rigid.j << "), bonded "
                << bonded.force << " N at " << bonded.time << " s (" << bonded.i << ", " << bonded.j << "); rigid for "
                << rigid_share);
  REQUIRE(bonded.time > 0);
  CHECK(rigid_share > 0.3);
  CHECK(none_rigid == 0);
  CHECK(rigid.i == bonded.i);
  CHECK(rigid.j == bonded.j);
  CHECK(rigid.force == Approx(bonded.force).epsilon(0.03));
}

TEST_CASE("H8 a rigid rock pressed to overlaps of a third of a radius gives its energy back", "[hard][levels]") {
  Scene scene = rock_scene(false);
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 1e12;
  scene.rigid = rigid_pieces(*scene.bonds);
  scene.pairs.assign(4, {0, 1, 0});
  // Along y the lower plate comes nearer by 0.7 R and goes back; nothing rubs where it also moves along x.
  scene.walls = {{"lower", PlaneShape{{0, -1.5 * grain, 0}, {0, 1, 0}}, CircularMotion{0.175 * grain, 0.02}, 1},
                 {"upper", PlaneShape{{0, 1.5 * grain, 0}, {0, -1, 0}}, Fixed{}, 1}};
  Stage stage(scene, Precision::double_);
  stage.insert({lattice(0, 3)});
  double deepest = 0, stored = 0, residual = 0, fastest = 0;
  for (int w = 0; w < 100; ++w) {
    stage.advance(50);
    CHECK(stage.dem().counts().rigid_particles == 27);
    deepest = std::max(deepest, stage.dem().extremes().overlap_ratio);
    stored = std::max(stored, stage.dem().energy().contact_elastic);
    residual = std::max(residual, std::abs(stage.dem().energy().residual()));
    fastest = std::max(fastest, norm(stage.dem().particles().velocity[0]));
  }
  INFO("overlap " << deepest << " R, stored " << stored << " J, residual " << residual << " J, " << fastest << " m/s");
  CHECK(deepest > 0.3);
  CHECK(residual < 0.01 * stored);
  CHECK(std::abs(stage.dem().energy().wall_work) < 0.01 * stored);
}

TEST_CASE("H12 pieces with packed-in overlap part and become rigid without gaining energy", "[hard][levels]") {
  // Overlaps of 0.2, 1 and 5 % of the radius; as contacts the larger ones would throw spheres apart at up to 4 m/s.
  const double overlap = GENERATE(0.002, 0.01, 0.05);
  Scene scene = rock_scene(true);
  scene.dt = 2e-6;
  scene.bonds->damping = 0.1;
  scene.rigid = rigid_pieces(*scene.bonds);
  scene.rigid->calm_time = 2e-4;
  NewRock rock = lattice(0, 4, {.bond_radius = grain / 4});
  for (NewParticle& p : rock.particles) p.position = (1 - overlap / 2) * p.position;
  for (NewBond& b : rock.bonds) b.length *= 1 - overlap / 2;
  const auto side = [&](Index n) { return rock.particles[static_cast<std::size_t>(n)].position.x > 0; };
  for (NewBond& b : rock.bonds)
    if (side(b.i) != side(b.j)) b.strength = 1e-3;
  for (NewParticle& p : rock.particles) p.velocity = {p.position.x > 0 ? 0.05 : -0.05, 0, 0};
  const double kinetic = 0.5 * 64 * mass_of(rock.particles[0]) * 0.05 * 0.05;
  Stage stage(scene, Precision::double_);
  stage.insert({rock});
  std::int64_t pieces = 0;
  double largest = 0, residual = 0;
  for (int w = 0; w < 400; ++w) {
    stage.advance(20);
    const EnergyTerms e = stage.dem().energy();
    largest = std::max(largest, e.kinetic);
    residual = std::max(residual, std::abs(e.residual()));
    if (stage.dem().counts().broken_tension > 0) pieces = std::max(pieces, stage.dem().counts().rigid_particles);
  }
  const Counts counts = stage.dem().counts();
  INFO(overlap << ": kinetic " << largest / kinetic << ", residual " << residual / kinetic << ", rigid " << pieces
               << ", broken " << counts.broken_tension + counts.broken_shear);
  CHECK(counts.broken_tension + counts.broken_shear >= 16);
  CHECK(pieces == 64);
  CHECK(largest < 1.05 * kinetic);
  CHECK(residual < 0.02 * kinetic);
}

TEST_CASE("H30 a rigid rock that is not finite is reported with an id", "[hard][levels]") {
  Scene scene = rock_scene(true);
  NewRock rock = placed(lattice(0, 3), 0, 100, {0, 0, 1});
  for (NewParticle& p : rock.particles) p.velocity = {0, 0, std::numeric_limits<double>::infinity()};
  Stage stage(scene, Precision::mixed);
  stage.insert({rock});
  stage.advance(10);
  const Extremes x = stage.dem().extremes();
  CHECK_FALSE(x.finite);
  CHECK(x.culprit >= 100);
  CHECK(x.culprit < 127);
}

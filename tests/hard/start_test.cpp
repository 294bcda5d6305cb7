// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases that the program must refuse before the first step: large overlaps, rock in or behind walls.
#include "app/simulation/start_check.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// The reason why a start state is refused; empty if it is accepted.
std::string refusal(const Scene& scene, const std::vector<NewRock>& rocks) {
  try {
    check_start(scene, rocks);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return {};
}

std::vector<NewRock> one_at(const Vec3d& position) {
  return {sphere(5, position, {0, 0, 0}, 0.01, 2600)};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("H11 a start state with overlaps is refused with the pair and the overlap", "[hard]") {
  const double ratio = GENERATE(0.01, 0.02, 0.05, 0.1, 0.3, 0.5, 1.5), small = GENERATE(1.0, 0.1, 0.02);
  const double r = 0.01, s = small * r;
  std::vector<NewRock> rocks{sphere(4, {0, 0, 0.1}, {0, 0, 0}, r, 2600),
                             sphere(9, {0, r + s - ratio * s, 0.1}, {0, 0, 0}, s, 2600),
                             sphere(11, {0.1, 0, 0.5}, {0, 0, 0}, r, 2600)};
  const std::string why = refusal(plain_scene(1e-6), rocks);
  INFO(why);
  CHECK(contains(why, "particles 4 and 9 overlap by"));
  CHECK(contains(why, "m/s"));
}

TEST_CASE("H11 particles that touch, are bonded or lie as in a settled bed are accepted", "[hard]") {
  Scene scene = plain_scene(1e-6);
  for (const double overlap : {-1e-3, 0.0, 1e-5, 1e-3})
    CHECK(refusal(scene, {sphere(0, {0, 0, 0}, {0, 0, 0}, 0.01, 2600),
                          sphere(1, {0.01 * (2 - overlap), 0, 0}, {0, 0, 0}, 0.01, 2600)})
              .empty());
  scene.bonds = paper_bonds();
  NewRock rock = lattice(0, 3);
  for (NewParticle& p : rock.particles) p.position = 0.95 * p.position;
  CHECK(refusal(scene, {rock}).empty());
  rock.bonds.erase(rock.bonds.begin() + 7);  // one pair of the rock without its bond
  CHECK(contains(refusal(scene, {rock}), "overlap by"));
}

TEST_CASE("H34 a sphere that starts in, behind or through a wall is refused", "[hard]") {
  Scene scene = plain_scene(1e-6);
  scene.walls = {floor_plane(),
                 {"thin", TriangleMesh{{{0.2, -1, 0}, {0.2, 1, 0}, {0.2, 1, 2}, {0.2, -1, 2}}, {{0, 1, 2}, {0, 2, 3}}},
                  Fixed{}, 1},
                 {"tube", ProfileShape{{{0.5, -1}, {0.5, 2}}}, Fixed{}, 1}};
  CHECK(refusal(scene, one_at({0, 0, 0.01})).empty());
  CHECK(contains(refusal(scene, one_at({0, 0, 0.0095})), "particle 5 overlaps wall floor"));
  for (const double z : {-0.001, -0.02, -50.0}) CHECK(contains(refusal(scene, one_at({0, 0, z})), "behind wall floor"));
  for (const double x : {0.195, 0.2, 0.2085})
    CHECK(contains(refusal(scene, one_at({x, 0, 0.5})), "particle 5 overlaps wall thin"));
  CHECK(contains(refusal(scene, one_at({0.495, 0, 0.5})), "particle 5 overlaps wall tube"));
  for (const double x : {0.505, 0.52}) CHECK(contains(refusal(scene, one_at({x, 0, 0.5})), "behind wall tube"));
}

TEST_CASE("H27 twenty thousand spheres at one point are refused immediately", "[hard]") {
  std::vector<NewRock> rocks;
  for (ParticleId k = 0; k < 20'000; ++k) rocks.push_back(sphere(k, {0.1, 0.2, 0.3}, {0, 0, 0}, 0.01, 2600));
  CHECK(contains(refusal(plain_scene(1e-6), rocks), "particles 0 and 1 overlap"));
}

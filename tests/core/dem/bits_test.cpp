// SPDX-License-Identifier: GPL-3.0-or-later
// Threads, skins, order of insertion, windows and removed rock change no bit of the results.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/state/pieces.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double dt = 2e-6;

/// A box with eight breaking rocks and a cloud of single spheres under gravity, with friction.
Scene busy_scene() {
  Scene scene = plain_scene(dt);
  scene.gravity = {0, 0, -9.81};
  scene.pairs.assign(4, {0.5, 0.25, 0.02});
  scene.wall_impulses = true;
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0.05;
  scene.bonds->tensile_strength = 1e5;
  scene.bonds->shear_strength = 1e5;
  scene.walls = box({0.2, 0.2, 0.3});
  scene.walls[5].motion = LinearMotion{{0, 0, -0.5}};
  return scene;
}

std::vector<NewRock> busy_rocks(int layers = 10) {
  std::vector<NewRock> rocks;
  NewRock cube = lattice(0, 3);
  scatter_strength(cube);
  for (int k = 0; k < 8; ++k) {
    const double x = k % 2 ? 0.0385 : -0.0385, y = k / 2 % 2 ? 0.0385 : -0.0385, z = k / 4 ? -0.18 : -0.2615;
    NewRock rock = placed(cube, k, static_cast<ParticleId>(1000 * (k + 1)), {x, y, z + 0.001 * (k % 3)});
    for (NewParticle& p : rock.particles) p.velocity = {-200 * x, -200 * y, k / 4 ? -8.0 : -20.0};
    rocks.push_back(rock);
  }
  for (NewRock& s : cloud({{11, 11, layers}, 0.028, 0.0115, 1.0}, 20000)) {
    s.particles[0].position.z += 0.14;
    rocks.push_back(s);
  }
  return rocks;
}

struct Outcome {
  ParticleSnapshot particles;
  std::vector<WallLoad> walls;
  std::vector<Breakage> breakages;
  double residual;
  std::vector<WallImpulse> impulses;
};

Outcome outcome(const Scene& scene, Precision precision, int threads, const std::vector<NewRock>& rocks,
                int steps = 300, int window = 100) {
  const auto dem = make_cpu_dem(scene, precision, threads);
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, steps, window);
  return {dem->particles(), dem->wall_loads(), dem->take_breakages(), dem->energy().residual(),
          dem->take_wall_impulses()};
}

bool same_loads(const std::vector<WallLoad>& a, const std::vector<WallLoad>& b) {
  for (std::size_t w = 0; w < a.size(); ++w)
    if (!same(a[w].force, b[w].force) || !same(a[w].torque, b[w].torque) || a[w].work != b[w].work) return false;
  return a.size() == b.size();
}

bool same_breakages(const std::vector<Breakage>& a, const std::vector<Breakage>& b) {
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    if (a[k].time != b[k].time || a[k].i != b[k].i || a[k].j != b[k].j || a[k].mode != b[k].mode ||
        a[k].energy != b[k].energy || !same(a[k].position, b[k].position))
      return false;
  return a.size() == b.size();
}

bool same_impulses(const std::vector<WallImpulse>& a, const std::vector<WallImpulse>& b) {
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    if (a[k].wall != b[k].wall || !same(a[k].centre, b[k].centre) || !same(a[k].impulse, b[k].impulse) ||
        a[k].slip != b[k].slip)
      return false;
  return a.size() == b.size();
}

void check_same(const Outcome& a, const Outcome& b) {
  CHECK(same_impulses(a.impulses, b.impulses));
  CHECK(same_bits(a.particles, b.particles));
  CHECK(same_loads(a.walls, b.walls));
  CHECK(same_breakages(a.breakages, b.breakages));
}

}  // namespace

TEST_CASE("The number of threads changes no bit", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const ContactModel model =
      GENERATE(ContactModel{}, ContactModel{NormalModel::hysteretic, RollingModel::spring_dashpot});
  Scene scene = busy_scene();
  for (PairProperties& pair : scene.pairs) pair.model = model;
  const Outcome one = outcome(scene, precision, 1, busy_rocks(), 150);
  REQUIRE(one.breakages.size() > 20);
  REQUIRE(one.particles.size() > 1400);
  REQUIRE(norm(one.walls[4].force) > 0);
  for (const int threads : {2, 3, 7}) {
    INFO(threads << " threads");
    const Outcome other = outcome(scene, precision, threads, busy_rocks(), 150);
    check_same(one, other);
    CHECK(one.residual == other.residual);
  }
}

TEST_CASE("The failure criterion of Mohr and Coulomb: no bit changes with threads, nor without friction",
          "[dem][bits][bond]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  Scene scene = busy_scene();
  const Outcome constant = outcome(scene, precision, 1, busy_rocks(3), 150);
  scene.bond_model.failure = BondFailure::mohr_coulomb;
  check_same(constant, outcome(scene, precision, 1, busy_rocks(3), 150));
  scene.bonds->internal_friction = 1;
  const Outcome one = outcome(scene, precision, 1, busy_rocks(3), 150);
  REQUIRE(one.breakages.size() > 20);
  CHECK(!same_breakages(one.breakages, constant.breakages));
  for (const int threads : {2, 7}) {
    INFO(threads << " threads");
    check_same(one, outcome(scene, precision, threads, busy_rocks(3), 150));
  }
}

TEST_CASE("A rock so large that all threads share its bonds: their number changes no bit", "[dem][bits][bond]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  Scene scene = plain_scene(dt);
  scene.pairs.assign(4, {0.5, 0.25, 0.02});
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0.05;
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 3e6;
  scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1}};
  scene.substeps = GENERATE(1, 3);
  NewRock block = placed(lattice(0, 15), 0, 0, {0, 0, 7.51 * grain}, rotation_about({1, 0, 0}, 0.02));
  REQUIRE(static_cast<Index>(block.bonds.size()) >= large_rock);
  add_rigid_motion(block, {0, 0, -12}, {0, 0, 0});
  const std::vector<NewRock> rocks{block, placed(lattice(1, 3), 1, 10000, {0, 0, 17 * grain})};
  const Outcome one = outcome(scene, precision, 1, rocks, 60, 30);
  REQUIRE(one.breakages.size() > 20);
  for (const int threads : {2, 7}) check_same(one, outcome(scene, precision, threads, rocks, 60, 30));
}

TEST_CASE("The skin of the neighbour lists changes no bit", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  Scene scene = busy_scene();
  const Outcome automatic = outcome(scene, precision, 1, busy_rocks(3));
  REQUIRE(automatic.impulses.size() > 100);
  for (const double skin : {2e-5, 3e-3, 2e-2}) {
    INFO("skin " << skin);
    scene.neighbour_skin = skin;
    const Outcome other = outcome(scene, precision, 1, busy_rocks(3));
    check_same(automatic, other);
    CHECK(automatic.residual == other.residual);
  }
}

TEST_CASE("The order of insertion changes no bit", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  std::vector<NewRock> rocks = busy_rocks(3);
  const Outcome given = outcome(busy_scene(), precision, 1, rocks);
  std::reverse(rocks.begin(), rocks.end());
  check_same(given, outcome(busy_scene(), precision, 1, rocks));
  for (std::size_t k = 0; k < rocks.size(); ++k) std::swap(rocks[k], rocks[(7 * k + 3) % rocks.size()]);
  check_same(given, outcome(busy_scene(), precision, 1, rocks));
}

TEST_CASE("The length of windows changes no bit of the rock", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const Outcome a = outcome(busy_scene(), precision, 1, busy_rocks(3), 400, 400);
  const Outcome b = outcome(busy_scene(), precision, 1, busy_rocks(3), 400, 7);
  CHECK(same_bits(a.particles, b.particles));
}

TEST_CASE("Removing rock changes no bit of rock that it does not touch", "[dem][bits]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const auto far_sphere = [](ParticleId id) {
    return sphere(id, {5, 0, 0.05 * double(id - 16000)}, {0, 0, 0}, 0.01, 2600);
  };
  const NewRock far_rock = placed(lattice(0, 3), 99, 15000, {-5, 0, 0});
  std::vector<NewRock> rocks = busy_rocks(3), more;
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    if (k % 50 == 3) more.push_back(far_sphere(static_cast<ParticleId>(16000 + k / 50)));
    if (k == 4) more.push_back(far_rock);
    more.push_back(rocks[k]);
  }
  Scene scene = busy_scene();
  scene.walls.erase(scene.walls.begin(), scene.walls.begin() + 2);  // far rock is outside the box
  const auto alone = make_cpu_dem(scene, precision, 1), visited = make_cpu_dem(scene, precision, 1);
  alone->insert(rocks);
  visited->insert(more);
  std::int64_t step = 0, other_step = 0;
  run(*alone, dt, step, 200);
  run(*visited, dt, other_step, 200);
  std::vector<ParticleId> leaving;
  for (const ParticleId id : visited->particles().id)
    if (id >= 15000 && id < 20000) leaving.push_back(id);
  REQUIRE(leaving.size() > 27);
  const double residual = visited->energy().residual();
  visited->remove(leaving);
  CHECK(visited->energy().residual() == Approx(residual).margin(1e-9 * visited->energy().kinetic));
  CHECK(same_bits(alone->particles(), visited->particles()));
  run(*alone, dt, step, 200);
  run(*visited, dt, other_step, 200);
  CHECK(same_bits(alone->particles(), visited->particles()));
  CHECK(alone->counts().bonds_intact == visited->counts().bonds_intact);
  CHECK(same_breakages(alone->take_breakages(), visited->take_breakages()));
}

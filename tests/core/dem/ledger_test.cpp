// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of energy and momentum with walls that move, and walls of different kinds.
#include "app/verify/fixtures/gyrating_gap.hpp"
#include "app/verify/fixtures/plate_crush.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

struct Crush {
  double work, residual, released;  ///< [J]
  std::int64_t broken;
};

Crush crush(Precision precision, double dt) {
  const PlateCrush crush(dt);
  const auto dem = make_cpu_dem(crush.scene, precision, 1);
  dem->insert(std::vector{crush.rock});
  std::int64_t step = 0;
  run(*dem, dt, step, std::llround(PlateCrush::duration / dt));
  const EnergyTerms e = dem->energy();
  return {e.wall_work, e.residual(), e.bond_breakage, dem->counts().broken_tension + dem->counts().broken_shear};
}

}  // namespace

TEST_CASE("The energies of a crushed rock add up to the work of the plates", "[dem][ledger]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const Crush coarse = crush(precision, 2e-6), fine = crush(precision, 2.5e-7);
  for (const Crush& c : {coarse, fine}) {
    INFO("residual " << c.residual / c.work << " of " << c.work << " J, " << c.broken << " bonds");
    REQUIRE(c.broken > 20);
    CHECK(c.work > 0.5);
    CHECK(c.released > 0);
    CHECK(std::abs(c.residual) < 5e-3 * c.work);
  }
  CHECK(std::abs(fine.residual) < 0.5 * std::abs(coarse.residual));
}

TEST_CASE("The forces on walls are opposite to those on the rock", "[dem][ledger]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  Scene scene = plain_scene(5e-6);
  scene.pairs.assign(4, {0.4, 0.3, 0.01});
  scene.walls = box({0.0445, 0.0445, 0.0445});
  scene.walls[0].motion = LinearMotion{{1, 0, 0}};
  const auto dem = make_cpu_dem(scene, precision, 1);
  dem->insert(cloud({{3, 3, 3}, 0.029, 0.014, 3.0}));
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 300);
  const int steps = 1000;
  const Vec3d p0 = dem->momentum();
  run(*dem, scene.dt, step, steps, steps);
  Vec3d walls{0, 0, 0};
  double largest = 0;
  for (const WallLoad& w : dem->wall_loads()) {
    walls += w.force;
    largest = std::max(largest, norm(w.force));
  }
  REQUIRE(largest > 0.1);
  const Vec3d gained = dem->momentum() - p0;
  const double time = steps * scene.dt;
  CHECK(norm(gained + time * walls) < (precision == Precision::double_ ? 1e-10 : 1e-6) * largest * time);
}

TEST_CASE("A plane, a flat mesh and a flat profile act as the same floor", "[dem][walls]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double dt = 5e-6;
  const ProfileShape profile{{{0, 0}, {0.7, 0}, {3, 0}}};
  ParticleSnapshot first;
  WallLoad first_load;
  for (int kind = 0; kind < 3; ++kind) {
    Scene scene = plain_scene(dt);
    scene.gravity = {0, 0, -9.81};
    scene.pairs.assign(4, {0.4, 0.6, 0.01});
    scene.walls = {kind == 1 ? floor_mesh(2) : floor_plane()};
    if (kind == 2) scene.walls[0].shape = profile;
    const auto dem = make_cpu_dem(scene, precision, 1);
    const std::vector<NewRock> spheres{sphere(0, {0.3, 0.2, 0.0101}, {1, -0.4, -0.5}, 0.01, 2600, {5, 6, 7}),
                                       sphere(1, {-0.5, 0.2, 0.0202}, {0.1, 0.4, -0.1}, 0.02, 2600),
                                       sphere(2, {0.5, 0.9, 0.0100}, {-1, -1, -0.2}, 0.01, 2600)};
    dem->insert(spheres);
    std::int64_t step = 0;
    run(*dem, dt, step, 6000, 6000);
    const ParticleSnapshot s = dem->particles();
    if (kind == 0) {
      first = s;
      first_load = dem->wall_loads()[0];
      continue;
    }
    for (std::size_t k = 0; k < s.size(); ++k) {
      CHECK(norm(s.position[k] - first.position[k]) < 1e-12);
      CHECK(norm(s.velocity[k] - first.velocity[k]) < 1e-11);
      CHECK(norm(s.angular_velocity[k] - first.angular_velocity[k]) < 1e-8);
    }
    CHECK(norm(dem->wall_loads()[0].force - first_load.force) < 1e-9 * norm(first_load.force));
  }
}

TEST_CASE("A smooth sphere oscillates in a horizontal tube as a pendulum", "[dem][walls]") {
  // The tube is a profile about z, gravity points along -x: a pendulum of length tube - radius.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double dt = 1e-5, tube = 0.1, radius = 0.02, g = 9.81, angle = 0.05;
  Scene scene = plain_scene(dt);
  scene.gravity = {-g, 0, 0};
  scene.pairs.assign(4, {0, 0.5, 0});
  scene.walls = {{"tube", ProfileShape{{{tube, -1}, {tube, 1}}}, Fixed{}, 1}};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const double length = tube - radius;
  const std::vector<NewRock> one{
      sphere(0, {-length * std::cos(angle), length * std::sin(angle), 0.1}, {0, 0, 0}, radius, 2600)};
  dem->insert(one);
  std::int64_t step = 0;
  double crossing = 0;
  for (int crossings = 0; crossings < 5;) {  // the fifth crossing is after 2 1/4 periods
    const double y = dem->particles().position[0].y;
    run(*dem, dt, step, 10);
    const double now = dem->particles().position[0].y;
    if ((y > 0) != (now > 0)) {
      ++crossings;
      crossing = (static_cast<double>(step) - 10 * now / (now - y)) * dt;
    }
    REQUIRE(step < 400000);
  }
  const double period = 2 * M_PI * std::sqrt(length / g) * (1 + angle * angle / 16);
  CHECK(crossing == Approx(2.25 * period).epsilon(1e-3));
}

TEST_CASE("Work of a gyrating mantle is its torque times its speed, and the ledger contains it",
          "[dem][ledger][walls]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double dt = 5e-6, speed = 60;
  const GyratingGap gap(dt);
  const auto dem = make_cpu_dem(gap.scene, precision, 1);
  dem->insert(gap.spheres);
  const double tilt = std::asin(GyratingGap::motion.eccentricity / GyratingGap::motion.pivot_height);
  const double sigma = speed * std::cos(tilt);  // locked to the eccentric: the spin is `speed` about z
  double work = 0, biggest = 0;
  for (int k = 0; k < 100; ++k) {
    const Window window{k * 200, 200, dt};
    dem->advance(window, {speed * window.begin(), speed, sigma * window.begin(), sigma});
    const WallLoad load = dem->wall_loads()[0];
    CHECK(load.work == Approx(-load.torque.z * speed * window.length()).margin(1e-9));
    work += load.work;
    biggest = std::max(biggest, std::abs(load.work));
  }
  REQUIRE(biggest > 1e-3);
  const EnergyTerms e = dem->energy();
  CHECK(e.wall_work == Approx(work));
  CHECK(std::abs(e.residual()) < 5e-3 * (e.contact_damping + e.friction + e.kinetic));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The solver on an executor that has a device's rules but needs no device.
#include "tests/gpu/mirror.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/base/errors.hpp"

#include <array>

using namespace gyro;
using namespace gyro::test;

namespace {

template <class Real>
Outcome on_mirror(const Scene& scene) {
  DeviceMemory::instance().forget();
  DemSolver<Mirror, Real> dem(scene, Mirror{});
  return break_rocks(dem);
}

}  // namespace

TEST_CASE("The host never touches device memory, and one lane gives the bits of packs", "[gpu]") {
  // Packs of bonds against single bonds, forward against backward, many threads against one.
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  Scene scene = breaking_scene();
  scene.substeps = GENERATE(1, 3);
  const Outcome cpu = break_rocks(*make_cpu_dem(scene, precision, 2));
  require_busy(cpu);
  check_same(cpu, precision == Precision::mixed ? on_mirror<float>(scene) : on_mirror<double>(scene));
}

TEST_CASE("A large rock has the same bits on an executor that works on the bonds of a colour in any order", "[gpu]") {
  NewRock block = placed(lattice(0, 15, {0.01, 0.004}), 0, 0, {0, 0, 0.0763}, rotation_about({1, 0, 0}, 0.02));
  REQUIRE(static_cast<Index>(block.bonds.size()) >= large_rock);
  add_rigid_motion(block, {0, 0, -40}, {0, 0, 0});
  Scene scene = breaking_scene();
  scene.walls.resize(1);
  scene.substeps = GENERATE(1, 3);
  const Window window{.first_step = 0, .steps = 60, .dt = breaking_dt};
  const auto cpu = make_cpu_dem(scene, Precision::mixed, 2);
  DeviceMemory::instance().forget();
  DemSolver<Mirror, float> mirror(scene, Mirror{});
  for (Dem* dem : {cpu.get(), static_cast<Dem*>(&mirror)}) {
    dem->insert(std::array{block});
    dem->advance(window, {});
  }
  const std::vector<Breakage> broken = cpu->take_breakages();
  CHECK(broken.size() > 20);
  CHECK(same_breakages(broken, mirror.take_breakages()));
  const ParticleSnapshot a = cpu->particles(), b = mirror.particles();
  CHECK(same_bytes(a.position, b.position));
  CHECK(same_bytes(a.velocity, b.velocity));
  CHECK(same_bytes(a.angular_velocity, b.angular_velocity));
  CHECK(same_bytes(a.force, b.force));
}

TEST_CASE("Bonds of one colour that share a particle are refused", "[gpu]") {
  const auto dem = make_cpu_dem(breaking_scene(), Precision::mixed, 1);
  std::vector<NewRock> rocks{lattice(0, 3, {0.01, 0.004})};
  rocks[0].colour_begin = {0, static_cast<Index>(rocks[0].bonds.size())};
  CHECK_THROWS_AS(dem->insert(rocks), BadInput);
  rocks[0].colour_begin = {};
  CHECK_THROWS_AS(dem->insert(rocks), BadInput);
  CHECK(dem->counts().particles == 0);
}

TEST_CASE("Energy, extremes and momentum of a window are read from one sum of each kind", "[gpu]") {
  DeviceMemory::instance().forget();
  DemSolver<Mirror, float> dem(breaking_scene(), Mirror{});
  dem.insert(falling_rocks(0, 0, 0.045));
  std::int64_t step = 0;
  run(dem, breaking_dt, step, 1500, 150);
  REQUIRE(dem.energy().contact_elastic > 0);
  const std::int64_t before = Mirror::counts.reads;
  const Balance all = dem.balance();
  CHECK(Mirror::counts.reads - before == 4);  // particles, contacts, stiffest contacts, bonds
  CHECK(same_bytes(std::vector{all.energy}, std::vector{dem.energy()}));
  CHECK(same_extremes({all.extremes}, {dem.extremes()}));
  CHECK(norm2(all.momentum - dem.momentum()) == 0);
  CHECK(all.extremes.overlap_ratio > 0);
  CHECK(norm2(all.momentum) > 0);
}

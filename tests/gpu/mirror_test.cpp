// SPDX-License-Identifier: GPL-3.0-or-later
// The solver on an executor that has a device's rules but needs no device.
#include "tests/gpu/mirror.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/base/errors.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

template <class Real>
Outcome on_mirror() {
  DeviceMemory::instance().forget();
  DemSolver<Mirror, Real> dem(breaking_scene(), Mirror{});
  return break_rocks(dem);
}

}  // namespace

TEST_CASE("The host never touches device memory, and one lane gives the bits of packs", "[gpu]") {
  // Packs of bonds against single bonds, forward against backward, many threads against one.
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  const Outcome cpu = break_rocks(*make_cpu_dem(breaking_scene(), precision, 2));
  require_busy(cpu);
  check_same(cpu, precision == Precision::mixed ? on_mirror<float>() : on_mirror<double>());
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

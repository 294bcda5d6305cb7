// SPDX-License-Identifier: GPL-3.0-or-later
// The memory that `check` expects, against peaks of `bench speed`.
#include "app/assembly/expected_bytes.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

/// One thread, 100 steps after 100, near commit 4476e09: by how much the process grew at its peak.
struct Peak {
  const char* scene;
  double particles, bonds;
  double mixed, double_;  ///< bytes a particle
};
constexpr Peak peaks[] = {
    {"S1", 20000, 0, 1575, 1985}, {"S2", 20000, 62733, 1042, 1151}, {"S2r", 19040, 59500, 1038, 1148}};
constexpr double program = 5e6;  ///< pages of the program and its libraries in each (tests/bench/README.md)

}  // namespace

TEST_CASE("The memory that is expected is the measured peak, or up to an eighth more") {
  for (const Peak& peak : peaks)
    for (const Precision precision : {Precision::mixed, Precision::double_}) {
      INFO(peak.scene << ", " << to_string(precision));
      const double measured = peak.particles * (precision == Precision::mixed ? peak.mixed : peak.double_) - program;
      const double share = measured / expected_bytes(peak.particles, peak.bonds, precision);
      CHECK(share < 1);
      CHECK(share > 0.875);
    }
}

TEST_CASE("Expected memory is in proportion to the rock, and bonds that leave fewer pairs are counted") {
  const auto bytes = [](double particles, double bonds) { return expected_bytes(particles, bonds, Precision::mixed); };
  CHECK(bytes(0, 0) == 0);
  CHECK(bytes(2e6, 6e6) == Approx(2 * bytes(1e6, 3e6)));
  CHECK(bytes(1e6, 3e6) < bytes(1e6, 1e6));
  CHECK(bytes(1e6, 8e6) > bytes(1e6, 5e6));
}

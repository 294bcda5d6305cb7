// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of cases/verification, run by the program: probes at the end against closed forms.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;

namespace {

struct Expected {
  std::string name, quantity;
  int axis;
  double value, tolerance;
};

}  // namespace

TEST_CASE("The cases of cases/verification give what their README says") {
  const double g = 9.81, v = 5.0 / 7, a = g * (0.5 - 0.1 * std::sqrt(0.75));
  const auto e = GENERATE_COPY(values<Expected>({
      {"impact", "velocity", 2, 0.1, 2e-4},
      {"oblique-impact", "velocity", 0, 0.8948 * 3.9 * std::sqrt(0.75), 1e-3},
      {"oblique-impact", "spin", 1, 355.2, 5e-3},
      {"spinning-impact", "velocity", 0, 0.12, 1e-4},
      {"spinning-impact", "spin", 1, 19.86, 2e-4},
      {"spinning-pair", "spin", 2, 22.86, 1e-14},
      {"sliding-to-rolling", "velocity", 0, v, 1e-4},
      {"rolling-stop", "position", 0, 7 * 0.04 / (10 * 0.05 * g), 2e-4},
      {"incline", "velocity", 0, 0.2 * a, 1e-4},
      {"belt", "velocity", 0, 2.0 / 7, 2e-4},
      {"turntable", "position", 0, 0.1, 2e-4},
  }));
  CAPTURE(e.name, e.quantity);
  const Workplace place;
  const Outcome outcome = place.gyrosim("run '" GYRO_CASES "/verification/" + e.name + ".yaml' --quiet --out run");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const std::vector<double> rows = result_of(place.path() / "run", "series/probe_0_" + e.quantity);
  REQUIRE(rows.size() >= 3);
  CHECK(rows[rows.size() - 3 + static_cast<std::size_t>(e.axis)] == Approx(e.value).epsilon(e.tolerance));
}

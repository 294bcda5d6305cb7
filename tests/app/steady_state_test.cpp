// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/steady_state.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

namespace gyro {
namespace {

/// A chamber that fills: hold-up and power approach their end with a time constant, in gyrations.
std::vector<GyrationMeans> filling(int count, double constant) {
  std::vector<GyrationMeans> gyrations;
  for (int k = 0; k < count; ++k) {
    const double full = 1 - std::exp(-k / constant);
    const double noise = 0.1 * std::sin(1.7 * k);
    gyrations.push_back({0.375 * k, 0.375 * (k + 1), 300e3 * full * (1 + noise), 20e3 * full, 300 * full});
  }
  return gyrations;
}

}  // namespace

TEST_CASE("A filling chamber becomes steady, and its means are those of the end") {
  const auto steady = steady_state(filling(200, 10));
  REQUIRE(steady);
  CHECK(steady->from > 0.375 * 5);
  CHECK(steady->from < 0.375 * 60);
  CHECK(steady->power == Approx(300e3).epsilon(0.02));
  CHECK(steady->throughput == Approx(800).epsilon(0.02));  // 300 kg in 0.375 s
  CHECK(*steady->residence_time == Approx(25).epsilon(0.02));
}

TEST_CASE("A run too short for its chamber is not steady") {
  CHECK_FALSE(steady_state(filling(30, 60)));
  CHECK_FALSE(steady_state(filling(9, 0.1)));  // fewer gyrations than can be judged
  CHECK_FALSE(steady_state({}));
}

TEST_CASE("Power that jumps in between is seen") {
  std::vector<GyrationMeans> gyrations = filling(60, 0.1);
  for (std::size_t k = 50; k < gyrations.size(); ++k) gyrations[k].power *= 2;
  const auto steady = steady_state(gyrations);
  REQUIRE(steady);
  CHECK(steady->from > 0.375 * 45);  // a few gyrations of before drown in the noise
  CHECK(steady->from < 0.375 * 52);
}

TEST_CASE("Windows add up to gyrations") {
  GyrationReader reader;
  const double speed = 160 * std::numbers::pi / 30, length = 0.5e-3;
  double time = 0;
  for (int k = 0; k < 3010; ++k) {
    time += length;
    reader.add(time, length, speed * time, 1000 + time, 50, 7 * time);
  }
  REQUIRE(reader.gyrations().size() == 4);  // 1.5 s at 0.375 s
  const GyrationMeans& second = reader.gyrations()[1];
  CHECK(second.begin == Approx(0.375).margin(1e-3));
  CHECK(second.end == Approx(0.75).margin(1e-3));
  CHECK(second.power == Approx(1000 + 0.5625).margin(1e-2));
  CHECK(second.holdup == Approx(50));
  CHECK(second.discharged == Approx(7 * 0.375).epsilon(1e-2));
}

}  // namespace gyro

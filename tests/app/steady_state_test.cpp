// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/steady_state.hpp"

#include "app/output/motor_rows.hpp"
#include "core/fragments/sieve_curve.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

namespace gyro {
namespace {

/// A chamber that fills: hold-up and power approach their end with a time constant, in gyrations.
GyrationRecord filling(int count, double constant) {
  GyrationRecord record;
  for (int k = 0; k < count; ++k) {
    const double full = 1 - std::exp(-k / constant);
    const double noise = 0.1 * std::sin(1.7 * k);
    record.gyrations.push_back({0.375 * k, 0.375 * (k + 1), 300e3 * full * (1 + noise), 20e3 * full, 300 * full});
  }
  return record;
}

}  // namespace

TEST_CASE("A filling chamber becomes steady, and its means are those of the end") {
  const auto steady = steady_state(filling(200, 10));
  REQUIRE(steady);
  CHECK(steady->from > 0.375 * 5);
  CHECK(steady->from < 0.375 * 60);
  CHECK(steady->power.value == Approx(300e3).epsilon(0.02));
  CHECK(steady->throughput.value == Approx(800).epsilon(0.02));  // 300 kg in 0.375 s
  CHECK(*steady->residence_time == Approx(25).epsilon(0.02));
}

TEST_CASE("A run too short for its chamber is not steady") {
  CHECK_FALSE(steady_state(filling(30, 60)));
  CHECK_FALSE(steady_state(filling(9, 0.1)));  // too few gyrations
  CHECK_FALSE(steady_state({}));
}

TEST_CASE("A jump of the power in between is detected") {
  GyrationRecord record = filling(60, 0.1);
  for (std::size_t k = 50; k < record.gyrations.size(); ++k) record.gyrations[k].power *= 2;
  const auto steady = steady_state(record);
  REQUIRE(steady);
  CHECK(steady->from > 0.375 * 45);  // the noise hides a few earlier gyrations
  CHECK(steady->from < 0.375 * 52);
}

TEST_CASE("Windows add up to gyrations") {
  GyrationReader reader;
  const double speed = 160 * std::numbers::pi / 30, length = 0.5e-3;
  double time = 0;
  for (int k = 0; k < 3010; ++k) {
    time += length;
    const std::vector<double> sieves{3 * time, 4 * time};
    reader.add({time, length, speed * time, 1000 + time, 2000 + time, 50, 7 * time, sieves});
  }
  REQUIRE(reader.record().gyrations.size() == 4);  // 1.5 s at 0.375 s
  const GyrationMeans& second = reader.record().gyrations[1];
  CHECK(second.begin == Approx(0.375).margin(1e-3));
  CHECK(second.end == Approx(0.75).margin(1e-3));
  CHECK(second.power == Approx(1000 + 0.5625).margin(1e-2));
  CHECK(second.holdup == Approx(50));
  CHECK(second.discharged == Approx(7 * 0.375).epsilon(1e-2));
  CHECK(second.motor_power == Approx(2000 + 0.5625).margin(1e-2));
  REQUIRE(reader.record().sieve_mass.size() == 8);
  CHECK(reader.record().sieve_mass[3] == Approx(4 * 0.375).epsilon(1e-2));
}

TEST_CASE("A run that is not steady reports the reason") {
  using Catch::Matchers::Contains;
  CHECK_THAT(unsteady_reason({}), Contains("too short: 0 gyrations, at least 10"));
  CHECK_THAT(unsteady_reason(filling(9, 0.1)), Contains("too short: 9 gyrations"));
  CHECK_THAT(unsteady_reason(filling(30, 60)), Contains("still filling"));
  GyrationRecord emptying = filling(30, 0.1);
  for (std::size_t k = 0; k < 30; ++k) emptying.gyrations[k].holdup = 1000 - 20.0 * static_cast<double>(k);
  REQUIRE_FALSE(steady_state(emptying));
  CHECK_THAT(unsteady_reason(emptying), Contains("emptying"));
  GyrationRecord running_up = filling(30, 0.1);
  double time = 0;
  for (std::size_t k = 0; k < 30; ++k) {
    running_up.gyrations[k].begin = time;
    running_up.gyrations[k].end = time += 1.0 / (1.0 + static_cast<double>(k));
  }
  REQUIRE_FALSE(steady_state(running_up));
  CHECK_THAT(unsteady_reason(running_up), Contains("speed of the drive"));
  GyrationRecord rising = filling(30, 0.1);
  for (std::size_t k = 0; k < 30; ++k) rising.gyrations[k].power = 1000 + 200.0 * static_cast<double>(k);
  REQUIRE_FALSE(steady_state(rising));
  CHECK_THAT(unsteady_reason(rising), Contains("power still changes"));
}

TEST_CASE("Standard errors are those of blocks of whole gyrations") {
  // 20 gyrations of 0.5 s in ten blocks of two. Power +-1 and +-3 by block; the discharge is proportional to it, so
  // that the specific energy is the same in all blocks.
  GyrationRecord record;
  const std::vector<double> by_block{-1, 3, 1, -3, -1, 3, 1, -3, -1, 1};
  for (std::size_t k = 0; k < 20; ++k) {
    const double power = 1000 + 10 * by_block[k / 2];
    record.gyrations.push_back({0.5 * static_cast<double>(k), 0.5 * static_cast<double>(k + 1), power, 40, power / 100,
                                3000 - 2 * by_block[k / 2]});
    for (std::size_t sieve = 0; sieve <= sieve_series().size(); ++sieve)
      record.sieve_mass.push_back(sieve == 4 || sieve == 8 ? power / 200 : 0);
  }
  const std::vector<double> sizes{sieve_series()[5]};
  const auto steady = steady_state(record, sizes);
  REQUIRE(steady);
  CHECK(steady->from == 0);
  CHECK(steady->gyrations == 20);
  CHECK(steady->blocks == 10);
  double squares = 0;
  for (const double b : by_block) squares += b * b;
  const double error = std::sqrt(squares / 9 / 10);  // of a mean of ten whose own mean is 0
  CHECK(steady->power.value == Approx(1000));
  CHECK(steady->power.error == Approx(10 * error));
  CHECK(steady->motor_power.error == Approx(2 * error));
  CHECK(steady->throughput.value == Approx(20));
  CHECK(steady->throughput.error == Approx(10 * error / 50));
  REQUIRE(steady->specific_energy);
  CHECK(steady->specific_energy->value == Approx(50));
  CHECK(steady->specific_energy->error == Approx(0).margin(1e-9));
  REQUIRE(steady->p80);
  CHECK(steady->p80->value > sieve_series()[7]);
  CHECK(steady->p80->value < sieve_series()[8]);
  CHECK(steady->p80->error == Approx(0).margin(1e-12));
  CHECK(steady->below[0]->value == Approx(0.5));
}

TEST_CASE("A product that differs from block to block has an error of its sizes") {
  GyrationRecord record;
  for (std::size_t k = 0; k < 10; ++k) {
    record.gyrations.push_back({0.5 * static_cast<double>(k), 0.5 * static_cast<double>(k + 1), 1000, 40, 10, 0});
    for (std::size_t sieve = 0; sieve <= sieve_series().size(); ++sieve)
      record.sieve_mass.push_back(sieve == 4 + k / 2 % 2 ? 10 : 0);
  }
  const auto steady = steady_state(record);
  REQUIRE(steady);
  CHECK(steady->blocks == 5);
  CHECK(steady->p80->error > 0.005 * steady->p80->value);
  CHECK(steady->p80->error < 0.2 * steady->p80->value);
  GyrationRecord none = filling(20, 0.1);  // nothing is discharged
  for (GyrationMeans& g : none.gyrations) g.discharged = 0;
  CHECK_FALSE(steady_state(none)->specific_energy);
  CHECK_FALSE(steady_state(none)->p80);
}

TEST_CASE("The motor's figures are those of the rows since a time") {
  MotorRows rows;
  CHECK_FALSE(rows.figures(0, {}));
  for (int k = 0; k < 200; ++k) {
    rows.add(0.5e-3, k < 100 ? 9000 : k - 100);  // two windows in each row; the run-up comes first
    rows.add(0.5e-3, k < 100 ? 9000 : k - 98);
    rows.end_row(1e-3 * (k + 1));
  }
  SavedState saved;
  rows.save(saved);
  MotorRows again;
  again.restore(saved);
  const auto late = again.figures(0.1, 500.0), all = again.figures(0, {});
  REQUIRE((late && all));
  CHECK(late->from == 0.1);
  CHECK(late->mean == Approx(50.5));  // 1 to 100
  CHECK(late->p95 == Approx(95));
  CHECK(late->peak == Approx(100));
  CHECK(*late->mean_fraction == Approx(0.101));
  CHECK(*late->peak_fraction == Approx(0.2));
  CHECK(all->peak == Approx(9000));
  CHECK_FALSE(all->rated_power);
  CHECK_FALSE(rows.figures(0.3, {}));
}

}  // namespace gyro

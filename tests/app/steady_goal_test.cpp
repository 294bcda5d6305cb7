// SPDX-License-Identifier: GPL-3.0-or-later
// When a run may end because its figures are known.
#include "app/output/steady_goal.hpp"

#include "core/math/random.hpp"
#include "core/rocks/strength.hpp"
#include "tests/catch.hpp"

#include <cmath>

namespace gyro {
namespace {

/// Gyrations of a steady crusher: power and discharge scatter independently, the share of coarse product too.
struct Crusher {
  std::uint64_t seed;
  double scatter = 0.3;  ///< standard deviation / mean
  GyrationRecord record = {};

  double normal(std::uint32_t draw) const {
    return normal_quantile(uniform(seed, Stream::shape, record.gyrations.size(), draw));
  }
  void gyrate() {
    const auto k = static_cast<double>(record.gyrations.size());
    const double power = 1000 * (1 + scatter * normal(0)), mass = 10 * (1 + scatter * normal(1));
    record.sieve_mass.resize(record.sieve_mass.size() + sieve_series().size() + 1, 0.0);
    double* sieves = &record.sieve_mass[record.gyrations.size() * (sieve_series().size() + 1)];
    const double coarse = 0.5 + 0.1 * normal(2);
    sieves[6] = mass * (1 - coarse);
    sieves[9] = mass * coarse;
    record.gyrations.push_back({0.5 * k, 0.5 * (k + 1), power, 500, mass, power});
  }
};

}  // namespace

TEST_CASE("A run is known to an error once the largest of three errors is below it, from twenty gyrations on") {
  Crusher crusher{1, 0.02};
  for (int k = 0; k < 19; ++k) crusher.gyrate();
  CHECK_FALSE(is_known(steady_progress(crusher.record, sieve_series()), 0.05));
  crusher.gyrate();
  const SteadyProgress now = steady_progress(crusher.record, sieve_series());
  REQUIRE(now.gyrations == 20);
  CHECK(is_known(now, now.worst()));
  CHECK_FALSE(is_known(now, 0.999 * now.worst()));
  CHECK(now.worst() == std::max({now.throughput, now.power, now.p80}));
  const auto steady = steady_state(crusher.record);
  CHECK(now.throughput == Approx(steady->throughput.error / steady->throughput.value));
  CHECK(now.power == Approx(steady->power.error / steady->power.value));
  CHECK(now.p80 == Approx(steady->p80->error / steady->p80->value));
  CHECK_THAT(to_text(now), Catch::Matchers::Matches("throughput [0-9.]+ %, crushing power [0-9.]+ %, P80 [0-9.]+ %"));
}

TEST_CASE("Without product, or before a run is steady, no error is small enough") {
  Crusher crusher{1, 0.02};
  for (int k = 0; k < 40; ++k) crusher.gyrate();
  GyrationRecord nothing = crusher.record;
  for (double& mass : nothing.sieve_mass) mass = 0;
  for (GyrationMeans& g : nothing.gyrations) g.discharged = 0;
  const SteadyProgress empty = steady_progress(nothing, sieve_series());
  CHECK(empty.gyrations == 40);
  CHECK_FALSE(is_known(empty, 0.99));
  CHECK_THAT(to_text(empty),
             Catch::Matchers::Contains("throughput not known") && Catch::Matchers::Contains("P80 not known"));
  GyrationRecord filling = crusher.record;
  for (std::size_t k = 0; k < filling.gyrations.size(); ++k) filling.gyrations[k].holdup = 10.0 * (1 + k);
  const SteadyProgress early = steady_progress(filling, sieve_series());
  CHECK_FALSE(is_known(early, 0.99));
  CHECK_THAT(to_text(early), Catch::Matchers::Contains("still filling"));
}

TEST_CASE("Runs that end by their own errors have true errors of that size") {
  // The end depends on the errors themselves, so a run tends to end where they happen to be small. With ten blocks the
  // deviation from the truth is 1.27 times the error that a run gives.
  constexpr int runs = 200;
  double squares = 0, longest = 0, shortest = 1e9;
  for (int k = 0; k < runs; ++k) {
    Crusher crusher{static_cast<std::uint64_t>(k)};
    SteadyProgress now;
    while (!is_known(now, 0.04)) {
      crusher.gyrate();
      now = steady_progress(crusher.record, sieve_series());
      REQUIRE(crusher.record.gyrations.size() < 1000);
    }
    const auto steady = steady_state(crusher.record);
    const double off = (steady->throughput.value - 20) / steady->throughput.error;  // 10 kg in 0.5 s
    squares += off * off / runs;
    longest = std::max(longest, static_cast<double>(now.gyrations));
    shortest = std::min(shortest, static_cast<double>(now.gyrations));
  }
  INFO(std::sqrt(squares) << " " << shortest << " " << longest);
  CHECK(std::sqrt(squares) < 1.5);
  CHECK(std::sqrt(squares) > 0.7);
  CHECK(shortest >= gyrations_of_errors);
  CHECK(longest < 4 * 0.3 * 0.3 / (0.04 * 0.04));
}

}  // namespace gyro

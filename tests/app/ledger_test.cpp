// SPDX-License-Identifier: GPL-3.0-or-later
// Balances that the guard accepts, and those at which it stops the run.
#include "app/simulation/ledger.hpp"
#include "app/simulation/momentum_balance.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <limits>

using namespace gyro;

namespace {

/// A window in which gravity did 1 J of work, all of it now kinetic, and `missing` J are not accounted for.
std::optional<std::string> verdict(double missing, Extremes extremes = {}) {
  Ledger ledger({}, {"floor", "belt"});
  EnergyTerms before, after;
  before.potential = before.exchanged = 1;
  ledger.open(before);
  after.exchanged = 1;
  after.kinetic = 1 + missing;
  return ledger.close(0.001, after, extremes);
}

}  // namespace

TEST_CASE("The guard accepts a balance that closes") {
  CHECK_FALSE(verdict(0));
  CHECK_FALSE(verdict(0.04));
  CHECK_FALSE(verdict(-0.04));
}

TEST_CASE("The guard stops a balance that does not close or is not a number") {
  CHECK(verdict(0.06));
  CHECK(verdict(-0.06));
  CHECK(verdict(std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("The guard detects a balance that does not close even without work") {
  for (const double missing : {0.04, -0.04, 0.06, -0.9, 30.0}) {
    Ledger ledger;
    EnergyTerms before, after;
    before.kinetic = before.exchanged = 1;
    ledger.open(before);
    after.exchanged = 1;
    after.kinetic = 0.5;
    after.contact_damping = 0.5 + missing;
    INFO(missing);
    REQUIRE_FALSE(ledger.close(0, before, {}));
    CHECK(ledger.close(0.001, after, {}).has_value() == (std::abs(missing) > 0.05));
  }
}

TEST_CASE("The guard relates the residual to the energy if there is little work") {
  // A ball with 1 J hits a floor while gravity does 0.01 J: 0.2 % of the impact's energy is not an error of the
  // balance.
  for (const double missing : {0.002, 0.06}) {
    Ledger ledger;
    EnergyTerms e;
    e.kinetic = e.exchanged = 1;
    e.potential = 0;
    ledger.open(e);
    e.potential = -0.01;
    e.kinetic = 1.01 + missing;
    INFO(missing);
    CHECK(ledger.close(0.001, e, {}).has_value() == (missing > 0.05));
  }
}

TEST_CASE("The residual is a share of the larger of work and energy, as the guard measures it") {
  Ledger ledger;
  CHECK(ledger.residual_fraction() == 0);  // neither work nor energy
  // A ball slides on a floor until it rolls: 12.9 J, while floor and gravity do 2.4e-4 J of work.
  EnergyTerms e;
  e.kinetic = e.exchanged = 12.9;
  ledger.open(e);
  e.kinetic = 12.9 * 5 / 7;
  e.friction = 12.9 * 2 / 7 - 2.7e-6;
  e.potential = -2.4e-4;
  e.wall_work = -2.4e-4;
  REQUIRE(e.residual() == Approx(-2.7e-6).epsilon(1e-6));
  REQUIRE_FALSE(ledger.close(0.001, e, {}));
  CHECK(ledger.scale() == 12.9);  // of the start; no window ended with this energy
  CHECK(ledger.residual_fraction() == Approx(-2.1e-7).epsilon(0.01));
  e.friction += 12.9 * 0.06;
  CHECK(ledger.close(0.002, e, {}));
  CHECK(ledger.residual_fraction() == Approx(0.06).epsilon(1e-3));
}

TEST_CASE("The guard allows for the lag of held contacts") {
  // A force F t^(3/2) that begins at t = 0: its work is 2/5 F t^(5/2); the balance is off by that of the last contact
  // step.
  const double held = GENERATE(0.0, 2e-6), share = GENERATE(0.9, 3.0);
  const double window = 20e-6, force = 1e9;
  LedgerLimits limits;
  limits.contact_step = held;
  Ledger ledger(limits);
  EnergyTerms e;
  ledger.open(e);
  e.wall_work = 0.4 * force * std::pow(window, 2.5);
  e.bond_elastic = e.wall_work + share * force * std::pow(window, 1.5) * 2e-6;
  INFO("off by " << e.residual() / e.wall_work << " of the work");
  CHECK(ledger.close(window, e, {}).has_value() == (held == 0 || share > 1.2));
}

TEST_CASE("The guard names the particle and the limit") {
  const auto reason = [](const Extremes& extremes) { return verdict(0, extremes).value_or("none"); };
  using Catch::Matchers::Contains;
  Extremes deep{.culprit = 17, .overlap_ratio = 0.9};
  CHECK_THAT(reason(deep), Contains("particle 17") && Contains("at most 0.8"));
  deep.wall = 0;
  CHECK_THAT(reason(deep), Contains("with wall floor"));
  CHECK_THAT(reason({.finite = false}), Contains("not finite"));
  CHECK_THAT(reason({.speed_ratio = 0.3, .fastest = 18}), Contains("particle 18 moves by 0.3"));
  CHECK_THAT(reason({.rotation = 0.2, .fastest_rotating = 19}), Contains("particle 19 rotates by 0.2"));
  CHECK_THAT(reason({.bond_rotation = 0.6, .twisted = 20}), Contains("bond of particle 20"));
  CHECK_THAT(reason({.wall_step = 0.3, .fast_wall = 1}), Contains("wall belt moves by 0.3"));
}

TEST_CASE("The momentum residual is the momentum that neither walls nor gravity have given") {
  MomentumBalance balance;
  balance.open({1, 0, 0});
  balance.close({1, 2, -1}, std::vector<Vec3d>{{0, 0, -1}, {0, 4, 0}, {0, -2, 0}});
  CHECK(balance.residual() == 0);
  balance.open({5, 0, 0});  // rock was added between the windows
  balance.close({5, 0, -0.5}, std::vector<Vec3d>{{0, 0, -1}});
  CHECK(balance.residual() == 0.5);
  CHECK(balance.residual_fraction() == 0.5 / 8);
}

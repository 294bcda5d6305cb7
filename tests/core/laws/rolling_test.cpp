// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of rolling resistance on prescribed rolling.
#include "tests/catch.hpp"

#include "core/laws/contact/models.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyro;

namespace {

using SpringLaw = ContactLaw<Hertz, SpringDashpotRolling>;

constexpr double youngs = 8.6e8, shear = 1.7e8, radius = 0.005, mass = 0.002, inertia = 2e-8, overlap = 1e-4, mu = 0.1;
const double normal_stiffness = 2 * youngs * std::sqrt(radius * overlap);
const double spring = 2.25 * normal_stiffness * std::pow(mu * radius, 2);
const double limit = mu * radius * 2.0 / 3 * normal_stiffness * overlap;

ContactConstants<double> law_with(double rolling, double dt) {
  return {youngs, shear, 0, 0, rolling, dt, 1, 1 / dt, std::sqrt(2 * youngs), std::sqrt(8 * shear)};
}

/// A contact that rolls about x, with the work done against the couple.
struct Roll {
  ContactConstants<double> law = law_with(mu, 1e-6);
  ContactHistory<double> history{{0, 0, 0}, overlap, {0, 0, 0}};
  ExtraHistory<double> extra{};
  double couple = 0, work = 0, lost = 0, damped = 0, smallest_loss = 0;

  void by(double angle, int steps, double depth = overlap) {
    const double speed = angle / (steps * law.dt);
    for (int k = 0; k < steps; ++k) {
      const ContactMotion<double> c{{0, 0, 1}, depth, {0, 0, 0}, {speed, 0, 0}, radius, mass, inertia, 0, 0};
      const Vec3d before = extra.roll_elastic + extra.roll_drag;
      const ContactLoad<double> load = SpringLaw::load(law, c, history, extra);
      work -= 0.5 * law.dt * speed * (before.x + load.couple.x);
      couple = load.couple.x;
      lost += load.slipped;
      damped += load.damped;
      smallest_loss = std::min(smallest_loss, load.slipped);
      history = load.history;
    }
  }
  double stored() const { return norm2(extra.roll_elastic) / (2 * spring); }
};

}  // namespace

TEST_CASE("The rolling spring pulls back by kr times the angle, up to its limit", "[laws][contact]") {
  Roll roll;
  roll.by(0.5 * limit / spring, 1000);
  CHECK(-roll.extra.roll_elastic.x == Approx(0.5 * limit).epsilon(1e-10));
  CHECK(std::abs(roll.lost) < 1e-12 * roll.work);
  roll.by(3 * limit / spring, 1000);
  CHECK(-roll.extra.roll_elastic.x == Approx(limit).epsilon(1e-12));
  CHECK(roll.extra.roll_drag.x == 0);  // the dashpot is off at the limit
  CHECK(-roll.couple == Approx(limit).epsilon(1e-12));
  roll.by(-0.25 * limit / spring, 1000);
  CHECK(-roll.extra.roll_elastic.x == Approx(0.75 * limit).epsilon(1e-10));
}

TEST_CASE("Work against the rolling spring is stored or lost", "[laws][contact]") {
  Roll roll;
  for (const double angle : {0.8, 1.5, -3.0, 0.4, 2.5, -0.1}) {
    roll.by(angle * limit / spring, 500);
    CHECK(roll.work == Approx(roll.stored() + roll.lost + roll.damped).epsilon(1e-9));
    CHECK(roll.smallest_loss > -1e-12 * roll.work);
    const double energy = SpringLaw::energy(roll.law, radius, roll.history.overlap, roll.history, roll.extra);
    CHECK(energy - Hertz::energy(roll.law, radius, overlap, roll.extra) == Approx(roll.stored()).epsilon(1e-6));
  }
}

TEST_CASE("A rolling spring that is unloaded returns at most the stored energy", "[laws][contact]") {
  Roll roll;
  roll.by(0.9 * limit / spring, 500);
  roll.by(0, 1, 0.25 * overlap);  // half the stiffness, an eighth of the limit
  const double after = norm(roll.extra.roll_elastic);
  CHECK(after == Approx(limit / 8).epsilon(1e-12));
  CHECK(roll.lost >= 0);
  CHECK(roll.stored() <= roll.work);
}

TEST_CASE("The rolling dashpot damps a free oscillation by 0.3 of critical", "[laws][contact]") {
  // About the contact point the reduced inertia is 7/2 I*.
  const double whole = 3.5 * inertia, omega = std::sqrt(spring / whole), eta = 0.3;
  const double damped_omega = omega * std::sqrt(1 - eta * eta), dt = 1e-3 / omega;
  ContactConstants<double> law = law_with(mu, dt);
  ContactHistory<double> history{{0, 0, 0}, overlap, {0, 0, 0}};
  ExtraHistory<double> extra{};
  extra.roll_elastic = {-0.5 * limit, 0, 0};
  double angle = 0.5 * limit / spring, speed = 0;  // released at rest
  const int steps = static_cast<int>(std::lround(2 * std::numbers::pi / damped_omega / dt));
  const double start = angle;
  for (int k = 0; k < steps; ++k) {
    const ContactMotion<double> c{{0, 0, 1}, overlap, {0, 0, 0}, {speed, 0, 0}, radius, mass, inertia, 0, 0};
    const ContactLoad<double> load = SpringLaw::load(law, c, history, extra);
    history = load.history;
    speed += dt * load.couple.x / whole;
    angle += dt * speed;
  }
  CHECK(angle / start == Approx(std::exp(-eta * omega * steps * dt)).epsilon(0.02));
}

TEST_CASE("Without rolling friction the rolling laws give no couple", "[laws][contact]") {
  const ContactMotion<double> c{{0, 0, 1}, overlap, {0.1, 0, 0.2}, {30, 40, 5}, radius, mass, inertia, radius, 0};
  ExtraHistory<double> off{}, constant{};
  const auto a = ContactLaw<Hertz, NoRolling>::load(law_with(0, 1e-6), c, {}, off);
  const auto b = ContactLaw<Hertz, ConstantRolling>::load(law_with(0, 1e-6), c, {}, constant);
  CHECK(norm(a.couple) == 0);
  CHECK(norm(b.couple) == 0);
  CHECK((a.force.x == b.force.x && a.force.z == b.force.z && a.slipped == b.slipped && a.damped == b.damped));
}

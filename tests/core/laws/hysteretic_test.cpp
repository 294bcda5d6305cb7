// SPDX-License-Identifier: GPL-3.0-or-later
// The hysteretic normal force on prescribed paths and in free impacts.
#include "tests/catch.hpp"

#include "core/laws/contact/models.hpp"

#include <algorithm>
#include <cmath>

using namespace gyro;

namespace {

using Law = ContactLaw<Hysteretic, NoRolling>;

constexpr double youngs = 8.6e8, shear = 1.7e8, radius = 0.005, mass = 0.002;
const double k1 = 4.0 / 3 * std::sqrt(0.1) * youngs * radius;

ContactConstants<double> law_with(double restitution, double dt) {
  return {youngs, shear, 0, 0.5, 0, dt, 1 / (restitution * restitution), 1 / dt, 0, 0};
}
ContactMotion<double> head_on(double overlap, double approach) {
  return {{0, 0, 1}, overlap, {0, 0, approach}, {0, 0, 0}, radius, mass, 2e-8, radius, 0};
}

/// A contact that is pressed to given overlaps, with the work done against its force.
struct Press {
  ContactConstants<double> law;
  ContactHistory<double> history{};
  ExtraHistory<double> extra{};
  double force = 0, work = 0, lost = 0, smallest_loss = 0;

  void to(double overlap, int steps) {
    const double from = history.overlap;
    for (int k = 1; k <= steps; ++k) {
      const double depth = from + (overlap - from) * k / steps;
      const ContactLoad<double> load = Law::load(law, head_on(depth, 0), history, extra);
      work += 0.5 * (force - load.force.z) * (depth - history.overlap);
      force = -load.force.z;
      lost += load.damped;
      smallest_loss = std::min(smallest_loss, load.damped);
      history = load.history;
    }
  }
  double stored() const { return Law::energy(law, radius, history.overlap, history, extra); }
};

/// Speed after over speed before an impact of the reduced mass, by velocity Verlet.
double rebound(double restitution, double speed) {
  const double dt = 1e-3 * std::sqrt(mass / k1) * restitution;
  const ContactConstants<double> law = law_with(restitution, dt);
  ContactHistory<double> history{};
  ExtraHistory<double> extra{};
  double overlap = 0, approach = speed, force = 0;
  do {
    approach -= 0.5 * dt * force / mass;
    overlap += dt * approach;
    force = 0;
    if (overlap > 0) {
      const ContactLoad<double> load = Law::load(law, head_on(overlap, approach), history, extra);
      force = -load.force.z;
      history = load.history;
    }
    approach -= 0.5 * dt * force / mass;
  } while (overlap > 0 && (approach > 0 || force > 0));
  return -approach / speed;
}

}  // namespace

TEST_CASE("Hysteretic force: loading line, steeper unloading line, and reloading along the latter", "[laws][contact]") {
  const double e = 0.5, k2 = k1 / (e * e), top = 1e-4, residual = (1 - e * e) * top;
  Press press{law_with(e, 1e-6)};
  press.to(top, 10);
  CHECK(press.force == Approx(k1 * top).epsilon(1e-12));
  press.to(0.9 * top, 10);
  CHECK(press.force == Approx(k1 * top - k2 * 0.1 * top).epsilon(1e-12));
  press.to(0.5 * (residual + top), 10);
  CHECK(press.force == Approx(0.5 * k1 * top).epsilon(1e-12));
  press.to(0.9 * residual, 10);
  CHECK(press.force == 0);
  press.to(top, 10);
  CHECK(press.force == Approx(k1 * top).epsilon(1e-12));
  press.to(1.5 * top, 10);
  CHECK(press.force == Approx(k1 * 1.5 * top).epsilon(1e-12));
}

TEST_CASE("Hysteretic loading equals Hertz's force at an overlap of a tenth of R*", "[laws][contact]") {
  const double overlap = 0.1 * radius;
  Press press{law_with(0.3, 1e-6)};
  press.to(overlap, 1);
  CHECK(press.force == Approx(4.0 / 3 * youngs * std::sqrt(radius) * std::pow(overlap, 1.5)).epsilon(1e-12));
}

TEST_CASE("Hysteresis dissipates the work that is not stored, and never adds energy", "[laws][contact]") {
  const double e = GENERATE(0.2, 0.5, 0.9, 1.0);
  Press press{law_with(e, 1e-6)};
  double from = 0;
  for (const double overlap : {1e-4, 8e-5, 9.5e-5, 2e-4, 1.99e-4, 1.5e-4, 3e-4, 2.9e-4}) {
    press.to(overlap, 400);
    INFO("e " << e << ", overlap " << overlap);
    CHECK(press.work == Approx(press.stored() + press.lost).epsilon(2e-3));
    // A step across the end of the unloading line is off by the trapezoid's error there.
    const double step = std::abs(overlap - from) / 400;
    CHECK(press.smallest_loss > -0.125 * k1 / (e * e) * step * step - 1e-12 * press.work);
    press.smallest_loss = 0;
    from = overlap;
  }
  const double loop = press.lost;
  press.to(2.95e-4, 400);  // on the unloading line nothing is lost
  press.to(2.9e-4, 400);
  CHECK(press.lost == Approx(loop).epsilon(1e-9));
}

TEST_CASE("A hysteretic impact rebounds with the restitution at any speed", "[laws][contact]") {
  const double e = GENERATE(0.2, 0.5, 0.9), speed = GENERATE(0.01, 1.0, 10.0);
  INFO("e " << e << ", speed " << speed);
  CHECK(rebound(e, speed) == Approx(e).epsilon(2e-3));
}

TEST_CASE("The limit of the step is a quarter of that of the unloading spring", "[laws][contact]") {
  const ContactStiffness s =
      contact_stiffness({NormalModel::hysteretic, RollingModel::off}, law_with(0.2, 1e-6), radius, 1e-4);
  CHECK(s.normal == Approx(16 * 25 * k1));
  CHECK(s.tangential == Approx(4 * shear / youngs * k1));
  CHECK(s.damping == 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Damping of a bond: each mode alone decays as a linear oscillator at the given fraction of critical.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

#include <functional>

using namespace gyro;
using namespace gyro::test;

namespace {

/// One mode of a pair: the acceleration of its coordinate u (a length or an angle) at rate v.
struct Mode {
  const char* name;
  double stiffness, inertia;
  std::function<double(const BondConstants<double>&, double u, double v)> load;
};

BondLoad<double> loaded(const BondConstants<double>& law, const Ends& ends, const BondRates<double>& rates) {
  return PaperBond::load(law, paper_section(), strain_of(ends), rates);
}

double along(const BondConstants<double>& law, double u, double v) {
  Ends e;
  e.j.x += u;
  return loaded(law, e, {{v, 0, 0}, {0, 0, 0}, {0, 0, 0}}).force.x;
}
/// The ends do not rotate, as if their inertia were infinite.
double across(const BondConstants<double>& law, double u, double v) {
  Ends e;
  e.j.y += u;
  return loaded(law, e, {{0, v, 0}, {0, 0, 0}, {0, 0, 0}}).force.y;
}
double turning(const BondConstants<double>& law, const Vec3d& axis, double u, double v) {
  Ends e;
  e.orientation_i = rotation_about(axis, -u / 2);
  e.orientation_j = rotation_about(axis, u / 2);
  return dot(loaded(law, e, {{0, 0, 0}, (-v / 2) * axis, (v / 2) * axis}).torque_j, axis);
}

const Mode modes[] = {
    {"normal", normal_rate, sphere_mass() / 2, along},
    {"shear", shear_rate, sphere_mass() / 2, across},
    {"bending", bend_rate, sphere_inertia() / 2,
     [](const BondConstants<double>& law, double u, double v) {
       return turning(law, {0, 1, 0}, u, v);
     }},
    {"twist", twist_rate, sphere_inertia() / 2, [](const BondConstants<double>& law, double u, double v) {
       return turning(law, {1, 0, 0}, u, v);
     }}};

/// The coordinate after a time, from u0 at rest, by the classical Runge-Kutta scheme.
double released(const Mode& mode, const BondConstants<double>& law, double u0, double time, int steps) {
  const double h = time / steps;
  double u = u0, v = 0;
  const auto f = [&](double a, double b) { return mode.load(law, a, b) / mode.inertia; };
  for (int k = 0; k < steps; ++k) {
    const double v1 = v, a1 = f(u, v), v2 = v + h / 2 * a1, a2 = f(u + h / 2 * v1, v2);
    const double v3 = v + h / 2 * a2, a3 = f(u + h / 2 * v2, v3), v4 = v + h * a3, a4 = f(u + h * v3, v4);
    u += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return u;
}

}  // namespace

TEST_CASE("Each mode of a bond decays at its fraction of critical", "[laws][bond]") {
  const double xi = GENERATE(0.0, 0.05, 0.3);
  BondConstants<double> law = paper_law();
  law.bond.damping = xi;
  for (const Mode& mode : modes) {
    INFO(mode.name);
    const double omega = std::sqrt(mode.stiffness / mode.inertia), u0 = 1e-8;
    const double damped = omega * std::sqrt(1 - xi * xi);
    for (const double periods : {0.25, 1.0, 2.6}) {
      const double t = periods * 2 * M_PI / omega;
      const double expected =
          u0 * std::exp(-xi * omega * t) * (std::cos(damped * t) + xi * omega / damped * std::sin(damped * t));
      CHECK(std::abs(released(mode, law, u0, t, 2000) - expected) < 2e-5 * u0);
    }
  }
}

TEST_CASE("The damping that a bond reports is the work of the damping loads", "[laws][bond]") {
  BondConstants<double> law = paper_law();
  law.bond.damping = 0.07;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const double arm = 0.5 + 0.3 * random_number(k, 50);
    const Ends ends = strained(k, 3e-3);
    const BondRates<double> rates{random_vector(k, 20), random_vector(k, 23), random_vector(k, 26)};
    const BondStrain<double> strain = strain_of(ends, arm);
    const BondLoad<double> with = PaperBond::load(law, paper_section(arm), strain, rates);
    const BondLoad<double> without = PaperBond::load(paper_law(), paper_section(arm), strain, rates);
    const double power = -dot(with.force - without.force, rates.velocity) -
                         dot(with.torque_i - without.torque_i, rates.angular_velocity_i) -
                         dot(with.torque_j - without.torque_j, rates.angular_velocity_j);
    CHECK(with.damped == Approx(law.dt * power).epsilon(1e-9));
    CHECK(with.damped > 0);
    CHECK(with.elastic == without.elastic);
    CHECK(with.tension_ratio == without.tension_ratio);
    CHECK(with.shear_ratio == without.shear_ratio);
  }
}

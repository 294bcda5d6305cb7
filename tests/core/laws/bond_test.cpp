// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanics of the bond law: loads from energy, momentum, frames.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

#include <functional>

using namespace gyro;
using namespace gyro::test;

namespace {

/// -dU/ds for a change of the ends by a small amount s, by central differences.
double pull_back(const Ends& ends, double arm, double h, const std::function<void(Ends&, double)>& change) {
  Ends up = ends, down = ends;
  change(up, h);
  change(down, -h);
  return -(load_of(up, paper_law(), arm).elastic - load_of(down, paper_law(), arm).elastic) / (2 * h);
}

struct Gradient {
  Vec3d force_i, force_j, torque_i, torque_j;
};

Gradient gradient(const Ends& ends, double arm) {
  const double step = 1e-9, angle = 1e-7;
  const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double f_i[3], f_j[3], m_i[3], m_j[3];
  for (int k = 0; k < 3; ++k) {
    const Vec3d a = axes[k];
    f_i[k] = pull_back(ends, arm, step, [a](Ends& e, double s) { e.i += s * a; });
    f_j[k] = pull_back(ends, arm, step, [a](Ends& e, double s) { e.j += s * a; });
    m_i[k] = pull_back(ends, arm, angle,
                       [a](Ends& e, double s) { e.orientation_i = rotation_about(a, s) * e.orientation_i; });
    m_j[k] = pull_back(ends, arm, angle,
                       [a](Ends& e, double s) { e.orientation_j = rotation_about(a, s) * e.orientation_j; });
  }
  const auto v = [](const double* c) { return Vec3d{c[0], c[1], c[2]}; };
  return {v(f_i), v(f_j), v(m_i), v(m_j)};
}

/// Largest difference of loads and gradient, torques divided by the length of the bond.
double mismatch(const Ends& ends, double arm) {
  const BondLoad<double> load = load_of(ends, paper_law(), arm);
  const Gradient g = gradient(ends, arm);
  return std::max({distance(load.force, g.force_j), distance(-load.force, g.force_i),
                   distance(load.torque_i, g.torque_i) / bond_length,
                   distance(load.torque_j, g.torque_j) / bond_length});
}

double size_of(const Ends& ends, double arm) {
  const BondLoad<double> load = load_of(ends, paper_law(), arm);
  return norm(load.force) + (norm(load.torque_i) + norm(load.torque_j)) / bond_length;
}

}  // namespace

TEST_CASE("The loads of a bond are the gradient of its energy at any strain", "[laws][bond]") {
  const double arm = GENERATE(0.5, 0.3, 0.85), strain = GENERATE(2e-3, 0.05, 0.4);
  for (std::uint64_t k = 0; k < 10; ++k) {
    const Ends ends = strained(k, strain);
    CHECK(mismatch(ends, arm) < 1e-6 * size_of(ends, arm));
  }
}

TEST_CASE("A bond conserves angular momentum", "[laws][bond]") {
  const double arm = GENERATE(0.5, 0.3, 0.85);
  BondConstants<double> law = paper_law();
  law.bond.damping = 0.1;
  for (std::uint64_t k = 0; k < 50; ++k) {
    const Ends ends = strained(k, 4e-3);
    const BondRates<double> rates{random_vector(k, 20), random_vector(k, 23), random_vector(k, 26)};
    const BondStrain<double> strain = strain_of(ends, arm);
    const BondLoad<double> intact = PaperBond::load(law, paper_section(arm), strain, rates);
    const BondLoad<double> loose = pressed_load(law, paper_section(arm), strain, rates).load;
    for (const BondLoad<double>& load : {intact, loose}) {
      const Vec3d lack = load.torque_i + load.torque_j + cross(ends.j - ends.i, load.force);
      CHECK(norm(lack) <= 1e-12 * (norm(load.torque_i) + norm(load.torque_j)));
    }
  }
}

TEST_CASE("A rigid rotation does not change the loads of a bond", "[laws][bond]") {
  const double arm = GENERATE(0.5, 0.3);
  BondConstants<double> law = paper_law();
  law.bond.damping = 0.1;
  for (std::uint64_t k = 0; k < 50; ++k) {
    const Ends ends = strained(k, 4e-3);
    const BondRates<double> rates{random_vector(k, 20), random_vector(k, 23), random_vector(k, 26)};
    const Quatd q = random_orientation(k, 30);
    const BondEnds<double> here{ends.j - ends.i, ends.orientation_i, ends.orientation_j};
    const BondEnds<double> there{rotate(q, here.span), q * here.orientation_i, q * here.orientation_j};
    const BondRates<double> rates_there{rotate(q, rates.velocity), rotate(q, rates.angular_velocity_i),
                                        rotate(q, rates.angular_velocity_j)};
    const BondLoad<double> a = PaperBond::load(law, paper_section(arm), bond_strain(paper_shape(arm), here), rates);
    const BondLoad<double> b =
        PaperBond::load(law, paper_section(arm), bond_strain(paper_shape(arm), there), rates_there);
    const double force = norm(a.force) + 1884.956, torque = norm(a.torque_i) + norm(a.torque_j) + 3.534;
    CHECK(distance(rotate(q, a.force), b.force) < 2e-12 * force);
    CHECK(distance(rotate(q, a.torque_i), b.torque_i) < 2e-12 * torque);
    CHECK(distance(rotate(q, a.torque_j), b.torque_j) < 2e-12 * torque);
    CHECK(std::abs(a.tension_ratio - b.tension_ratio) < 2e-12 * (1 + std::abs(a.tension_ratio)));
    CHECK(std::abs(a.shear_ratio - b.shear_ratio) < 2e-12 * (1 + a.shear_ratio));
    CHECK(std::abs(a.elastic - b.elastic) < 4e-12 * (1 + a.elastic));
  }
}

TEST_CASE("A rigid motion does not load a bond and is not damped", "[laws][bond]") {
  BondConstants<double> law = paper_law();
  law.bond.damping = 0.3;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const double arm = 0.5 + 0.4 * random_number(k, 40);
    const Quatd q = random_orientation(k, 0);
    Ends ends;
    ends.j = rotate(q, ends.j);
    ends.orientation_i = ends.orientation_j = q;
    const BondLoad<double> load = PaperBond::load(law, paper_section(arm), strain_of(ends, arm), {});
    CHECK(norm(load.force) < 1e-8);      // of 2827 N
    CHECK(norm(load.torque_j) < 1e-10);  // of 3.5 N m
    CHECK(load.elastic < 1e-18);

    // Half a step later than the velocity that turns it.
    const Vec3d angular_velocity = 100.0 * random_vector(k, 4);
    const BondRates<double> rates{cross(angular_velocity, ends.j - ends.i), angular_velocity, angular_velocity};
    ends.j = ends.j + (0.5 * law.dt) * rates.velocity;
    const BondLoad<double> still = PaperBond::load(law, paper_section(arm), strain_of(ends, arm), {});
    const BondLoad<double> turning = PaperBond::load(law, paper_section(arm), strain_of(ends, arm), rates);
    CHECK(norm(turning.force - still.force) < 1e-8);
    CHECK(norm(turning.torque_j - still.torque_j) < 1e-10);
    CHECK(std::abs(turning.damped) < 1e-20);
  }
}

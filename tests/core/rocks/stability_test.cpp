// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/stability.hpp"
#include "core/math/random.hpp"
#include "core/rocks/linear_rock.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/small_rocks.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

using namespace gyro;
using namespace gyro::small_rocks;

namespace {

/// Growth of the step map's state over many steps, from random velocities.
double growth(const LinearRock& rock, double dt, int steps) {
  const Eigen::Index n = rock.stiffness.rows();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n), v(n);
  for (Eigen::Index k = 0; k < n; ++k) v[k] = uniform(2, Stream::place, k, 0) - 0.5;
  const double begin = v.norm();
  constexpr double unbounded = 1e100;
  for (int s = 0; s < steps && v.norm() < unbounded; ++s) {
    v -= dt * (rock.stiffness * x + rock.damping * v);
    x += dt * v;
  }
  return v.norm() / begin;
}

}  // namespace

TEST_CASE("A pair that only stretches has the textbook limit") {
  const double r = 0.0125, b = 0.005;
  BondParameters stretch = bonds_with(0);
  stretch.shear_stiffness = 1e-3 * kn;  // bending is slower as b < R
  CHECK(critical_step(pair(r, b), stretch, no_bed) ==
        Approx(2 * r * std::sqrt(2 * rho * r / (3 * kn)) / b).epsilon(1e-4));
}

TEST_CASE("Stiffness per area and from a modulus give the same limit where they are the same stiffness") {
  const RockTemplate rock = pair(0.01, 0.005);
  const BondParameters per_area = bonds_with(0.05);
  BondParameters from_modulus = per_area;
  from_modulus.normal_stiffness = from_modulus.shear_stiffness = 0;
  from_modulus.normal_modulus = kn * rock.bonds[0].length;
  from_modulus.shear_modulus = ks * rock.bonds[0].length;
  CHECK(critical_step(rock, from_modulus, no_bed) == Approx(critical_step(rock, per_area, no_bed)).epsilon(1e-6));
  CHECK(gershgorin_step(rock, from_modulus, no_bed) == Approx(gershgorin_step(rock, per_area, no_bed)).epsilon(1e-12));
}

TEST_CASE("Shear with its arms lowers the pair's limit by 15 %") {
  const double r = 0.0125, b = 0.005, mass = 4 * std::numbers::pi / 3 * rho * r * r * r;
  const double area = std::numbers::pi * b * b;
  CHECK(critical_step(pair(r, b), bonds_with(0), no_bed) == Approx(2 / std::sqrt(7 * ks * area / mass)).epsilon(1e-4));
  CHECK(critical_step(pair(r, b), bonds_with(0), no_bed) == Approx(15.2e-6).epsilon(0.02));
}

TEST_CASE("Damping lowers a single mode's limit as (2/w)(sqrt(1 + xi^2) - xi)") {
  const double r = 0.0125, b = 0.005, xi = GENERATE(0.05, 0.2, 0.5, 2.0);
  BondParameters stretch = bonds_with(xi);
  stretch.shear_stiffness = 1e-6 * kn;
  const double undamped = 2 * r * std::sqrt(2 * rho * r / (3 * kn)) / b;
  CHECK(critical_step(pair(r, b), stretch, no_bed) == Approx(undamped * (std::sqrt(1 + xi * xi) - xi)).epsilon(1e-4));
}

TEST_CASE("Translation and rotation as a whole do not stretch bonds") {
  const RockTemplate rock =
      spheres({{0, 0, 0}, {0.02, 0.005, 0}, {0.01, 0.02, 0.012}}, {0.01, 0.012, 0.013}, {0.5, RelativeBondRadius{0.5}});
  REQUIRE(rock.bonds.size() == 3);
  const LinearRock linear = linearise(rock, bonds_with(0.05), no_bed);
  const Vec3d turn{0.3, -0.2, 0.5}, shift{1, 2, 3};
  Eigen::VectorXd motion(18), scaled(18);
  for (int p = 0; p < 3; ++p) {
    const Vec3d x = shift + cross(turn, rock.centres[p]);
    motion.segment<6>(6 * p) << x.x, x.y, x.z, turn.x, turn.y, turn.z;
  }
  scaled = motion.cwiseQuotient(linear.inverse_root_mass);
  const double size = linear.stiffness.toDense().norm() * scaled.norm();
  CHECK((linear.stiffness * scaled).norm() < 1e-13 * size);
  CHECK((linear.damping * scaled).norm() < 1e-13 * linear.damping.toDense().norm() * scaled.norm());
}

TEST_CASE("At the critical step the largest eigenvalue is 4, by a dense solver") {
  const double damping = GENERATE(0.0, 0.05, 0.5);
  const BedContacts bed{6, 5e8, 4e8, 0.3, 0.3};
  const RockTemplate rock = cluster(4, 0.02, {0.05, RelativeBondRadius{0.3}});
  const double dt = critical_step(rock, bonds_with(damping), bed);
  const LinearRock linear = linearise(rock, bonds_with(damping), bed);
  const Eigen::MatrixXd map = dt * dt * linear.stiffness.toDense() + 2 * dt * linear.damping.toDense();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(map, Eigen::EigenvaluesOnly);
  CHECK(solver.eigenvalues().maxCoeff() == Approx(4).epsilon(3e-4));
  CHECK(gershgorin_step(rock, bonds_with(damping), bed) <= dt);
  CHECK(gershgorin_step(rock, bonds_with(damping), bed) > 0.4 * dt);  // row sums count damping twice
  CHECK(gershgorin_step(rock, bonds_with(0), no_bed) > 0.55 * critical_step(rock, bonds_with(0), no_bed));
}

TEST_CASE("The step map stays bounded below the limit and grows without bound above") {
  const double damping = GENERATE(0.0, 0.05, 0.5);
  const RockTemplate rock = cluster(6, 0.025, {0.05, RelativeBondRadius{0.5}});
  const LinearRock linear = linearise(rock, bonds_with(damping), no_bed);
  const double dt = critical_step(rock, bonds_with(damping), no_bed);
  CHECK(growth(linear, 0.98 * dt, 4000) < 20);
  CHECK(growth(linear, 1.02 * dt, 4000) > 1e12);
}

TEST_CASE("Rocks of equal particles reach the published share of the pair's limit") {
  // Undamped, 2600 kg/m3, no bed; values of an independent implementation on other packings.
  struct Row {
    double diameter, factor, step;
  };
  const Row row = GENERATE(Row{8.33e-3, 1, 1.60e-6}, Row{8.33e-3, 0.5, 3.53e-6}, Row{8.33e-3, 0.1, 18.0e-6},
                           Row{25e-3, 1, 2.76e-6}, Row{25e-3, 0.5, 6.12e-6}, Row{83.3e-3, 0.5, 11.2e-6});
  const RockTemplate rock = cluster(6, row.diameter, {0.05, RelativeBondRadius{row.factor}});
  const double dt = critical_step(rock, bonds_with(0), no_bed);
  INFO("step " << dt << " against " << row.step << ", ratio " << dt / row.step);
  CHECK(dt / row.step > 0.9);
  CHECK(dt / row.step < 1.1);
}

TEST_CASE("Bonds thicker than their particles: absolute radius 5 mm") {
  struct Row {
    double diameter, step;
  };
  const Row row = GENERATE(Row{8.33e-3, 1.23e-6}, Row{25e-3, 7.71e-6}, Row{50e-3, 22.0e-6});
  const RockTemplate rock = cluster(6, row.diameter, {0.05, AbsoluteBondRadius{0.005}});
  const double ratio = critical_step(rock, bonds_with(0), no_bed) / row.step;
  INFO("ratio " << ratio);
  CHECK(ratio > 0.9);
  CHECK(ratio < 1.1);
}

TEST_CASE("Damping of each bond lowers a rock's limit more than a pair's") {
  // Measured elsewhere on one rock: 7.0-7.5, 5.5-6, 3-4, 1-2 us at 0, 5, 20, 50 %.
  const RockTemplate rock = cluster(6, 0.025, {0.05, RelativeBondRadius{0.5}});
  const double undamped = critical_step(rock, bonds_with(0), no_bed);
  const auto share = [&](double damping) { return critical_step(rock, bonds_with(damping), no_bed) / undamped; };
  CHECK(share(0.05) > 0.73);
  CHECK(share(0.05) < 0.86);
  CHECK(share(0.20) > 0.40);
  CHECK(share(0.20) < 0.57);
  CHECK(share(0.50) > 0.13);
  CHECK(share(0.50) < 0.29);
}

TEST_CASE("A small grain bonded to twenty large ones sets the limit") {
  // Large grains around a small one; they overlap each other and are bonded only to it.
  std::vector<Vec3d> centres{{0, 0, 0}};
  std::vector<double> radii{0.004};
  for (int k = 0; k < 20; ++k) {
    const double z = 1 - (2 * k + 1) / 20.0, r = std::sqrt(1 - z * z), turn = 2.399963229728653 * k;
    centres.push_back((0.004 + 0.02) * Vec3d{r * std::cos(turn), r * std::sin(turn), z});
    radii.push_back(0.02);
  }
  RockTemplate star = spheres(centres, radii, {0.05, AbsoluteBondRadius{0.005}});
  std::erase_if(star.bonds, [](const TemplateBond& b) { return b.i != 0; });
  REQUIRE(star.bonds.size() == 20);
  const double dt = critical_step(star, bonds_with(0), no_bed);
  const LinearRock linear = linearise(star, bonds_with(0), no_bed);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(linear.stiffness.toDense(), Eigen::EigenvaluesOnly);
  CHECK(dt == Approx(2 / std::sqrt(solver.eigenvalues().maxCoeff())).epsilon(1e-4));
  CHECK(dt < 0.6 * critical_step(pair(0.004, 0.005), bonds_with(0), no_bed));
  CHECK(growth(linear, 0.98 * dt, 2000) < 20);
  CHECK(growth(linear, 1.02 * dt, 2000) > 1e12);
}

TEST_CASE("A loose particle has the limit of its contacts, and a bed slows bonded ones") {
  const double r = 0.01, mass = 4 * std::numbers::pi / 3 * rho * r * r * r;
  const BedContacts push_only{6, 5e8, 0, 0, 0};  // 6 contacts, 2 of them along each direction, counterphase
  CHECK(loose_critical_step(r, rho, push_only) == Approx(2 / std::sqrt(2 * 2 * 5e8 * r / mass)).epsilon(1e-12));
  const BedContacts damped{6, 5e8, 0, 0.4, 0};
  const double stiffness = 4 * 5e8 * r / mass, damping = 4 * 2 * 0.4 * std::sqrt(5e8 * r * mass / 2) / mass;
  const double dt = loose_critical_step(r, rho, damped);
  CHECK(dt * dt * stiffness + 2 * dt * damping == Approx(4).epsilon(1e-12));
  CHECK(std::isinf(loose_critical_step(r, rho, no_bed)));
  // With almost no bond stiffness only the bed remains.
  BondParameters weak = bonds_with(0);
  weak.normal_stiffness = weak.shear_stiffness = 1;
  CHECK(critical_step(pair(r, 0.005), weak, damped) == Approx(dt).epsilon(1e-4));
  CHECK(critical_step(pair(r, 0.005), bonds_with(0.05), damped) <
        critical_step(pair(r, 0.005), bonds_with(0.05), no_bed));
}

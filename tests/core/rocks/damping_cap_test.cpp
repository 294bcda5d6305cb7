// SPDX-License-Identifier: GPL-3.0-or-later
// The stable step of rocks in a bed whose dashpots are capped.
#include "core/rocks/linear_rock.hpp"
#include "core/rocks/stability.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/small_rocks.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>

using namespace gyro;
using namespace gyro::small_rocks;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

BedContacts bed_with(double damping, double cap) {
  return {6, 5e8, 4e8, damping, damping, cap};
}

/// Largest eigenvalue of dt^2 K + 2 dt C + min(2 dt c, 2 beta), from assembled matrices.
double largest_eigenvalue(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed, double dt) {
  const LinearRock with = linearise(rock, bonds, bed), without = linearise(rock, bonds, no_bed);
  Eigen::MatrixXd map = dt * dt * with.stiffness.toDense() + 2 * dt * without.damping.toDense();
  const Eigen::VectorXd c = with.damping.toDense().diagonal() - without.damping.toDense().diagonal();
  map.diagonal() += (2 * dt * c).cwiseMin(2 * bed.damping_cap);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(map, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace

TEST_CASE("A cap on the bed's damping leaves a loose particle at least sqrt(4 - 2 beta)/omega") {
  const double r = 0.01, mass = 4 * std::numbers::pi / 3 * rho * r * r * r;
  const double beta = GENERATE(0.25, 0.5, 1.0, 1.5);
  // Only pushed: six contacts, counterphase. The rotations have no springs.
  const double omega = std::sqrt(4 * 5e8 * r / mass);
  const auto step = [&](double damping, double cap) {
    return loose_critical_step(r, rho, BedContacts{6, 5e8, 0, damping, 0, cap});
  };
  CHECK(step(0, beta) == Approx(2 / omega).epsilon(1e-12));
  CHECK(step(50, beta) == Approx(std::sqrt(4 - 2 * beta) / omega).epsilon(1e-12));
  if (beta == 1) CHECK(step(50, beta) == Approx(std::numbers::sqrt2 / 2 * 2 / omega).epsilon(1e-12));
  CHECK(step(50, infinity) < 0.05 / omega);
  CHECK(step(50, 0) == Approx(2 / omega).epsilon(1e-12));
  // Weak damping is below the cap: dt c < beta at the limit.
  const double weak = step(0.01, infinity);
  CHECK(step(0.01, beta) == weak);
  CHECK(step(50, 3) == step(50, infinity));  // at 2 already no step is stable
}

TEST_CASE("Between weak and strong damping the limit is that of the smaller term") {
  const double r = 0.01, mass = 4 * std::numbers::pi / 3 * rho * r * r * r;
  const double beta = 0.4, stiffness = 4 * 5e8 * r / mass;
  for (const double xi : {0.05, 0.1, 0.2, 0.4, 0.8, 1.6}) {
    const double dt = loose_critical_step(r, rho, BedContacts{6, 5e8, 0, xi, 0, beta});
    const double c = 4 * 2 * xi * std::sqrt(5e8 * r * mass / 2) / mass;
    CHECK(dt * dt * stiffness + std::min(2 * dt * c, 2 * beta) == Approx(4).epsilon(1e-12));
  }
}

TEST_CASE("The critical step with a cap is that of a dense solver") {
  const double beta = GENERATE(0.0, 0.1, 0.3, 1.0, infinity), damping = GENERATE(0.05, 0.5, 5.0);
  RockTemplate rock = cluster(4, 0.02, {0.05, RelativeBondRadius{0.3}});
  for (std::size_t p = 0; p < rock.radii.size(); p += 3) rock.radii[p] *= 0.7;
  const BedContacts bed = bed_with(damping, beta);
  const BondParameters bonds = bonds_with(0.1);
  const double dt = critical_step(rock, bonds, bed);
  CHECK(largest_eigenvalue(rock, bonds, bed, dt) == Approx(4).epsilon(2e-5));
  CHECK(gershgorin_step(rock, bonds, bed) <= dt);
  CHECK(gershgorin_step(rock, bonds, bed) > 0.4 * dt);
  CHECK(dt >= critical_step(rock, bonds, bed_with(damping, infinity)) * (1 - 1e-6));
  CHECK(dt <= critical_step(rock, bonds, bed_with(0, infinity)) * (1 + 1e-6));
}

TEST_CASE("The cap leaves the dampers of bonds alone") {
  const double r = 0.0125, b = 0.005, xi = GENERATE(0.0, 0.2, 2.0);
  BondParameters stretch = bonds_with(xi);
  stretch.shear_stiffness = 1e-6 * kn;
  const BedContacts capped{0, 0, 0, 0, 0, 0.01};
  // One bond between two particles: reduced mass m/2, c = 2 xi sqrt(k m/2), limit (2/w)(sqrt(1 + xi^2) - xi).
  const double mass = 4 * std::numbers::pi / 3 * rho * r * r * r, k = kn * std::numbers::pi * b * b;
  const double omega = std::sqrt(2 * k / mass), limit = 2 / omega * (std::sqrt(1 + xi * xi) - xi);
  CHECK(critical_step(pair(r, b), stretch, capped) == Approx(limit).epsilon(1e-5));
  CHECK(critical_step(pair(r, b), stretch, BedContacts{}) == Approx(limit).epsilon(1e-5));
}

TEST_CASE("Where only the capped bed acts, bonded particles have the limit of loose ones") {
  BondParameters weak = bonds_with(0);
  weak.normal_stiffness = weak.shear_stiffness = 1;
  for (const double beta : {0.2, 1.0, infinity}) {
    const BedContacts bed = bed_with(2, beta);
    CHECK(critical_step(pair(0.01, 0.005), weak, bed) == Approx(loose_critical_step(0.01, rho, bed)).epsilon(1e-5));
  }
}

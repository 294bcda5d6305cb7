// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/stability.hpp"

#include "core/math/random.hpp"
#include "core/rocks/largest_mode.hpp"
#include "core/rocks/rock_operator.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

/// The smallest step at which 4 - A(dt) is singular. Each round finds the most unstable mode at the present step, at
/// first roughly, then the step that this mode allows, which is never below the smallest. Converges quadratically.
double critical_step_of(RockOperator& rock, double guess) {
  constexpr double rough = 1e-2, tolerance = 1e-5, settled = 2e-5;
  constexpr int rounds = 30;
  Eigen::VectorXd vector(rock.size());
  for (Eigen::Index k = 0; k < vector.size(); ++k) {
    vector[k] = uniform(1, Stream::shape, static_cast<std::uint64_t>(k), 0) - 0.5;
  }
  const auto apply = [&](const Eigen::VectorXd& v, Eigen::VectorXd& image) { rock.apply(v, image); };
  double dt = guess, wanted = rough;
  for (int round = 0; round < rounds && std::isfinite(dt); ++round) {
    rock.set_step(dt);
    vector = largest_mode(apply, std::move(vector), wanted).vector;
    const double next = rock.step_of_mode(vector);
    const bool done = wanted <= tolerance && std::abs(next / dt - 1) < settled;
    dt = next;
    if (done) break;
    wanted = std::max(tolerance, 0.1 * wanted);
  }
  return dt;
}

}  // namespace

double critical_step(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed) {
  RockOperator linear(rock, bonds, bed);
  return critical_step_of(linear, gershgorin_step(rock, bonds, bed));
}

double loose_critical_step(double radius, double density, const BedContacts& bed) {
  RockTemplate single;
  single.centres = {{0, 0, 0}};
  single.radii = {radius};
  single.particle_density = density;
  return gershgorin_step(single, BondParameters{}, bed);  // exact: the matrices are diagonal
}

}  // namespace gyro

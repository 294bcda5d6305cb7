// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/motors/double_cage.hpp"

#include "mbd/motors/check.hpp"
#include "mbd/motors/induction.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace gyro {
namespace {

double sum(const DoubleCageMotor& motor, double slip) {
  return motor.inner.torque(slip) + motor.outer.torque(slip);
}

double sum_current(const DoubleCageMotor& motor, double slip) {
  return std::abs(motor.inner.current(slip) + motor.outer.current(slip));
}

/// Cages, in units of TN, for a breakdown torque of the inner cage. The outer cage's breakdown torque is chosen to meet
/// T(1), the inner cage's breakdown slip to meet T(sN). None if no such cages exist.
std::optional<DoubleCageMotor> with_inner(const DoubleCageMotor& plate, double inner_torque) {
  const double s = plate.rated_slip, outer_share = 2 * s / (1 + s * s);  // of the outer cage at sN
  const auto cages = [&](double outer_torque) -> std::optional<DoubleCageMotor> {
    const double rest = 1 - outer_torque * outer_share;  // left for the inner cage at sN
    if (!(rest > 0) || inner_torque < rest) return std::nullopt;
    const double ratio = inner_torque / rest;
    DoubleCageMotor motor = plate;
    motor.outer = {outer_torque, 1};
    motor.inner = {inner_torque, s * (ratio + std::sqrt(ratio * ratio - 1))};
    return motor;
  };
  // With a larger outer cage the inner one has less torque at sN, and T(1) rises: T(1) is monotonic, so bisect.
  double low = 0, high = std::min(plate.starting_ratio, 1 / outer_share);
  const auto too_weak = [&](double outer_torque) {
    const auto motor = cages(outer_torque);
    return motor && sum(*motor, 1) < plate.starting_ratio;
  };
  if (!cages(low)) low = std::max(0.0, (1 - inner_torque) / outer_share);
  for (int k = 0; k < 200; ++k) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (too_weak(middle) ? low : high) = middle;
  }
  const auto found = cages(low + (high - low) / 2);
  if (!found || std::abs(sum(*found, 1) - plate.starting_ratio) > 1e-9) return std::nullopt;
  return found;
}

/// First maximum of the torque as the slip rises from sN; T(1) where it only rises.
double pull_out(const DoubleCageMotor& motor) {
  constexpr int points = 2000;
  const double s0 = motor.rated_slip, step = std::log(1 / s0) / points;
  const auto at = [&](int k) { return s0 * std::exp(step * k); };
  int k = 0;
  while (k < points && sum(motor, at(k + 1)) >= sum(motor, at(k))) ++k;
  if (k == points) return sum(motor, 1);
  double low = at(std::max(k - 1, 0)), high = at(k + 1);
  constexpr double golden = 0.6180339887498949;
  for (int n = 0; n < 100; ++n) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (sum(motor, a) > sum(motor, b) ? high : low) = sum(motor, a) > sum(motor, b) ? b : a;
  }
  return sum(motor, (low + high) / 2);
}

}  // namespace

void DoubleCageMotor::check() const {
  InductionMotor{rated_power, synchronous_speed, rated_slip, breakdown_ratio}.check();
  require_positive(starting_ratio, "starting_ratio");
  require_positive(inner.breakdown_torque, "torque of the inner cage");
}

void DoubleCageMotor::complete() {
  *this = solve_cages(*this);
}

double DoubleCageMotor::torque(double speed, double voltage) const {
  return voltage * voltage * sum(*this, slip_at(speed, synchronous_speed));
}

double DoubleCageMotor::current(double speed) const {
  return sum_current(*this, slip_at(speed, synchronous_speed)) / sum_current(*this, rated_slip);
}

DoubleCageMotor solve_cages(DoubleCageMotor plate) {
  const double wanted = plate.breakdown_ratio;
  // The pull-out torque rises with the inner cage.
  double low = 0, high = wanted;
  for (int k = 0; k < 200; ++k) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    const auto motor = with_inner(plate, middle);
    (!motor || pull_out(*motor) < wanted ? low : high) = middle;
  }
  const auto found = with_inner(plate, high);
  if (!found || std::abs(pull_out(*found) / wanted - 1) > 1e-9)
    throw BadInput(
        "motor: no pair of cages has this rated_slip, breakdown_ratio and starting_ratio together; give the "
        "figures of one motor, such as 0.02, 2.1 and 2.25 (NEMA C)");
  const double rated_torque = plate.rated_torque();
  plate.inner = {found->inner.breakdown_torque * rated_torque, found->inner.breakdown_slip};
  plate.outer = {found->outer.breakdown_torque * rated_torque, found->outer.breakdown_slip};
  return plate;
}

DoubleCageMotor nema_motor(NemaDesign design, double rated_power, double synchronous_speed) {
  struct Figures {
    double slip, breakdown, starting;
  };
  constexpr Figures figures[] = {{0.015, 2.8, 1.5}, {0.015, 2.2, 1.5}, {0.02, 2.1, 2.25}, {0.065, 2.78, 2.75}};
  const Figures& f = figures[static_cast<int>(design)];
  return solve_cages({.rated_power = rated_power,
                      .synchronous_speed = synchronous_speed,
                      .rated_slip = f.slip,
                      .breakdown_ratio = f.breakdown,
                      .starting_ratio = f.starting});
}

}  // namespace gyro

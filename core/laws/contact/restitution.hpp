// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace gyro {

/// Restitution of a Hertz contact with Tsuji damping zeta whose force cannot pull.
///
///   e = exp(-2 zeta arccos(zeta)/sqrt(1 - zeta^2)) for zeta < 1, arccosh beyond; e(1) = exp(-2)
///
/// The map y ~ delta^(5/4) turns the contact into a linear oscillator (Antypov & Elliott, EPL 94
/// (2011) 50004); the contact ends where the force is zero, as Schwager & Pöschel (2007) have it for
/// the linear dashpot. The usual zeta = -ln e/sqrt(pi^2 + ln^2 e) belongs to a force that may pull:
/// with a force that cannot it rebounds at 0.325 when 0.20 was asked.
inline double restitution_of_damping(double zeta) {
  const double gap = 1 - zeta * zeta;
  if (std::abs(gap) < 1e-8) return std::exp(-2.0);
  if (gap > 0) return std::exp(-2 * zeta * std::acos(zeta) / std::sqrt(gap));
  return std::exp(-2 * zeta * std::acosh(zeta) / std::sqrt(-gap));
}

/// The zeta that gives a restitution e in (0, 1], by bisection to full precision.
inline double damping_for_restitution(double e) {
  if (e >= 1) return 0;
  double low = 0, high = 1;
  while (restitution_of_damping(high) > e) high *= 2;
  for (int k = 0; k < 200 && high - low > 1e-16 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (restitution_of_damping(middle) > e ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// How far a slice of rock sinks in one gyration: nipped at a height by a gap, it goes down until the open gap
/// has become as narrow, or as far as it falls in the time that the chamber opens.
/// @param bottom    of the chamber: nothing holds a slice that leaves it [m]
/// @param fall      g (pi/w)^2 / 2 [m]
/// @param nipped    gap of the closed side at z [m]
/// @param open_gap  of a height [m] -> [m]
template <class OpenGap>
double slice_drop(double z, double bottom, double fall, double nipped, const OpenGap& open_gap) {
  constexpr int steps = 256;
  for (int i = 1; i <= steps; ++i) {
    if (z - fall * i / steps < bottom) break;
    if (open_gap(z - fall * i / steps) > nipped) continue;
    double before = fall * (i - 1) / steps, after = fall * i / steps;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = (before + after) / 2;
      (open_gap(z - middle) > nipped ? before : after) = middle;
    }
    return after;
  }
  return fall;
}

}  // namespace gyro

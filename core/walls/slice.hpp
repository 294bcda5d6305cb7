// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// How far a slice of rock sinks in one gyration [m]. It is nipped at the height z by the closed gap; while the chamber
/// opens it falls until the open gap below is as narrow, but no farther than free fall in half a gyration.
/// @param bottom    of the chamber; below it a slice falls freely [m]
/// @param fall      g (pi/w)^2 / 2 [m]
/// @param nipped    gap of the closed side at z [m]
/// @param open_gap  gap of the open side as a function of height [m] -> [m]
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/math/vec3.hpp"

#include <span>

namespace gyro {

/// The running balance of the rock's linear momentum [kg m/s]:
///
///   p(end) - p(start) = sum over windows of (M g - F_walls) dt + p(put in) - p(taken out)
///
/// with F_walls the rock's mean force on all walls. Zero up to rounding: forces between particles come in opposite
/// pairs, and what walls receive is what their contacts give.
class MomentumBalance {
 public:
  /// Takes up the momentum before a window, so that what was put in or taken out between windows counts for nothing.
  void open(const Vec3d& momentum) { before_ = momentum; }
  /// Closes the window. @param impulses  of gravity and of each wall on the rock in it [N s]
  void close(const Vec3d& momentum, std::span<const Vec3d> impulses);

  double residual() const { return norm(residual_); }  ///< [kg m/s]
  /// Residual over the sum of the magnitudes of all impulses; 0 before any.
  double residual_fraction() const { return turnover_ > 0 ? residual() / turnover_ : 0; }

  void save(SavedState& to) const;
  void restore(const SavedState& from);

 private:
  Vec3d before_{0, 0, 0}, residual_{0, 0, 0};
  double turnover_ = 0;
};

}  // namespace gyro

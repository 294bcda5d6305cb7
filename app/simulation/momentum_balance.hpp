// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

#include <span>

namespace gyro {

/// The running balance of the rock's linear momentum [kg m/s]:
///
///   p(end) - p(start) = sum over windows of (M g - F_walls) dt + p(inserted) - p(removed)
///
/// with F_walls the rock's mean force on all walls, M the mass of the rock, g gravity; world frame. The residual is
/// zero up to rounding: forces between particles come in opposite pairs, and the walls' forces are those of their
/// contacts. Between rocks with different sub-steps the ends of a window see half the difference of their sub-steps of
/// a force that acts at that time.
class MomentumBalance {
 public:
  /// What a checkpoint keeps.
  struct State {
    Vec3d before{0, 0, 0}, residual{0, 0, 0};  ///< momentum at the start of the window; residual so far [kg m/s]
    double turnover = 0;                       ///< sum of the magnitudes of all impulses [N s]

    /// Calls f(name, field) for every field, to be read or filled.
    template <class F, class S>
    static constexpr void for_each_field(F&& f, S& s) {
      f("before", s.before);
      f("residual", s.residual);
      f("turnover", s.turnover);
    }
  };

  /// Notes the momentum before a window, so that rock inserted or removed between windows does not count.
  void open(const Vec3d& momentum) { state_.before = momentum; }
  /// Closes the window. @param impulses  of gravity and of each wall on the rock in it [N s]
  void close(const Vec3d& momentum, std::span<const Vec3d> impulses);

  double residual() const { return norm(state_.residual); }  ///< [kg m/s]
  /// Residual over the sum of the magnitudes of all impulses; 0 before any.
  double residual_fraction() const { return state_.turnover > 0 ? residual() / state_.turnover : 0; }

  const State& state() const { return state_; }
  void restore(const State& state) { state_ = state; }

 private:
  State state_;
};

}  // namespace gyro

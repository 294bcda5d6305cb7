// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/cvode_session.hpp"
#include "mbd/drive.hpp"

#include <array>

namespace gyro {

/// Integrates ShaftModel over an interval under a constant load.
///
/// Dry friction and gear losses jump at w = 0 and at sigma = w cos b, and relays switch the motor. An automaton keeps
/// the equations smooth while they are integrated: during a leg, all signs and the switch are fixed. A leg ends at a
/// root of w or of sigma - w cos b, where a stuck eccentric or a dragged mantle breaks loose, where a relay trips, or
/// at a deadline of the clock. Between legs
///   the eccentric starts forward    if the net torque with forward friction is > 0,
///                 starts backward   if the net torque with backward friction is < 0,
///                 stays stuck       otherwise: friction balances the rest and w is exactly 0;
///   the mantle    is dragged along  if the inner bushing can transmit the torque that this requires,
///                 lags or runs ahead otherwise.
/// Both are settled together. The two starts exclude each other, and under a constant load an eccentric that has left 0
/// does not return in the same interval, so there is no chatter.
class Shaft : public Drive {
 public:
  /// @throws BadInput as check_drivetrain
  explicit Shaft(const DrivetrainParameters& parameters);

  /// The result depends only on the arguments, so any motion may be given.
  ShaftAdvance advance(double duration, const ShaftLoad& load, ShaftMotion& motion) override;
  ShaftAdvance preview(double duration, const ShaftLoad& load, ShaftMotion& motion) override {
    return advance(duration, load, motion);
  }
  /// The same for a load on the eccentric alone, positive when it resists forward motion [N m].
  ShaftAdvance advance(double duration, double rock_torque, ShaftMotion& motion) {
    return advance(duration, ShaftLoad{.rock_torque = rock_torque}, motion);
  }

  ShaftMotion start() const override;  ///< idling, or at rest
  double start_angle() const override { return parameters_.start_angle; }
  double energy(const ShaftMotion& motion) const override;
  /// By the motor's law, or the torque that the ideal drive needs under this load.
  double motor_torque_now(const ShaftMotion& motion, const ShaftLoad& load) const override;
  double motor_speed(const ShaftMotion& motion) const override {
    return model_.has_spring() ? motion.motor_speed : model_.gear_ratio() * motion.speed;
  }
  double idle_speed() const override { return gyro::idle_speed(parameters_); }
  bool constant_speed() const override { return model_.ideal(); }

 private:
  // Roots that end a leg; those of Protection follow.
  enum Event { halts, catches_up, breaks_drag, starts_forward, starts_backward, own_events };
  static constexpr int all_events = int{own_events} + int{Protection::events};

  /// Indices of the unknowns that only some drives have; -1: this drive does not have it.
  struct Layout {
    int size = 0, spin_angle = -1, spin_gain = -1, twist_gain = -1, motor_gain = -1, heat_gain = -1, clock = -1;
    explicit Layout(const DrivetrainParameters& parameters);
  };

  CvodeSession session_of(const Layout& layout);
  ShaftPoint point(const ShaftMotion& motion) const;
  ShaftPoint point(std::span<const double> y) const;
  ShaftBalance balance(const ShaftPoint& now) const;
  void evaluate(std::span<const double> y, std::span<double> rate) const;
  void watch(std::span<const double> y, std::span<double> values) const;
  FrictionSigns settle_friction(const ShaftMotion& motion, bool after_leg) const;
  void set_signs(ShaftMotion& motion, ShaftAdvance& sum, bool after_leg);
  ShaftAdvance advance_at_constant_speed(double duration, ShaftMotion& motion) const;
  bool consistent(const ShaftPoint& now, FrictionSigns signs, bool at_rest, bool together) const;
  bool changes_nothing(const ShaftMotion& motion) const;
  double leg(double duration, ShaftMotion& motion, ShaftAdvance& sum);
  void add_leg(std::span<const double> y, double lasted, ShaftMotion& motion, ShaftAdvance& sum) const;
  void halt(ShaftMotion& motion, double done, ShaftAdvance& sum) const;
  void switch_motor(ShaftMotion& motion, ShaftAdvance& sum, bool after_leg) const;

  DrivetrainParameters parameters_;
  ShaftModel model_;
  Protection protection_;
  Layout layout_;
  // Of the leg that is being integrated:
  ShaftMotion begin_;
  FrictionSigns signs_;
  CvodeSession session_;
};

}  // namespace gyro

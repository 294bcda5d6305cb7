// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/fmi/fmu_drive.hpp"

#include <chrono>
#include <functional>
#include <memory>

namespace gyro {

/// An FmuDrive in a process of its own, which is forked from this one. Nothing that the FMU's code does to memory,
/// rounding mode, signals or by calling exit() reaches this program. If that process ends, or does not answer within
/// `patience`, the run is stopped with the reason. A call takes about 20 us longer than in this process.
///
/// The FMU still has the rights of the user: it can read and write the user's files.
class FmuProcess final : public Drive {
 public:
  static constexpr std::chrono::seconds default_patience{120};

  /// Starts the process and initialises the FMU in it. @throws BadInput when that fails
  explicit FmuProcess(FmuSetup setup, std::chrono::milliseconds patience = default_patience);
  ~FmuProcess() override;

  ShaftMotion start() const override { return start_; }
  double start_angle() const override { return start_angle_; }
  ShaftAdvance preview(double duration, const ShaftLoad& load, ShaftMotion& motion) override;
  ShaftAdvance advance(double duration, const ShaftLoad& load, ShaftMotion& motion) override;
  double energy(const ShaftMotion&) const override { return now_.energy; }
  double motor_speed(const ShaftMotion&) const override { return now_.motor_speed; }
  double motor_torque_now(const ShaftMotion&, const ShaftLoad&) const override { return now_.motor_torque; }
  double idle_speed() const override { return now_.idle_speed; }
  DriveKnowledge knows() const override { return knowledge_of(setup_.links); }

  std::string unsaveable() const override { return unsaveable_; }
  std::vector<std::uint8_t> save() const override;
  void restore(std::span<const std::uint8_t> bytes) override;
  std::vector<std::string> take_notes() override;

 private:
  /// Quantities of the FMU at the end of the last advance.
  struct Now {
    double energy = 0;        ///< [J]
    double motor_speed = 0;   ///< [rad/s]
    double motor_torque = 0;  ///< [N m]
    double idle_speed = 0;    ///< of the eccentric [rad/s]
  };
  enum class Request : char { preview, advance, save, restore };
  class Server;
  class Channel;

  ShaftAdvance move(Request request, double duration, const ShaftLoad& load, ShaftMotion& motion);

  FmuSetup setup_;
  std::unique_ptr<Channel> channel_;
  ShaftMotion start_;
  double start_angle_ = 0;
  Now now_;
  std::string unsaveable_;
  mutable std::vector<std::string> notes_;
};

}  // namespace gyro

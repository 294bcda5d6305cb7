// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drive.hpp"
#include "mbd/fmi/drive_variable.hpp"
#include "mbd/fmi/fmu_library.hpp"

#include <array>
#include <memory>
#include <optional>

namespace gyro {

/// The quantities exchanged with a drivetrain FMU, inputs first.
enum class FmuQuantity {
  mantle_torque,
  spin_torque,
  bushing_force,
  spider_force,
  eccentric_speed,
  eccentric_angle,
  mantle_spin,
  mantle_spin_angle,
  motor_speed,
  motor_angle,
  motor_torque,
  motor_impulse,
  motor_power,
  motor_work,
  loss_work,
  kinetic_energy,
  tripped,  ///< 0 or 1
  count
};
constexpr auto fmu_quantities = static_cast<std::size_t>(FmuQuantity::count);
constexpr bool is_input(FmuQuantity quantity) {
  return quantity < FmuQuantity::eccentric_speed;
}

constexpr VariableType type_of(FmuQuantity quantity) {
  return quantity == FmuQuantity::tripped ? VariableType::boolean : VariableType::real;
}

/// A variable of an FMU: value in SI units = factor x value of the FMU + offset.
struct FmuLink {
  fmi2ValueReference reference = 0;
  double factor = 1, offset = 0;
};

/// The event history of an exported drivetrain: the number of events so far, and of the last ones time and
/// DriveEventKind, the latest first.
struct FmuHistory {
  fmi2ValueReference events = 0;
  std::vector<fmi2ValueReference> times, kinds;
};
using FmuLinks = std::array<std::optional<FmuLink>, fmu_quantities>;

/// The quantities that an FMU with these links gives.
DriveKnowledge knowledge_of(const FmuLinks& links);

/// A parameter that is set before the start; the value is in the unit of the FMU.
struct FmuStart {
  fmi2ValueReference reference = 0;
  VariableType type = VariableType::real;
  double value = 0;
};

/// An unpacked FMU whose variables are known.
struct FmuSetup {
  std::filesystem::path library;              ///< shared library
  std::string name, guid, resources;          ///< resources: URI of the folder
  bool state = false, serialisation = false;  ///< whether it declares that its state can be saved, serialised
  FmuLinks links{};
  std::optional<FmuHistory> history;
  std::vector<FmuStart> starts;
  std::shared_ptr<const void> files;  ///< keeps the unpacked files from being deleted
};

/// A drivetrain made by another program: an FMI 2.0 co-simulation slave.
///
/// If the slave can save its state, preview() takes a step and sets the slave back; otherwise it extrapolates the speed
/// with the last acceleration. Integrals that the slave does not give are computed from speeds and torques at both ends
/// of a window; knows() reports which quantities are available. Events are read from the slave's history, if it has
/// one. Otherwise a change of `tripped` is a trip or a restart at the end of the step, and a halt of forward motion is
/// a stall unless the motor's torque is known not to drive.
class FmuDrive : public Drive {
 public:
  /// Loads and initialises the FMU. @throws BadInput if that fails
  explicit FmuDrive(FmuSetup setup);
  ~FmuDrive() override;

  ShaftMotion start() const override { return start_; }
  double start_angle() const override { return start_angle_; }
  ShaftAdvance preview(double duration, const ShaftLoad& load, ShaftMotion& motion) override;
  ShaftAdvance advance(double duration, const ShaftLoad& load, ShaftMotion& motion) override;
  double energy(const ShaftMotion&) const override { return now(FmuQuantity::kinetic_energy); }
  double motor_speed(const ShaftMotion&) const override { return now(FmuQuantity::motor_speed); }
  double motor_torque_now(const ShaftMotion&, const ShaftLoad&) const override {
    return now(FmuQuantity::motor_torque);
  }
  /// The speed at the start, or the present one for a drive that started at rest.
  double idle_speed() const override { return start_.speed > 0 ? start_.speed : now(FmuQuantity::eccentric_speed); }
  DriveKnowledge knows() const override { return knowledge_of(setup_.links); }

  std::string unsaveable() const override;
  std::vector<std::uint8_t> save() const override;
  void restore(std::span<const std::uint8_t> bytes) override;
  std::vector<std::string> take_notes() override;

 private:
  using Values = std::array<double, fmu_quantities>;
  struct Messages;

  bool linked(FmuQuantity quantity) const { return setup_.links[static_cast<std::size_t>(quantity)].has_value(); }
  double now(FmuQuantity quantity) const { return values_[static_cast<std::size_t>(quantity)]; }
  void initialise();
  void set_start(const FmuStart& start);
  Values read();
  double get(fmi2ValueReference reference, VariableType type);
  void report_history(std::vector<DriveEvent>& events);
  void report_changes(const Values& before, const ShaftMotion& motion, std::vector<DriveEvent>& events) const;
  void step(double time, double duration, const ShaftLoad& load, bool final);
  ShaftAdvance gains(const Values& before, const Values& after, double duration) const;
  void check(fmi2Status status, const char* function, double time);
  void check_start(fmi2Status status, const char* function);
  std::string complaint(fmi2Status status, const char* function) const;

  FmuSetup setup_;
  std::unique_ptr<Messages> messages_;  ///< outlives the library
  fmi2CallbackFunctions callbacks_{};
  FmuLibrary library_;
  fmi2Component component_ = nullptr;
  bool initialised_ = false, fatal_ = false;
  mutable fmi2FMUstate saved_ = nullptr;  ///< allocated by the slave; reused
  Values values_{};                       ///< at the end of the last advance
  double last_acceleration_ = 0;          ///< over the last advance [rad/s2]
  int events_reported_ = 0;
  ShaftMotion start_;
  double start_angle_ = 0;
};

}  // namespace gyro

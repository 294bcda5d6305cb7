// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/fmi/drive_slave.hpp"
#include "mbd/fmi/fmi2.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gyro {

/// State of an instance in FMI's state machine; powers of 2, so that a function may allow several.
enum class SlaveMode : unsigned { instantiated = 1, initialising = 2, stepping = 4, terminated = 8 };
constexpr unsigned any_mode = 15;

/// The state that fmi2GetFMUstate returns.
struct SavedSlave {
  SlaveMode mode = SlaveMode::instantiated;
  SlaveState state;
  std::vector<double> parameters;

  std::vector<char> bytes() const;
  /// @throws BadInput for bytes that are not a saved state
  static SavedSlave from_bytes(const char* bytes, std::size_t size);
};

/// One fmi2Component.
struct Fmi2Instance {
  std::string name;
  fmi2CallbackFunctions callbacks;
  DrivetrainParameters as_exported;
  std::unique_ptr<DriveSlave> slave;
  SlaveMode mode = SlaveMode::instantiated;
  bool changed = false;   ///< a parameter was set and has not been applied yet
  double start_time = 0;  ///< [s]

  /// @param resources  URI of the folder that holds drivetrain.txt
  /// @throws BadInput when it cannot be read or its first line is not `guid GUID`
  Fmi2Instance(std::string instance_name, const fmi2CallbackFunctions& functions, const std::string& guid,
               const std::string& resources);

  void log(fmi2Status status, const std::string& message) const;
  void apply_changes();
  /// The variable behind a reference. @throws BadInput if it does not exist or has another type
  const DriveVariable& variable(fmi2ValueReference reference, VariableType type) const;
  double get(fmi2ValueReference reference, VariableType type);
  void set(fmi2ValueReference reference, VariableType type, double value);
  void step(double time, double duration);
};

}  // namespace gyro

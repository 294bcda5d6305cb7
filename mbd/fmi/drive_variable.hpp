// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drivetrain_parameters.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gyro {

enum class VariableType { real, integer, boolean };
enum class Causality { parameter, input, output };

/// A variable of the drivetrain as FMI sees it. Its value reference is its index in the list. Integers and Booleans are
/// passed as doubles, which hold them exactly.
struct DriveVariable {
  std::string name;  ///< as the key of the case or the dataset of the series
  VariableType type = VariableType::real;
  Causality causality = Causality::output;
  std::string unit;  ///< as FMI writes it: N.m; empty for pure numbers
  std::string description;
  std::function<double()> get;
  std::function<void(double)> set;  ///< empty for outputs
};

/// All parameters of a drivetrain, as variables that read and write `parameters`, which must outlive them. Derived
/// parameters of a motor are not among them: see complete_motor().
std::vector<DriveVariable> parameter_variables(DrivetrainParameters& parameters);

/// Parameters as text, for the resources of an FMU: the model of the motor, then one `name value` per line, with all
/// digits.
std::string drive_text(const DrivetrainParameters& parameters);
/// Reads it back, bit for bit. @throws BadInput with the line that is wrong
DrivetrainParameters drive_from_text(const std::string& text);

}  // namespace gyro

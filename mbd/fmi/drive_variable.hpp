// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drivetrain_parameters.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gyro {

enum class VariableType { real, integer, boolean };
enum class Causality { parameter, input, output };

/// A variable of the drivetrain as FMI sees it. Its value reference is its place in the list. Whole numbers and truth
/// values travel as doubles, which hold them exactly.
struct DriveVariable {
  std::string name;  ///< as the key of the case or the dataset of the series
  VariableType type = VariableType::real;
  Causality causality = Causality::output;
  std::string unit;  ///< as FMI writes it: N.m; empty for pure numbers
  std::string description;
  std::function<double()> get;
  std::function<void(double)> set;  ///< empty for outputs
};

/// Everything that a drivetrain is told, as variables that read and write `parameters`, which must outlive them.
/// The cages of a double cage motor are not among them: they follow from its name plate.
std::vector<DriveVariable> parameter_variables(DrivetrainParameters& parameters);

/// A double cage motor whose name plate has changed gets the cages that belong to it. @throws BadInput
void complete_motor(Motor& motor);

/// Parameters as text, for the resources of an FMU: what kind of motor, then `name value` a line, with all digits.
std::string drive_text(const DrivetrainParameters& parameters);
/// Reads it back, bit for bit. @throws BadInput with the line that is wrong
DrivetrainParameters drive_from_text(const std::string& text);

}  // namespace gyro

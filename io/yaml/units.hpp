// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// What a quantity of the case file measures.
enum class Dimension {
  number,              // [-], also percent
  length,              // [m]
  area,                // [m2]
  volume,              // [m3]
  mass,                // [kg]
  time,                // [s]
  angle,               // [rad]
  speed,               // [m/s]
  angular_speed,       // [rad/s]
  acceleration,        // [m/s2]
  force,               // [N]
  torque,              // [N m]
  pressure,            // [Pa]
  compliance,          // [1/Pa]
  stiffness,           // [N/m]
  stiffness_per_area,  // [Pa/m]
  density,             // [kg/m3]
  mass_flow,           // [kg/s]
  power,               // [W]
  energy,              // [J]
  mass_per_energy,     // [kg/J]
  inertia,             // [kg m2]
  rotational_damping,  // [N m s]
};

/// A unit that a case file may use.
struct Unit {
  std::string_view name;
  Dimension dimension;
  double factor;  ///< value in SI = factor x value in this unit
};

/// All units, grouped by dimension; the SI unit of a dimension comes first.
const std::vector<Unit>& units();

/// Name of a dimension with its article: "a length", "a time" ...
std::string_view name_of(Dimension dimension);

/// SI unit of a dimension; "1" for a plain number.
std::string_view si_unit(Dimension dimension);

/// A parsed number, or the reason why the text is not a number.
struct ParsedNumber {
  std::optional<double> value;  ///< in SI
  std::string problem;          ///< "problem; what to do" when there is no value
};

/// Reads `12`, `1e-3`, `120 mm`, `50 kg m2` as a quantity of the given dimension. A plain number is in SI.
/// Other dimensions, unknown units, values that are not finite, `010`, `0x10` and trailing text are refused.
ParsedNumber parse_quantity(std::string_view text, Dimension dimension);

/// Reads a whole number such as `24` or `1e6`. `010`, `0x18`, `2.5` and units are refused.
/// The value is exact up to 2^53.
ParsedNumber parse_integer(std::string_view text);

}  // namespace gyro

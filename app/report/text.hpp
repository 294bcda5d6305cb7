// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Texts of the page: escaping, numbers and units.
namespace gyro::report {

/// A text for HTML and XML, in elements and in attributes with double quotes.
std::string escape(std::string_view text);

/// A number with `digits` significant figures: "27.9", "1240", "3.42 × 10⁻³"; "–" if it is not finite.
std::string number(double value, int digits = 3);

/// A value with the decimals that its standard error justifies: "27.86 ± 0.41".
std::string number_with_error(double value, double error);

/// A whole number in groups of three digits, divided by narrow spaces that do not break.
std::string count(std::int64_t value);

/// A unit for readers: value in SI x factor is the value in this unit.
struct Unit {
  double factor = 1;
  std::string name;
};

/// The unit in which numbers up to `largest` (in the unit `si`) are best read: W become kW from 1000 W on, m are always
/// mm, rad/s are rpm. An unknown unit stays as it is; the unit of a pure number has an empty name.
Unit shown_unit(std::string_view si, double largest);

/// "27.9 W", in the unit of shown_unit().
std::string quantity(double value, std::string_view si);

}  // namespace gyro::report

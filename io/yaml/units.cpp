// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/yaml/units.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double pound = 0.45359237;                           // international pound, exact [kg]
constexpr double standard_gravity = 9.80665;                   // by definition [m/s2]
constexpr double horsepower = 550 * pound * 9.80665 * 0.3048;  // mechanical: 550 ft lbf/s [W]
constexpr double psi = pound * 9.80665 / (0.0254 * 0.0254);    // lbf/in2 [Pa]

using enum Dimension;

const std::vector<Unit> unit_table = {
    {"1", number, 1},
    {"%", number, 0.01},
    {"percent", number, 0.01},
    {"m", length, 1},
    {"km", length, 1e3},
    {"cm", length, 1e-2},
    {"mm", length, 1e-3},
    {"um", length, 1e-6},
    {"in", length, 0.0254},
    {"ft", length, 0.3048},
    {"m2", area, 1},
    {"cm2", area, 1e-4},
    {"mm2", area, 1e-6},
    {"m3", volume, 1},
    {"cm3", volume, 1e-6},
    {"l", volume, 1e-3},
    {"kg", mass, 1},
    {"g", mass, 1e-3},
    {"t", mass, 1e3},
    {"lb", mass, pound},
    {"s", time, 1},
    {"ms", time, 1e-3},
    {"us", time, 1e-6},
    {"ns", time, 1e-9},
    {"min", time, 60},
    {"h", time, 3600},
    {"d", time, 86400},
    {"rad", angle, 1},
    {"mrad", angle, 1e-3},
    {"deg", angle, pi / 180},
    {"m/s", speed, 1},
    {"cm/s", speed, 1e-2},
    {"mm/s", speed, 1e-3},
    {"m/min", speed, 1.0 / 60},
    {"km/h", speed, 1 / 3.6},
    {"rad/s", angular_speed, 1},
    {"deg/s", angular_speed, pi / 180},
    {"rpm", angular_speed, pi / 30},
    {"rev/s", angular_speed, 2 * pi},
    {"m/s2", acceleration, 1},
    {"g0", acceleration, standard_gravity},
    {"N", force, 1},
    {"kN", force, 1e3},
    {"MN", force, 1e6},
    {"N m", torque, 1},
    {"Nm", torque, 1},
    {"kN m", torque, 1e3},
    {"kNm", torque, 1e3},
    {"MN m", torque, 1e6},
    {"Pa", pressure, 1},
    {"kPa", pressure, 1e3},
    {"MPa", pressure, 1e6},
    {"GPa", pressure, 1e9},
    {"bar", pressure, 1e5},
    {"psi", pressure, psi},
    {"N/m2", pressure, 1},
    {"N/mm2", pressure, 1e6},
    {"1/Pa", compliance, 1},
    {"1/kPa", compliance, 1e-3},
    {"1/MPa", compliance, 1e-6},
    {"1/GPa", compliance, 1e-9},
    {"Pa-1", compliance, 1},
    {"m2/N", compliance, 1},
    {"mm2/N", compliance, 1e-6},
    {"mm3/(N m)", compliance, 1e-9},
    {"N/m", stiffness, 1},
    {"kN/m", stiffness, 1e3},
    {"MN/m", stiffness, 1e6},
    {"N/mm", stiffness, 1e3},
    {"Pa/m", stiffness_per_area, 1},
    {"kPa/m", stiffness_per_area, 1e3},
    {"MPa/m", stiffness_per_area, 1e6},
    {"GPa/m", stiffness_per_area, 1e9},
    {"TPa/m", stiffness_per_area, 1e12},
    {"N/m3", stiffness_per_area, 1},
    {"GN/m3", stiffness_per_area, 1e9},
    {"kg/m3", density, 1},
    {"g/cm3", density, 1e3},
    {"t/m3", density, 1e3},
    {"kg/s", mass_flow, 1},
    {"kg/h", mass_flow, 1.0 / 3600},
    {"t/h", mass_flow, 1 / 3.6},
    {"t/s", mass_flow, 1e3},
    {"W", power, 1},
    {"kW", power, 1e3},
    {"MW", power, 1e6},
    {"hp", power, horsepower},
    {"J", energy, 1},
    {"kJ", energy, 1e3},
    {"MJ", energy, 1e6},
    {"kWh", energy, 3.6e6},
    {"kg/J", mass_per_energy, 1},
    {"kg/kJ", mass_per_energy, 1e-3},
    {"t/kWh", mass_per_energy, 1.0 / 3600},
    {"kg/kWh", mass_per_energy, 1 / 3.6e6},
    {"kg m2", inertia, 1},
    {"t m2", inertia, 1e3},
    {"N m s", rotational_damping, 1},
    {"N m s/rad", rotational_damping, 1},
    {"kN m s", rotational_damping, 1e3},
    {"kN m s/rad", rotational_damping, 1e3},
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_space(char c) {
  return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// The same spelling for `kg*m^2`, `kg·m²` and `kg  m2`, for `µs` and `us`, and for `°` and `deg`.
std::string canonical_unit(std::string_view text) {
  std::string unit(trimmed(text));
  for (const char* times : {"*", "\u00b7", "\u22c5"}) replace_all(unit, times, " ");
  for (const char* micro : {"\u00b5", "\u03bc"}) replace_all(unit, micro, "u");
  replace_all(unit, "\u00b2", "2");
  replace_all(unit, "\u00b3", "3");
  replace_all(unit, "\u00b0", "deg");
  replace_all(unit, "^", "");
  replace_all(unit, "\t", " ");
  while (unit.find("  ") != std::string::npos) replace_all(unit, "  ", " ");
  return unit;
}

/// Length of the longest prefix that is a decimal number (sign, digits, point, exponent); 0 if there is none.
std::size_t number_length(std::string_view text) {
  std::size_t at = 0, digits = 0;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  while (at < text.size() && is_digit(text[at])) ++at, ++digits;
  if (at < text.size() && text[at] == '.') {
    ++at;
    while (at < text.size() && is_digit(text[at])) ++at, ++digits;
  }
  if (digits == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t end = at + 1;
    if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
    const std::size_t first = end;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end > first) at = end;
  }
  return at;
}

bool has_leading_zero(std::string_view number_text) {
  if (!number_text.empty() && (number_text[0] == '+' || number_text[0] == '-')) number_text.remove_prefix(1);
  return number_text.size() > 1 && number_text[0] == '0' && is_digit(number_text[1]);
}

std::string in_quotes(std::string_view text) {
  return '"' + std::string(text) + '"';
}

/// "give a length in one of the units m, km, ..., or a plain number in m"
std::string advice(Dimension dimension) {
  if (dimension == number) return "give a plain number or a percentage";
  std::string list;
  for (const Unit& unit : units())
    if (unit.dimension == dimension) list += (list.empty() ? "" : ", ") + std::string(unit.name);
  return "give " + std::string(name_of(dimension)) + " in one of the units " + list + ", or a plain number in " +
         std::string(si_unit(dimension));
}

const Unit* find_unit(const std::string& name, Dimension dimension) {
  const Unit* other = nullptr;
  for (const Unit& unit : units()) {
    if (unit.name != name) continue;
    if (unit.dimension == dimension) return &unit;
    other = &unit;
  }
  return other;
}

/// The number at the beginning of a text, in the unit of the text. @param rest  receives the text after it
ParsedNumber leading_number(std::string_view text, std::string_view& rest, const std::string& what_to_do) {
  const std::size_t length = number_length(text);
  if (length == 0) return {{}, in_quotes(text) + " is not a number; " + what_to_do};
  std::string_view digits = text.substr(0, length);
  rest = text.substr(length);
  if (has_leading_zero(digits))
    return {{}, in_quotes(text) + " has a leading zero, which some readers take for octal; write it without the zero"};
  if (digits.front() == '+') digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    return {{}, in_quotes(text) + " does not fit a double; " + what_to_do};
  return {value, {}};
}

/// value x factor, rounded only once: 21.7 mm becomes the double nearest to 0.0217.
double in_si(double value, double factor) {
  const double inverse = std::round(1 / factor);
  return inverse > 1 && 1 / inverse == factor ? value / inverse : value * factor;
}

}  // namespace

const std::vector<Unit>& units() {
  return unit_table;
}

std::string_view name_of(Dimension dimension) {
  switch (dimension) {
    case number:
      return "a number";
    case length:
      return "a length";
    case area:
      return "an area";
    case volume:
      return "a volume";
    case mass:
      return "a mass";
    case time:
      return "a time";
    case angle:
      return "an angle";
    case speed:
      return "a speed";
    case angular_speed:
      return "an angular speed";
    case acceleration:
      return "an acceleration";
    case force:
      return "a force";
    case torque:
      return "a torque";
    case pressure:
      return "a pressure";
    case compliance:
      return "a volume per work";
    case stiffness:
      return "a stiffness";
    case stiffness_per_area:
      return "a stiffness per area";
    case density:
      return "a density";
    case mass_flow:
      return "a mass flow";
    case power:
      return "a power";
    case energy:
      return "an energy";
    case mass_per_energy:
      return "a mass per energy";
    case inertia:
      return "a moment of inertia";
    case rotational_damping:
      return "a rotational damping";
  }
  return "a quantity";
}

std::string_view si_unit(Dimension dimension) {
  for (const Unit& unit : units())
    if (unit.dimension == dimension) return unit.name;
  return "1";
}

ParsedNumber parse_quantity(std::string_view text, Dimension dimension) {
  text = trimmed(text);
  std::string_view rest;
  const ParsedNumber parsed = leading_number(text, rest, advice(dimension));
  if (!parsed.value) return parsed;
  const std::string name = canonical_unit(rest);
  if (name.empty()) return parsed;
  const Unit* unit = name == "1" ? nullptr : find_unit(name, dimension);
  if (unit == nullptr)
    return {{}, in_quotes(text) + " has the unknown unit " + in_quotes(name) + "; " + advice(dimension)};
  if (unit->dimension != dimension)
    return {{}, in_quotes(text) + " is " + std::string(name_of(unit->dimension)) + "; " + advice(dimension)};
  const double value = in_si(*parsed.value, unit->factor);
  if (!std::isfinite(value)) return {{}, in_quotes(text) + " does not fit a double; " + advice(dimension)};
  return {value, {}};
}

ParsedNumber parse_integer(std::string_view text) {
  text = trimmed(text);
  std::string_view rest;
  const std::string wanted = "give a whole number";
  const ParsedNumber parsed = leading_number(text, rest, wanted);
  if (!parsed.value) return parsed;
  if (!rest.empty() || *parsed.value != std::floor(*parsed.value))
    return {{}, in_quotes(text) + " is not a whole number; " + wanted};
  return parsed;
}

}  // namespace gyro

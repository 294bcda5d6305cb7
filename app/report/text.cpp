// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/text.hpp"

#include "core/base/printable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace gyro::report {
namespace {

constexpr int smallest_exponent = -3, largest_exponent = 5;  ///< of ten, without "× 10"

std::string fixed(double value, int decimals) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string shown = text.data();
  if (shown.starts_with("-") && shown.find_first_not_of("-0.") == std::string::npos) shown.erase(0, 1);
  if (shown.starts_with("-")) shown.replace(0, 1, "\u2212");
  return shown;
}

std::string superscript(int exponent) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

/// Exponent of ten of a number once it is rounded to some significant figures.
int exponent_of(double value, int digits) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
  return std::atoi(std::string_view(text.data()).substr(std::string_view(text.data()).find('e') + 1).data());
}

struct Prefix {
  double from, factor;  ///< smallest value for which it is used; factor
  const char* name;
};

Unit chosen(double largest, std::initializer_list<Prefix> prefixes) {
  Unit unit;
  for (const Prefix& prefix : prefixes)
    if (unit.name.empty() || largest >= prefix.from) unit = {prefix.factor, prefix.name};
  return unit;
}

}  // namespace

std::string escape(std::string_view text) {
  std::string safe;
  for (const char c : printable(text)) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  return safe;
}

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (value == 0) return "0";
  const int exponent = exponent_of(value, digits);
  if (exponent < smallest_exponent || exponent >= largest_exponent)
    return fixed(value / std::pow(10, exponent), digits - 1) + "\u00a0×\u00a010" + superscript(exponent);
  const double step = std::pow(10, exponent - digits + 1);
  return fixed(std::round(value / step) * step, std::max(0, digits - 1 - exponent));
}

std::string number_with_error(double value, double error) {
  constexpr double negligible = 1e-6;
  if (!std::isfinite(value)) return "–";
  if (!std::isfinite(error) || error <= negligible * std::abs(value)) return number(value);
  const int larger = exponent_of(std::max(std::abs(value), error), 3);
  if (larger < smallest_exponent || larger >= largest_exponent) {
    const double power = std::pow(10, larger);
    return "(" + number_with_error(value / power, error / power) + ")\u00a0×\u00a010" + superscript(larger);
  }
  const int decimals = std::max(0, 1 - exponent_of(error, 2));
  return fixed(value, decimals) + " ± " + fixed(error, decimals);
}

std::string count(std::int64_t value) {
  std::string text = std::to_string(std::abs(value));
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), "\u202f");
  return (value < 0 ? "\u2212" : "") + text;
}

Unit shown_unit(std::string_view si, double largest) {
  largest = std::abs(largest);
  if (si == "1") return {1, ""};
  if (si == "W") return chosen(largest, {{0, 1, "W"}, {1e3, 1e-3, "kW"}, {1e6, 1e-6, "MW"}});
  if (si == "J") return chosen(largest, {{0, 1, "J"}, {1e3, 1e-3, "kJ"}, {1e6, 1e-6, "MJ"}});
  if (si == "N") return chosen(largest, {{0, 1, "N"}, {1e3, 1e-3, "kN"}, {1e6, 1e-6, "MN"}});
  if (si == "N m") return chosen(largest, {{0, 1, "N m"}, {1e3, 1e-3, "kN m"}, {1e6, 1e-6, "MN m"}});
  if (si == "N/m") return chosen(largest, {{0, 1, "N/m"}, {1e3, 1e-3, "kN/m"}, {1e6, 1e-6, "MN/m"}});
  if (si == "Pa") return chosen(largest, {{0, 1, "Pa"}, {1e3, 1e-3, "kPa"}, {1e6, 1e-6, "MPa"}, {1e9, 1e-9, "GPa"}});
  if (si == "kg") return chosen(largest, {{0, 1e3, "g"}, {0.1, 1, "kg"}, {1e3, 1e-3, "t"}});
  if (si == "kg/s" || si == "t/h") {
    const double tph = si == "kg/s" ? 3.6 : 1;
    return chosen(largest * tph, {{0, 1e3 * tph, "kg/h"}, {1, tph, "t/h"}});
  }
  if (si == "s") return chosen(largest, {{0, 1e6, "µs"}, {1e-3, 1e3, "ms"}, {0.1, 1, "s"}});
  if (si == "m") return {1e3, "mm"};
  if (si == "rad/s") return {30 / std::numbers::pi, "rpm"};
  return {1, std::string(si)};
}

std::string quantity(double value, std::string_view si) {
  const Unit unit = shown_unit(si, value);
  return number(value * unit.factor) + (unit.name.empty() ? "" : "\u00a0" + unit.name);
}

}  // namespace gyro::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/ticks.hpp"

#include "app/report/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gyro::report {

std::string tick_label(double value, double step) {
  constexpr double largest = 1e5, smallest = 1e-5;
  if (std::abs(value) >= largest || step < smallest) return value == 0 ? "0" : number(value);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value + 0.0);
  std::string shown = text.data();
  if (shown.starts_with("-")) shown.replace(0, 1, "\u2212");
  return shown;
}

std::vector<Tick> linear_ticks(double low, double high, int wanted) {
  std::vector<Tick> ticks;
  if (!(high > low) || !std::isfinite(high - low)) return ticks;
  const double raw = (high - low) / wanted, power = std::pow(10, std::floor(std::log10(raw)));
  const double step = power * (raw <= 1.5 * power ? 1 : raw <= 3.5 * power ? 2 : raw <= 7.5 * power ? 5 : 10);
  const auto first = static_cast<long long>(std::ceil(low / step - 1e-9));
  const auto last = static_cast<long long>(std::floor(high / step + 1e-9));
  for (long long k = first; k <= last; ++k) {
    const double value = static_cast<double>(k) * step;
    ticks.push_back({value, tick_label(value, step)});
  }
  return ticks;
}

std::vector<Tick> log_ticks(double low, double high) {
  std::vector<Tick> ticks;
  if (!(low > 0) || !(high > low) || !std::isfinite(high)) return ticks;
  const double decades = std::log10(high / low);
  const bool dense = decades <= 2.3, denser = decades <= 0.9;
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::ceil(std::log10(high)));
  for (int decade = first; decade <= last; ++decade)
    for (int k = 1; k <= 9; ++k) {
      const double power = std::pow(10, decade), value = k * power;
      if (value < low * (1 - 1e-9) || value > high * (1 + 1e-9)) continue;
      const bool labelled = k == 1 || (dense && (k == 2 || k == 5)) || (denser && k != 7 && k != 9);
      ticks.push_back({value, labelled ? tick_label(value, power) : ""});
    }
  return ticks;
}

double Scale::at(double value) const {
  const double part =
      log ? std::log(std::max(value, 1e-300) / low) / std::log(high / low) : (value - low) / (high - low);
  return begin + part * (end - begin);
}

Range widened(Range values, double margin) {
  if (!std::isfinite(values.low) || !std::isfinite(values.high)) return {0, 1};
  double width = values.high - values.low;
  if (!(width > 1e-12 * std::max(std::abs(values.low), std::abs(values.high))))
    width = values.high != 0 ? std::abs(values.high) : 1, margin = std::max(margin, 0.05);
  return {values.low == 0 ? 0 : values.low - margin * width, values.high == 0 ? 0 : values.high + margin * width};
}

}  // namespace gyro::report

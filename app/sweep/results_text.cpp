// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/results_text.hpp"

#include "io/run/summary_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gyro {
namespace {

/// A figure of the table: which members of the summary it is, and how it is printed. Its unit in files and its
/// description are those of the summary.
struct Headline {
  const char* title;
  const char* whole;   ///< of the whole run
  const char* steady;  ///< of the steady part; null: there is none
  double scale;        ///< printed / value
};

constexpr Headline headlines[] = {
    {"power [kW]", "mean_crushing_power", "steady.crushing_power", 1e-3},
    {"throughput [t/h]", "throughput_tph", "steady.throughput_tph", 1},
    {"P80 [mm]", "p80", "steady.p80", 1e3},
    {"energy [Wh/t]", "specific_energy_kwh_per_t", "steady.specific_energy_kwh_per_t", 1e3},
    {"broken [%]", "broken_share", nullptr, 100},
    {"stalled", "stalled", nullptr, 1},
    {"energy residual [%]", "energy_residual_fraction", nullptr, 100},
    {"cost [s]", "wall_seconds", nullptr, 1},
};

/// "12.3 +- 0.4": two digits of the error, and as many decimals of the value.
std::string with_error(const Estimate& estimate, double scale) {
  constexpr int max_decimals = 4;
  if (!std::isfinite(estimate.value)) return "-";
  const double value = estimate.value * scale, error = estimate.error * scale;
  if (!std::isfinite(error)) return format("%.3g", value);
  if (error == 0) return format("%.3g +- 0", value);
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(std::abs(error)))));
  if (decimals > max_decimals) return format("%.2g +- %.2g", value, error);
  return format("%.*f +- %.*f", decimals, value, decimals, error);
}

using Row = std::vector<std::string>;

std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  std::string text;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t k = 0; k < row.size(); ++k) line += " " + row[k] + std::string(widths[k] - row[k].size() + 1, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

bool all_steady(const SweepResults& results) {
  const int from = find_figure(results, "steady.from");
  return from >= 0 && std::all_of(results.points.begin(), results.points.end(), [&](const PointResult& point) {
           return point.state != PointState::done || std::isfinite(point.figures[static_cast<std::size_t>(from)]);
         });
}

}  // namespace

std::string results_text(const SweepResults& results) {
  const std::vector<SettingResult> settings = by_setting(results);
  const bool steady = all_steady(results);
  std::vector<Row> rows(settings.size() + 1);
  for (const SweepKey& key : results.keys) rows[0].push_back(key.short_name);
  rows[0].emplace_back("done");
  for (std::size_t s = 0; s < settings.size(); ++s) {
    rows[s + 1] = settings[s].values;
    rows[s + 1].push_back(std::to_string(settings[s].seeds.size()) + "/" + std::to_string(settings[s].points));
  }
  for (const Headline& headline : headlines) {
    const int figure = find_figure(results, steady && headline.steady ? headline.steady : headline.whole);
    if (figure < 0) continue;
    rows[0].emplace_back(headline.title);
    for (std::size_t s = 0; s < settings.size(); ++s)
      rows[s + 1].push_back(with_error(settings[s].figures[static_cast<std::size_t>(figure)], headline.scale));
  }
  return std::string("\nMeans and standard errors over the seeds that are done, ") +
         (steady ? "power to energy of the steady part of each run, the others of whole runs\n" : "of whole runs\n") +
         aligned(rows);
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

constexpr int in_tension = 1, in_shear = 2;
constexpr std::size_t bins = 30;

struct Heights {
  double low = INFINITY, high = -INFINITY;
  void add(const Breaks& breaks) {
    for (const double z : breaks.height)
      if (std::isfinite(z)) low = std::min(low, z), high = std::max(high, z);
  }
};

/// Shares of the bonds that broke at each height, as a step line [mm], [%].
Curve by_height(const Breaks& breaks, const Heights& heights, int mode, double total) {
  std::vector<double> broken(bins, 0);
  const double step = (heights.high - heights.low) / bins;
  for (std::size_t k = 0; k < breaks.height.size(); ++k) {
    if (!std::isfinite(breaks.height[k]) || (mode != 0 && breaks.mode[k] != mode)) continue;
    const auto bin = static_cast<std::size_t>(step > 0 ? (breaks.height[k] - heights.low) / step : 0);
    ++broken[std::min(bin, bins - 1)];
  }
  Curve curve{.name = {}, .x = {}, .y = {}};
  for (std::size_t b = 0; b < bins; ++b)
    for (const std::size_t edge : {b, b + 1}) {
      curve.x.push_back(100 * broken[b] / total);
      curve.y.push_back(1e3 * (heights.low + static_cast<double>(edge) * step));
    }
  return curve;
}

std::string height_plot(const Runs& runs) {
  Heights heights;
  for (const RunData& run : runs)
    if (run.breaks) heights.add(*run.breaks);
  LinePlot plot{.title = "Where bonds broke, by height"};
  plot.x = {.label = "share of the broken bonds [%]", .zero = true};
  plot.y = {.label = "height [mm]"};
  plot.note = "In " + std::to_string(bins) + " layers of " + number(1e3 * (heights.high - heights.low) / bins) +
              " mm. The discharge plane lies at height 0.";
  int style = 0;
  for (const RunData& run : runs) {
    if (!run.breaks || run.breaks->height.empty()) continue;
    const auto total = static_cast<double>(run.breaks->height.size());
    const auto add = [&](int mode, const std::string& name) {
      plot.curves.push_back(by_height(*run.breaks, heights, mode, total));
      plot.curves.back().name = name;
      plot.curves.back().style = style++ % 7;
    };
    if (runs.size() > 1) {
      add(0, run.name);
    } else {
      add(in_tension, "in tension");
      add(in_shear, "in shear");
    }
  }
  return has_points(plot) ? figure(plot) : "";
}

std::string rate_plot(const Runs& runs) {
  constexpr int steps = 60;
  LinePlot plot{.title = "How fast bonds broke"};
  double end = 0;
  for (const RunData& run : runs) end = std::max(end, run.end());
  const Unit time = shown_unit("s", end);
  plot.x = {.label = "time [" + time.name + "]", .low = 0, .high = time.factor * end};
  plot.y = {.label = "broken bonds in each " + quantity(end / steps, "s"), .zero = true};
  int style = 0;
  for (const RunData& run : runs) {
    if (!run.breaks || run.breaks->time.empty()) continue;
    std::vector<double> broken(steps, 0);
    for (const double t : run.breaks->time)
      ++broken[static_cast<std::size_t>(std::clamp(t / end * steps, 0.0, steps - 1.0))];
    Curve curve{.name = runs.size() > 1 ? run.name : "", .x = {}, .y = {}, .style = style++ % 7};
    for (std::size_t k = 0; k < broken.size() && static_cast<double>(k) * end / steps < run.end(); ++k)
      for (const std::size_t edge : {k, k + 1}) {
        curve.x.push_back(time.factor * end * static_cast<double>(edge) / steps);
        curve.y.push_back(broken[k]);
      }
    plot.curves.push_back(std::move(curve));
  }
  return has_points(plot) ? figure(plot) : "";
}

std::string breakage_table(const Runs& runs) {
  std::vector<std::string> head{""};
  std::vector<std::vector<std::string>> rows{{"Bonds of all rock that was inserted"},
                                             {"… broken"},
                                             {"… in tension"},
                                             {"… in shear"},
                                             {"Energy that they released"}};
  for (const RunData& run : runs) {
    head.push_back(runs.size() > 1 ? escape(run.name) : "Number");
    const Breaks breaks = run.breaks.value_or(Breaks{});
    const auto all = run.summary.bonds_initial.value_or(0);
    const auto share = [&](std::int64_t n) {
      return count(n) +
             (all > 0 ? " (" + number(100.0 * static_cast<double>(n) / static_cast<double>(all)) + " %)" : "");
    };
    double energy = 0;
    for (const double e : breaks.energy) energy += std::isfinite(e) ? e : 0;
    rows[0].push_back(count(all));
    rows[1].push_back(share(run.summary.bonds_broken.value_or(0)));
    rows[2].push_back(share(std::ranges::count(breaks.mode, in_tension)));
    rows[3].push_back(share(std::ranges::count(breaks.mode, in_shear)));
    rows[4].push_back(quantity(energy, "J"));
  }
  return "<div>" + html_table(head, rows) + "</div>";
}

}  // namespace

std::string breakage_section(const Runs& runs) {
  const bool broken =
      std::ranges::any_of(runs, [](const RunData& run) { return run.breaks && !run.breaks->time.empty(); });
  if (!broken) return "";
  return section("breakage", "Breakage", side_by_side(height_plot(runs) + rate_plot(runs) + breakage_table(runs)));
}

}  // namespace gyro::report

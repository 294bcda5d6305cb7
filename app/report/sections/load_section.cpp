// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/plot/heat_map.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/plot/polar_plot.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyro::report {
namespace {

constexpr double shown_gyrations = 10;  ///< means over the angle are of at most so many

struct ByAngle {
  std::string column, title, what, note;
};

std::string span_words(const RunData& run) {
  const double begin = last_gyrations(run, shown_gyrations);
  if (begin > 0) return "over the time since " + quantity(begin, "s");
  return "over the whole run of " + number(run.gyrations().value_or(0), 2) + " gyrations";
}

/// A column against the angle of the eccentric, a curve for each run.
std::string angle_plot(const Runs& runs, const ByAngle& by) {
  std::vector<std::pair<const RunData*, Points>> curves;
  double highest = 0;
  std::string units;
  for (const RunData& run : runs) {
    const Column* column = run.series ? run.series->find(by.column) : nullptr;
    if (!column || !gyration_time(run)) continue;
    curves.emplace_back(&run, by_angle(*run.series, *column, last_gyrations(run, shown_gyrations)));
    highest = std::max(highest, largest(curves.back().second.y));
    units = column->units;
  }
  if (curves.empty() || highest == 0) return "";
  const Unit unit = shown_unit(units, highest);
  LinePlot plot{.title = by.title};
  plot.x = {.label = "angle of the eccentric [°]", .low = 0, .high = 360, .step = 90};
  plot.y = {.label = by.what + " [" + unit.name + "]", .zero = true};
  plot.note = by.note + (runs.size() == 1 ? " Mean " + span_words(runs.front()) + "." : "");
  int style = 0;
  for (auto& [run, points] : curves)
    plot.curves.push_back({.name = runs.size() > 1 ? run->name : "",
                           .x = points.x,
                           .y = scaled(points.y, unit.factor),
                           .style = style++ % 7});
  return figure(plot);
}

/// The horizontal force on the mantle in the frame of the eccentric: the gap is closed at 0 degrees.
std::string polar(const RunData& run) {
  const Column *force = run.series ? run.series->find("mantle_force") : nullptr,
               *angle = run.series ? run.series->find("eccentric_angle") : nullptr;
  if (!force || !angle || force->width != 3) return "";
  const double begin = last_gyrations(run, shown_gyrations);
  PolarPlot plot{.title = "Horizontal force of the rock on the mantle, by direction",
                 .label = {},
                 .along = {},
                 .across = {},
                 .directions = {"closed side", "90° ahead", "open side", "90° behind"}};
  for (std::size_t k = 1; k < run.series->rows(); ++k) {
    if (run.series->time()[k] <= begin) continue;
    const double x = force->values[3 * k], y = force->values[3 * k + 1];
    const double at = (angle->values[k - 1] + angle->values[k]) / 2;  // the force is a mean over the row
    // The rock pushes the mantle away from the gap: a force from the closed side is drawn on the closed side.
    plot.along.push_back(-(x * std::cos(at) + y * std::sin(at)));
    plot.across.push_back(-(y * std::cos(at) - x * std::sin(at)));
  }
  const double most = std::max(largest(plot.along), largest(plot.across));
  if (most == 0) return "";
  const Unit unit = shown_unit("N", most);
  plot.label = "force [" + unit.name + "]";
  plot.along = scaled(plot.along, unit.factor), plot.across = scaled(plot.across, unit.factor);
  plot.note =
      "Seen from above in the frame that turns with the eccentric. A point lies on the side from which the rock "
      "pushes, as far from the middle as the force is large; ahead means where the gap will close next. " +
      std::string("Rows ") + span_words(run) + ".";
  return figure(plot);
}

/// Sum or mean over the maps after `begin`, cell by cell. @returns the time that they stand for [s]
double collect(const LinerMaps& maps, double begin, std::vector<double>& pressure, std::vector<double>& work) {
  const Column *p = maps.table.find("pressure"), *w = maps.table.find("work");
  pressure.assign(maps.area.size(), 0), work.assign(maps.area.size(), 0);
  double seconds = 0;
  for (std::size_t row = 0; row < maps.table.rows(); ++row) {
    const double end = maps.table.time()[row], length = end - (row > 0 ? maps.table.time()[row - 1] : 0);
    if (end <= begin * (1 + 1e-9)) continue;
    seconds += length;
    for (std::size_t c = 0; c < maps.area.size(); ++c) {
      if (p && p->width == maps.area.size()) pressure[c] += length * p->values[row * p->width + c];
      if (w && w->width == maps.area.size()) work[c] += w->values[row * w->width + c];
    }
  }
  return seconds;
}

HeatMap map_of(const LinerMaps& maps, const std::string& title, std::vector<double> values, const std::string& what,
               const Unit& unit) {
  for (std::size_t c = 0; c < values.size(); ++c)
    values[c] = maps.area[c] > 0 ? unit.factor * values[c] : std::numeric_limits<double>::quiet_NaN();
  HeatMap map{.title = title,
              .x_label = "azimuth [°]",
              .y_label = "height [mm]",
              .value_label = what + " [" + unit.name + "]",
              .x = scaled(maps.azimuths, 180 / std::numbers::pi),
              .y = scaled(maps.heights, 1e3),
              .values = std::move(values)};
  map.note = "The liner unrolled: around the machine to the right, upward to the top. Largest value " +
             number(largest(map.values)) + " " + unit.name + ".";
  return map;
}

/// Wear by Archard's law where the case has its coefficient, else the power of sliding friction by area.
HeatMap sliding_map(const RunData& run, const LinerMaps& maps, std::vector<double> work, double seconds) {
  constexpr double mm_in_1000_h = 1e3 * 1000 * 3600;  // of 1 m/s
  const auto friction = run.facts.wall_friction.find(maps.wall);
  for (std::size_t c = 0; c < work.size(); ++c) work[c] /= maps.area[c] > 0 ? maps.area[c] * seconds : 1;
  if (run.facts.wear_coefficient && friction != run.facts.wall_friction.end() && friction->second > 0) {
    work = scaled(std::move(work), mm_in_1000_h * *run.facts.wear_coefficient / friction->second);
    HeatMap map = map_of(maps, "Wear of the " + maps.wall, std::move(work), "wear", {1, "mm per 1000 h"});
    map.note += " By Archard's law from the work of friction, at the mean rate of the run" +
                std::string(run.summary.steady ? "." : "; a start-up gives the rate of single blows and no forecast.");
    return map;
  }
  const Unit unit = largest(work) >= 1000 ? Unit{1e-3, "kW/m²"} : Unit{1, "W/m²"};
  return map_of(maps, "Power of sliding friction on the " + maps.wall, std::move(work), "power", unit);
}

std::string liner_maps(const RunData& run) {
  std::string figures;
  for (const LinerMaps& maps : run.liners) {
    std::vector<double> pressure, work;
    const double seconds = collect(maps, run.begin(), pressure, work);
    if (!(seconds > 0)) continue;
    pressure = scaled(std::move(pressure), 1 / seconds);
    const Unit unit = shown_unit("Pa", end_of_scale(pressure));
    figures += figure(map_of(maps, "Mean pressure of the rock on the " + maps.wall, pressure, "pressure", unit));
    figures += figure(sliding_map(run, maps, std::move(work), seconds));
  }
  return figures;
}

}  // namespace

std::string load_section(const Runs& runs) {
  const std::string turning = "The gap is closed in the direction of the angle, counted from the x axis.";
  const std::string over_angle =
      angle_plot(runs, {"crushing_power", "Crushing power against the angle of the eccentric", "power", turning}) +
      angle_plot(runs, {"mantle_torque", "Torque of the rock against the angle of the eccentric", "torque",
                        "About the axis of the eccentric, positive where the rock resists the drive. " + turning});
  if (runs.size() == 1)
    return section("loads", "Loads on drive and liners",
                   side_by_side(over_angle + polar(runs.front()) + liner_maps(runs.front())));
  const std::string single =
      by_run(runs, [](const RunData& run) { return side_by_side(polar(run) + liner_maps(run)); });
  return section("loads", "Loads on drive and liners", side_by_side(over_angle) + single);
}

}  // namespace gyro::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

constexpr int styles = 7;

/// Unit of time for all runs of the page.
Unit time_unit(const Runs& runs) {
  double end = 0;
  for (const RunData& run : runs) end = std::max(end, run.end());
  return shown_unit("s", end);
}

Axis time_axis(const Runs& runs) {
  double end = 0;
  for (const RunData& run : runs) end = std::max(end, run.end());
  const Unit unit = time_unit(runs);
  return {.label = "time [" + unit.name + "]", .low = 0, .high = end > 0 ? end * unit.factor : 1};
}

/// The spans over which noisy rows are averaged: a gyration, or a twentieth of a shorter run [s].
double mean_span(const RunData& run) {
  const auto gyration = gyration_time(run);
  return gyration && *gyration < run.end() / 3 ? *gyration : run.end() / 20;
}

std::string mean_words(const Runs& runs) {
  const bool by_gyration = std::ranges::all_of(runs, [](const RunData& run) {
    const auto gyration = gyration_time(run);
    return gyration && *gyration < run.end() / 3;
  });
  return by_gyration ? "mean over one gyration" : "mean over a twentieth of the run";
}

/// A column of /series that a plot shows.
struct Shown {
  std::string name, label;
};

const Column* column_of(const RunData& run, const std::string& name) {
  return run.series ? run.series->find(name) : nullptr;
}

double largest_of(const Runs& runs, const std::vector<Shown>& shown) {
  double most = 0;
  for (const RunData& run : runs)
    for (const Shown& s : shown)
      if (const Column* c = column_of(run, s.name)) most = std::max(most, largest(c->values));
  return most;
}

std::string units_of(const Runs& runs, const std::vector<Shown>& shown) {
  for (const RunData& run : runs)
    for (const Shown& s : shown)
      if (const Column* c = column_of(run, s.name)) return c->units;
  return "";
}

/// What a plot over time has in common: title, axes, the steady part.
LinePlot plot_of(const Runs& runs, const std::string& title, const std::string& what, const Unit& unit) {
  LinePlot plot{.title = title};
  plot.x = time_axis(runs);
  plot.y = {.label = what + (unit.name.empty() ? "" : " [" + unit.name + "]"), .zero = true};
  if (runs.size() == 1 && runs.front().summary.steady) {
    const double factor = time_unit(runs).factor;
    plot.spans.push_back({factor * runs.front().begin(), factor * runs.front().end(), "steady part", "steady"});
  }
  return plot;
}

Curve curve_of(const RunData& run, const Column& column, const Unit& unit, const Unit& time, int style) {
  return {.name = {},
          .x = scaled(run.series->time_of(column), time.factor),
          .y = scaled(column.part(0), unit.factor),
          .style = style};
}

Curve mean_curve(const RunData& run, const Column& column, const Unit& unit, const Unit& time, int style) {
  const Points means = running_mean(run.series->time(), column.part(0), mean_span(run));
  return {.name = {}, .x = scaled(means.x, time.factor), .y = scaled(means.y, unit.factor), .style = style};
}

/// A plot of columns as they are. Several runs show the first column only, a curve for each run.
std::string plain_plot(const Runs& runs, const std::string& title, const std::string& what,
                       const std::vector<Shown>& shown, const std::string& note = "") {
  const Unit unit = shown_unit(units_of(runs, shown), largest_of(runs, shown)), time = time_unit(runs);
  LinePlot plot = plot_of(runs, title, what, unit);
  plot.note = note;
  int style = 0;
  for (const RunData& run : runs)
    for (const Shown& s : shown) {
      const Column* column = column_of(run, s.name);
      if (!column) continue;
      plot.curves.push_back(curve_of(run, *column, unit, time, style++ % styles));
      if (runs.size() > 1)
        plot.curves.back().name = run.name;
      else if (shown.size() > 1)
        plot.curves.back().name = s.label;
      if (runs.size() > 1) break;
    }
  return has_points(plot) ? figure(plot) : "";
}

/// A plot of noisy columns: each row pale, with means over gyrations; only the means of several runs.
std::string mean_plot(const Runs& runs, const std::string& title, const std::string& what,
                      const std::vector<Shown>& shown, const std::string& note, bool rows = true) {
  const Unit unit = shown_unit(units_of(runs, shown), largest_of(runs, shown)), time = time_unit(runs);
  LinePlot plot = plot_of(runs, title, what, unit);
  plot.note = "Lines: " + mean_words(runs) + (rows && runs.size() == 1 ? "; pale: each row of the run. " : ". ") + note;
  int style = 0;
  std::vector<Curve> means;
  for (const RunData& run : runs)
    for (const Shown& s : shown) {
      const Column* column = column_of(run, s.name);
      if (!column) continue;
      if (runs.size() == 1 && rows) {
        plot.curves.push_back(curve_of(run, *column, unit, time, style % styles));
        plot.curves.back().line = Curve::Line::faint;
      }
      means.push_back(mean_curve(run, *column, unit, time, style++ % styles));
      means.back().name = runs.size() > 1 ? run.name : shown.size() > 1 ? s.label : "";
      if (runs.size() > 1) break;
    }
  plot.curves.insert(plot.curves.end(), means.begin(), means.end());
  return has_points(plot) ? figure(plot) : "";
}

std::string power_plot(const Runs& runs) {
  const bool one = runs.size() == 1;
  return mean_plot(
      runs, one ? "Power of crushing and of the motor" : "Crushing power", "power",
      {{"crushing_power", "crushing power: from the mantle to the rock"}, {"motor_power", "motor power at its shaft"}},
      one && runs.front().summary.steady ? "Mean of the crushing power while steady: " +
                                               number_with_error(runs.front().summary.steady->crushing_power.value,
                                                                 runs.front().summary.steady->crushing_power.error) +
                                               " W."
                                         : "");
}

/// The events of the drive by their numbers in the list of the first section; those close to each other share a mark.
std::vector<Mark> event_marks(const RunData& run, const Unit& time) {
  constexpr double near = 0.03;  // of the run
  constexpr std::size_t most = 12;
  std::vector<Mark> marks;
  const auto& events = run.summary.drive_events;
  for (std::size_t k = 0; k < events.size() && events.size() <= most; ++k) {
    const double at = time.factor * events[k].time;
    if (!marks.empty() && at - marks.back().x < near * time.factor * run.end())
      marks.back().name += ", " + std::to_string(k + 1);
    else
      marks.push_back({at, std::to_string(k + 1)});
  }
  return marks;
}

std::string speed_plot(const Runs& runs) {
  const Unit unit = shown_unit("rad/s", 0), time = time_unit(runs);
  LinePlot plot = plot_of(runs, "Speed of the eccentric", "speed", unit);
  plot.y.zero = false;
  plot.note = "The speed falls where the rock takes more than the motor gives.";
  int style = 0;
  for (const RunData& run : runs)
    if (const Column* speed = column_of(run, "eccentric_speed")) {
      plot.curves.push_back(curve_of(run, *speed, unit, time, style++ % styles));
      if (runs.size() > 1) plot.curves.back().name = run.name;
    }
  if (runs.size() == 1) plot.marks = event_marks(runs.front(), time);
  if (!plot.marks.empty()) plot.note += " Numbers: events of the drive, listed under the results.";
  return has_points(plot) ? figure(plot) : "";
}

std::string bond_plot(const Runs& runs) {
  const bool one = runs.size() == 1;
  LinePlot plot =
      plot_of(runs, one ? "Broken bonds since the start, by the way they broke" : "Broken bonds since the start",
              "broken bonds", {1, ""});
  const Unit time = time_unit(runs);
  int style = 0;
  for (const RunData& run : runs) {
    const Column *tension = column_of(run, "bonds_broken_tension"), *shear = column_of(run, "bonds_broken_shear");
    if (!tension || !shear) continue;
    plot.curves.push_back(curve_of(run, *tension, {1, ""}, time, style++ % styles));
    if (one) {
      plot.curves.back().name = "in tension";
      plot.curves.push_back(curve_of(run, *shear, {1, ""}, time, style++ % styles));
      plot.curves.back().name = "in shear";
    } else {
      plot.curves.back().name = run.name;
      for (std::size_t k = 0; k < plot.curves.back().y.size(); ++k) plot.curves.back().y[k] += shear->values[k];
    }
  }
  return has_points(plot) ? figure(plot) : "";
}

/// Magnitudes of the forces on the walls, of a run without a mantle.
std::string wall_plot(const RunData& run) {
  constexpr std::size_t most = 6;
  std::vector<const Column*> walls;
  double highest = 0;
  if (!run.series || column_of(run, "crushing_power")) return "";
  for (const Column& c : run.series->columns())
    if (c.name.starts_with("wall_force_") && c.width == 3 && walls.size() < most) walls.push_back(&c);
  for (const Column* c : walls) highest = std::max(highest, largest(c->values));
  const Unit unit = shown_unit("N", highest), time = time_unit({run});
  LinePlot plot = plot_of({run}, "Force of the rock on the walls", "force", unit);
  plot.note = "Magnitude of the mean force over each row of the run.";
  int style = 0;
  for (const Column* c : walls) {
    Curve curve = curve_of(run, *c, unit, time, style++ % styles);
    for (std::size_t k = 0; k < curve.y.size(); ++k)
      curve.y[k] = unit.factor * std::hypot(c->values[3 * k], c->values[3 * k + 1], c->values[3 * k + 2]);
    curve.name = c->name.substr(std::string("wall_force_").size());
    plot.curves.push_back(std::move(curve));
  }
  return has_points(plot) ? figure(plot) : "";
}

std::string mass_plots(const Runs& runs) {
  if (runs.size() > 1)
    return plain_plot(runs, "Rock in the chamber", "mass", {{"holdup_mass", ""}}) +
           plain_plot(runs, "Discharged rock", "mass", {{"discharged_mass", ""}});
  return plain_plot(runs, "Rock fed, in the chamber and discharged", "mass",
                    {{"holdup_mass", "in the chamber"}, {"discharged_mass", "discharged"}, {"feed_mass", "fed"}});
}

}  // namespace

std::string time_section(const Runs& runs) {
  std::string figures = speed_plot(runs);
  figures += mean_plot(runs, "Torque of the motor at its shaft", "torque", {{"motor_torque", ""}}, "");
  figures += power_plot(runs);
  const bool discharge =
      std::ranges::any_of(runs, [](const RunData& run) { return run.summary.discharged_mass.value_or(0) > 0; });
  if (discharge)
    figures += mean_plot(runs, "Throughput: rock that passes the discharge opening", "throughput", {{"throughput", ""}},
                         "", false);
  const bool rock = std::ranges::any_of(
      runs, [](const RunData& run) { return run.series && largest(run.series->values("holdup_mass")) > 0; });
  if (rock) figures += mass_plots(runs);
  figures += bond_plot(runs);
  if (runs.size() == 1) figures += wall_plot(runs.front());
  return section("time", "Over time", side_by_side(figures));
}

}  // namespace gyro::report

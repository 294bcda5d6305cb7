// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/headline.hpp"
#include "app/report/plot/line_plot.hpp"
#include "app/report/sections/sections.hpp"
#include "app/report/text.hpp"
#include "io/run/progress.hpp"

#include <algorithm>

namespace gyro::report {
namespace {

std::string titled(const std::string& label, const std::string& about) {
  return "<span title=\"" + escape(about) + "\">" + escape(label) + "</span>";
}

std::string rate(const std::optional<std::int64_t>& steps, double seconds) {
  return steps && seconds > 0 ? number(static_cast<double>(*steps) / seconds * 1e-6) + " million/s" : "–";
}

std::string last_of(const RunData& run, const char* column) {
  const auto values = run.performance ? run.performance->values(column) : std::vector<double>();
  return values.empty() ? "–" : count(static_cast<std::int64_t>(values.back()));
}

std::string performance_table(const Runs& runs) {
  std::vector<std::string> head{""};
  std::vector<std::vector<std::string>> rows{
      {titled("Wall-clock time", about_figure("wall_seconds"))},
      {titled("Simulated time", about_figure("simulated_seconds"))},
      {titled("Wall-clock time for a simulated second", "wall-clock time / simulated time")},
      {titled("Particle-steps", about_figure("particle_steps") + ", in a second of the clock")},
      {titled("Bond-steps", about_figure("bond_steps") + ", in a second of the clock")},
      {titled("List rebuilds", "searches in space for neighbours since the start")},
      {titled("Time step of bonds", about_figure("time_step"))},
      {titled("Time for which contact forces are held", about_figure("hold"))}};
  for (const RunData& run : runs) {
    const Summary& s = run.summary;
    head.push_back(runs.size() > 1 ? escape(run.name) : "Value");
    rows[0].push_back(escape(format_duration(s.wall_seconds)));
    rows[1].push_back(quantity(s.simulated_seconds, "s"));
    rows[2].push_back(s.simulated_seconds > 0 ? escape(format_duration(s.wall_seconds / s.simulated_seconds)) : "–");
    rows[3].push_back(rate(s.particle_steps, s.wall_seconds));
    rows[4].push_back(rate(s.bond_steps, s.wall_seconds));
    rows[5].push_back(last_of(run, "list_rebuilds"));
    rows[6].push_back(quantity(s.time_step, "s"));
    rows[7].push_back(quantity(s.hold, "s"));
  }
  return html_table(head, rows);
}

std::string speed_plot(const Runs& runs) {
  constexpr std::size_t spans = 60;
  double end = 0;
  for (const RunData& run : runs) end = std::max(end, run.end());
  const Unit time = shown_unit("s", end);
  LinePlot plot{.title = "Speed of the computation over simulated time"};
  plot.x = {.label = "simulated time [" + time.name + "]", .low = 0, .high = time.factor * end};
  plot.y = {.label = "particle-steps [million/s]", .zero = true};
  int style = 0;
  for (const RunData& run : runs) {
    if (!run.performance) continue;
    const auto steps = run.performance->values("particle_steps"), clock = run.performance->values("wall_seconds");
    if (steps.size() != clock.size()) continue;
    Curve curve{.name = runs.size() > 1 ? run.name : "", .x = {}, .y = {}, .style = style++ % 7};
    const std::size_t stride = std::max<std::size_t>(1, steps.size() / spans);
    for (std::size_t k = stride; k < steps.size(); k += stride) {
      const double seconds = clock[k] - clock[k - stride];
      if (!(seconds > 0)) continue;
      curve.x.push_back(time.factor * (run.performance->time()[k] + run.performance->time()[k - stride]) / 2);
      curve.y.push_back(1e-6 * (steps[k] - steps[k - stride]) / seconds);
    }
    plot.curves.push_back(std::move(curve));
  }
  plot.note = "One particle-step is one particle moved by one time step.";
  return has_points(plot) ? figure(plot) : "";
}

std::string phase_table(const RunData& run) {
  constexpr std::size_t shown = 8;
  double all = 0, others = 0;
  for (const auto& [name, seconds] : run.phases) all += seconds;
  if (!(all > 0)) return "";
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const std::string& name, double seconds) {
    rows.push_back({escape(name), quantity(seconds, "s"), number(100 * seconds / all) + " %"});
  };
  for (std::size_t k = 0; k < run.phases.size(); ++k) {
    if (k < shown)
      row(run.phases[k].first, run.phases[k].second);
    else
      others += run.phases[k].second;
  }
  if (run.phases.size() > shown) row("all other phases", others);
  return html_table({"Phase of a step", "Time", "Share"}, rows);
}

}  // namespace

std::string performance_section(const Runs& runs) {
  const std::string phases = by_run(runs, phase_table);
  return section("performance", "Performance of the computation",
                 side_by_side(speed_plot(runs) + "<div>" + performance_table(runs) + "</div>" +
                              (phases.empty() ? "" : "<div>" + phases + "</div>")));
}

std::string provenance_section(const Runs& runs) {
  std::string html;
  std::vector<std::string> head{""};
  std::vector<std::vector<std::string>> rows{{"Case"},   {"Directory"}, {"gyrosim"},   {"Commit"},
                                             {"Device"}, {"Threads"},   {"Precision"}, {"Seed"}};
  for (const RunData& run : runs) {
    const Provenance& p = run.provenance;
    head.push_back(runs.size() > 1 ? escape(run.name) : "Value");
    rows[0].push_back(escape(run.summary.title));
    rows[1].push_back(escape(run.directory.string()));
    rows[2].push_back(escape(p.version));
    rows[3].push_back(escape(p.git));
    rows[4].push_back(escape(p.device));
    rows[5].push_back(count(run.summary.threads));
    rows[6].push_back(escape(p.precision));
    rows[7].push_back(escape(p.seed));
    html += folded(runs.size() > 1 ? "The case of " + run.name : "The case with all defaults (YAML)",
                   "<pre>" + escape(p.yaml) + "</pre>");
  }
  return section("provenance", "Where these numbers come from", html_table(head, rows) + html);
}

}  // namespace gyro::report

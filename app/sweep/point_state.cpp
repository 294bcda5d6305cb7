// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/point_state.hpp"

#include "app/output/steady_goal.hpp"
#include "io/case/parts.hpp"
#include "io/files/read_file.hpp"
#include "io/run/run_lock.hpp"
#include "io/run/summary.hpp"

#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace gyro {
namespace {

namespace fs = std::filesystem;

constexpr double same_time = 1e-6;  ///< relative difference of two times that are the same

bool is_known(const std::optional<Estimate>& figure, double error) {
  return figure && figure->error <= error * std::abs(figure->value);
}

/// Whether a finished run reaches the end that the sweep asks for, which may have changed since; judged as
/// `run --until steady` does.
bool has_ended(const fs::path& run, double simulated, const CheckedSweep& sweep, const CheckedPoint& point) {
  if (simulated >= point.end * (1 - same_time)) return true;
  if (!sweep.until.steady) return false;
  const double error = *sweep.until.steady;
  const std::optional<SteadyFigures> steady = load_summary(run).steady;
  return steady && steady->gyrations >= static_cast<std::int64_t>(gyrations_of_errors) &&
         is_known(steady->throughput_tph, error) && is_known(steady->crushing_power, error) &&
         is_known(steady->p80, error);
}

/// Cells of a line of points.csv, whose cells hold no line ends.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

/// The place to blame for a key: its value in the sweep file, or the case that has it.
Mark mark_of(const CheckedSweep& sweep, const CheckedPoint& point, const std::string& key) {
  for (const SweepSetting& setting : settings_of(sweep.file, point.point))
    if (key == setting.key || key.starts_with(setting.key + ".")) return setting.value_mark;
  return sweep.file.case_mark;
}

}  // namespace

const char* to_string(PointState state) {
  switch (state) {
    case PointState::waiting:
      return "waiting";
    case PointState::half_done:
      return "interrupted";
    case PointState::done:
      return "done";
    case PointState::stopped:
      return "stopped";
    case PointState::failed:
      return "failed";
    case PointState::running:
      return "running";
  }
  return "failed";
}

PointState state_of(const fs::path& directory, const CheckedSweep& sweep, const CheckedPoint& point) {
  const fs::path run = directory / point.name;
  if (is_locked(run)) return PointState::running;
  const std::optional<EarlierRun> earlier = read_summary(run);
  if (!earlier) return fs::exists(run / "results.h5") ? PointState::half_done : PointState::waiting;
  if (earlier->status == "stopped") return PointState::stopped;
  if (earlier->status == "failed") return PointState::failed;
  if (earlier->status != "done") return PointState::half_done;
  return has_ended(run, earlier->simulated_seconds, sweep, point) ? PointState::done : PointState::half_done;
}

fs::path points_file(const fs::path& directory) {
  return directory / "points.csv";
}

fs::path log_file(const fs::path& directory, const std::string& point) {
  return directory / "logs" / (point + ".txt");
}

std::vector<EarlierPoint> read_points(const fs::path& directory) {
  std::vector<EarlierPoint> points;
  if (!fs::exists(points_file(directory))) return points;
  std::istringstream lines(read_file(points_file(directory)));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() > 1) points.push_back({cells.front(), cells.back()});
  }
  return points;
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::string cell = cells[k];
    for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2) cell.insert(at, 1, '"');
    const bool quote = cell.find_first_of(",\"\n\r") != std::string::npos;
    line += (k == 0 ? "" : ",") + (quote ? '"' + cell + '"' : cell);
  }
  return line + "\n";
}

std::string points_table(const CheckedSweep& sweep) {
  std::vector<std::string> cells{"name"};
  for (const std::string& key : varied_keys(sweep.file)) cells.push_back(key);
  cells.insert(cells.end(), {"seed", "input_files"});
  std::string text = csv_line(cells);
  for (const CheckedPoint& point : sweep.points) {
    cells = {point.name};
    for (const SweepSetting& setting : point.point.varied) cells.push_back(setting.value);
    cells.insert(cells.end(), {std::to_string(point.seed), point.inputs});
    text += csv_line(cells);
  }
  return text;
}

std::vector<CaseProblem> changed_points(const fs::path& directory, const CheckedSweep& sweep) {
  CaseProblems problems(sweep.file.file.string());
  std::map<std::string, std::string> inputs;
  for (const EarlierPoint& point : read_points(directory)) inputs[point.name] = point.inputs;
  for (const CheckedPoint& point : sweep.points) {
    const fs::path run = directory / point.name, file = run / "case.yaml";
    if (!fs::exists(file)) continue;
    const std::string advice =
        "; restore it, remove " + run.string() + " to run the point again, or give another directory with --out";
    if (const auto differs = difference(point.resolved, read_file(file)))
      problems.add(mark_of(sweep, point, differs->key), "the point " + point.name + " now has " + differs->key + " = " +
                                                            differs->value + ", and was run with " + differs->other +
                                                            advice);
    const auto known = inputs.find(point.name);
    if (known != inputs.end() && known->second != point.inputs)
      problems.add(sweep.file.case_mark,
                   "a file that the case names has changed since the point " + point.name + " was run" + advice);
  }
  return problems.sorted();
}

std::vector<std::string> former_points(const fs::path& directory, const CheckedSweep& sweep) {
  std::set<std::string> now;
  for (const CheckedPoint& point : sweep.points) now.insert(point.name);
  std::vector<std::string> former;
  for (const EarlierPoint& point : read_points(directory))
    if (!now.contains(point.name) && fs::exists(directory / point.name)) former.push_back(point.name);
  return former;
}

}  // namespace gyro

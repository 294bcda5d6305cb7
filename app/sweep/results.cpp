// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/results.hpp"

#include "io/files/read_file.hpp"
#include "io/schema/schema.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace gyro {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A number or a truth value of summary.json; NaN for everything else.
double number_in(const json& summary, const std::string& name) {
  const json* node = &summary;
  for (const std::string_view part : split(name, '.')) {
    const auto found = node->is_object() ? node->find(std::string(part)) : node->end();
    if (found == node->end()) return missing;
    node = &*found;
  }
  return node->is_number() ? node->get<double>() : node->is_boolean() ? (node->get<bool>() ? 1 : 0) : missing;
}

/// A figure that is computed from those of the summary.
struct Derived {
  SweepFigure figure;
  std::function<double(const json&)> value;
};

const std::vector<Derived>& derived_figures() {
  static const std::vector<Derived> all{
      {{"broken_share", "1", "bonds_broken / bonds_initial"},
       [](const json& summary) { return number_in(summary, "bonds_broken") / number_in(summary, "bonds_initial"); }}};
  return all;
}

/// Every figure that a summary can have as a number, in the order of the file; then those computed from them.
std::vector<SweepFigure> possible_figures() {
  std::vector<SweepFigure> figures;
  for (const SummaryMember& member : summary_members())
    if (member.name.find("[]") == std::string::npos)
      figures.push_back({member.name, member.units == "-" ? "1" : member.units, member.description});
  for (const Derived& derived : derived_figures()) figures.push_back(derived.figure);
  return figures;
}

std::vector<double> figures_of(const json& summary) {
  std::vector<double> values;
  for (const SummaryMember& member : summary_members())
    if (member.name.find("[]") == std::string::npos) values.push_back(number_in(summary, member.name));
  for (const Derived& derived : derived_figures()) values.push_back(derived.value(summary));
  return values;
}

json read_summary_json(const fs::path& run) {
  const fs::path file = run / "summary.json";
  return fs::exists(file) ? json::parse(read_file(file), nullptr, false) : json();
}

bool is_number(const std::string& text) {
  double value;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && rest == text.data() + text.size();
}

/// The keys that vary; units are those of the table of keys, if all values are numbers.
std::vector<SweepKey> keys_of(const CheckedSweep& sweep, const std::vector<PointResult>& points) {
  std::vector<SweepKey> keys;
  const std::vector<std::string> names = varied_keys(sweep.file);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Key* key = match_key(names[k]);
    const bool numbers =
        std::all_of(points.begin(), points.end(), [&](const PointResult& point) { return is_number(point.si[k]); });
    const std::string unit = key && numbers ? std::string(si_unit(key->dimension)) : "";
    keys.push_back({names[k], sweep.names[k],
                    !numbers       ? "-"
                    : unit.empty() ? "1"
                                   : unit,
                    key ? std::string(key->doc) : ""});
  }
  return keys;
}

/// Leaves out the figures that no point has.
void drop_empty_figures(SweepResults& results) {
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < results.figures.size(); ++k)
    if (std::any_of(results.points.begin(), results.points.end(),
                    [&](const PointResult& point) { return std::isfinite(point.figures[k]); }))
      kept.push_back(k);
  std::vector<SweepFigure> figures;
  for (const std::size_t k : kept) figures.push_back(results.figures[k]);
  results.figures = std::move(figures);
  for (PointResult& point : results.points) {
    std::vector<double> values;
    for (const std::size_t k : kept) values.push_back(point.figures[k]);
    point.figures = std::move(values);
  }
}

}  // namespace

SweepResults collect(const fs::path& directory, const CheckedSweep& sweep) {
  SweepResults results;
  results.figures = possible_figures();
  for (const CheckedPoint& point : sweep.points) {
    PointResult result{.name = point.name, .setting = point.setting, .values = {}, .si = {}, .figures = {}};
    for (const SweepSetting& setting : point.point.varied) {
      const std::string si = resolved_value(point.resolved, setting.key);
      result.values.push_back(setting.value);
      result.si.push_back(si.empty() ? setting.value : si);
    }
    result.seed = point.seed;
    result.state = state_of(directory, sweep, point);
    result.figures = figures_of(read_summary_json(directory / point.name));
    results.points.push_back(std::move(result));
  }
  results.keys = keys_of(sweep, results.points);
  drop_empty_figures(results);
  return results;
}

Estimate mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (values.empty()) return {missing, missing};
  double sum = 0, squares = 0;
  for (const double x : values) sum += x;
  const double mean = sum / n;
  for (const double x : values) squares += (x - mean) * (x - mean);
  return {mean, n < 2 ? missing : std::sqrt(squares / (n - 1) / n)};
}

std::vector<SettingResult> by_setting(const SweepResults& results) {
  std::vector<SettingResult> settings;
  std::vector<std::vector<std::vector<double>>> values;  // by setting, figure, seed
  std::map<std::string, std::size_t> places;
  for (const PointResult& point : results.points) {
    const auto [place, is_new] = places.try_emplace(point.setting, settings.size());
    if (is_new) {
      settings.push_back(
          {.setting = point.setting, .values = point.values, .si = point.si, .seeds = {}, .figures = {}});
      values.emplace_back(results.figures.size());
    }
    ++settings[place->second].points;
    if (point.state != PointState::done) continue;
    settings[place->second].seeds.push_back(point.seed);
    for (std::size_t k = 0; k < results.figures.size(); ++k) values[place->second][k].push_back(point.figures[k]);
  }
  for (std::size_t s = 0; s < settings.size(); ++s)
    for (const std::vector<double>& of_figure : values[s]) settings[s].figures.push_back(mean_of(of_figure));
  return settings;
}

int find_figure(const SweepResults& results, const std::string& name) {
  for (std::size_t k = 0; k < results.figures.size(); ++k)
    if (results.figures[k].name == name) return static_cast<int>(k);
  return -1;
}

}  // namespace gyro

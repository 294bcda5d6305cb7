// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/results_files.hpp"

#include "io/hdf5/hdf5.hpp"
#include "io/run/replace_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace gyro {
namespace {

/// The shortest text that reads back to the same number; empty for none.
std::string number_cell(double value) {
  if (!std::isfinite(value)) return {};
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), end);
}

/// Writes the columns of one group.
class GroupWriter {
 public:
  GroupWriter(hdf5::File& file, std::string group) : file_(file), group_(std::move(group)) {}

  void numbers(const std::string& name, const std::vector<double>& values, const std::string& units,
               const std::string& description, hdf5::Number number = hdf5::Number::float64) {
    file_.write_numbers(place(name), values, number);
    describe(name, units, description);
  }
  void texts(const std::string& name, const std::vector<std::string>& values, const std::string& description) {
    file_.write_strings(place(name), values);
    describe(name, "-", description);
  }

 private:
  /// A key may have a slash, as contacts.rock/steel.friction, which would divide a path.
  std::string place(std::string name) const {
    std::replace(name.begin(), name.end(), '/', '-');
    return group_ + "/" + name;
  }
  void describe(const std::string& name, const std::string& units, const std::string& description) {
    file_.set_attribute(place(name), "units", units);
    file_.set_attribute(place(name), "description", description);
  }

  hdf5::File& file_;
  std::string group_;
};

/// A key's values in points or settings, as numbers where they are numbers.
template <class Rows>
void write_keys(GroupWriter& group, const SweepResults& results, const Rows& rows) {
  for (std::size_t k = 0; k < results.keys.size(); ++k) {
    std::vector<std::string> texts;
    std::vector<double> numbers;
    for (const auto& row : rows) {
      texts.push_back(row.si[k]);
      numbers.push_back(std::strtod(row.si[k].c_str(), nullptr));
    }
    const SweepKey& key = results.keys[k];
    if (key.units == "-")
      group.texts(key.key, texts, key.description);
    else
      group.numbers(key.key, numbers, key.units, key.description);
  }
}

void write_points(hdf5::File& file, const SweepResults& results) {
  GroupWriter group(file, "/points");
  std::vector<std::string> names, states;
  std::vector<double> seeds;
  for (const PointResult& point : results.points) {
    names.push_back(point.name);
    states.emplace_back(to_string(point.state));
    seeds.push_back(static_cast<double>(point.seed));
  }
  group.texts("name", names, "name of the point and its directory");
  write_keys(group, results, results.points);
  group.numbers("seed", seeds, "1", "seed of all random numbers", hdf5::Number::int64);
  group.texts("status", states, "done, interrupted, stopped, failed, running or waiting");
  for (std::size_t k = 0; k < results.figures.size(); ++k) {
    std::vector<double> values;
    for (const PointResult& point : results.points) values.push_back(point.figures[k]);
    group.numbers(results.figures[k].name, values, results.figures[k].units, results.figures[k].description);
  }
}

void write_settings(hdf5::File& file, const SweepResults& results) {
  const std::vector<SettingResult> settings = by_setting(results);
  GroupWriter group(file, "/settings"), means(file, "/settings/mean"), errors(file, "/settings/standard_error");
  std::vector<std::string> names;
  std::vector<double> counts;
  for (const SettingResult& setting : settings) {
    names.push_back(setting.setting);
    counts.push_back(static_cast<double>(setting.seeds.size()));
  }
  group.texts("name", names, "names of its points without the seed");
  write_keys(group, results, settings);
  group.numbers("done", counts, "1", "points of the setting that are done, over which the means are taken",
                hdf5::Number::int64);
  for (std::size_t k = 0; k < results.figures.size(); ++k) {
    std::vector<double> mean, error;
    for (const SettingResult& setting : settings) {
      mean.push_back(setting.figures[k].value);
      error.push_back(setting.figures[k].error);
    }
    const SweepFigure& figure = results.figures[k];
    means.numbers(figure.name, mean, figure.units, figure.description);
    errors.numbers(figure.name, error, figure.units, "standard error of the mean over seeds: " + figure.description);
  }
}

}  // namespace

std::string results_csv(const SweepResults& results) {
  std::vector<std::string> cells{"name"};
  for (const SweepKey& key : results.keys) cells.push_back(key.key);
  cells.insert(cells.end(), {"seed", "status"});
  for (const SweepFigure& figure : results.figures) cells.push_back(figure.name);
  std::string text = csv_line(cells);
  for (const PointResult& point : results.points) {
    cells = {point.name};
    cells.insert(cells.end(), point.si.begin(), point.si.end());
    cells.insert(cells.end(), {std::to_string(point.seed), to_string(point.state)});
    for (const double value : point.figures) cells.push_back(number_cell(value));
    text += csv_line(cells);
  }
  return text;
}

void write_results_h5(const SweepResults& results, const std::filesystem::path& file) {
  std::filesystem::path part = file;
  part += ".tmp";
  {
    hdf5::File out = hdf5::File::create(part);
    write_points(out, results);
    write_settings(out, results);
    out.close();
  }
  put_in_place(file);
}

}  // namespace gyro

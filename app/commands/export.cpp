// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "core/base/errors.hpp"
#include "io/hdf5/hdf5.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>

namespace gyro {
namespace {

/// A quantity of the series: one or three columns.
struct Quantity {
  std::string name, units;
  std::size_t columns;
  std::vector<double> values;
  std::size_t rows() const { return values.size() / columns; }
};

/// "time_s", "mantle_force_x_N": spaces would not survive every reader.
std::string heading(const Quantity& q, std::size_t column) {
  std::string text = q.name;
  if (q.columns > 1)
    text += std::string("_") + (q.columns == 3 ? std::string(1, "xyz"[column]) : std::to_string(column));
  if (q.units != "1") text += "_" + q.units;
  std::ranges::replace(text, ' ', '.');
  return text;
}

std::vector<Quantity> read_series(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "results.h5";
  if (!std::filesystem::exists(file))
    throw BadInput(run.string() + " holds no results.h5; give the directory of a run");
  const hdf5::File results = hdf5::File::open(file);
  std::vector<Quantity> series;
  std::vector<std::string> names = results.children("/series");
  std::ranges::stable_partition(names, [](const std::string& name) { return name == "time"; });
  for (const std::string& name : names) {
    const hdf5::Dataset dataset = results.dataset("/series/" + name);
    series.push_back(
        {name, dataset.string_attribute("units"), static_cast<std::size_t>(dataset.columns()), dataset.read()});
  }
  return series;
}

void write_csv(const std::vector<Quantity>& series, std::ostream& out) {
  std::size_t rows = series.empty() ? 0 : series.front().rows();
  for (const Quantity& q : series) rows = std::min(rows, q.rows());  // of a run in progress the last may be unequal
  std::string line;
  const auto end_line = [&] {
    line.back() = '\n';
    out << line;
    line.clear();
  };
  for (const Quantity& q : series)
    for (std::size_t c = 0; c < q.columns; ++c) line += heading(q, c) + ",";
  end_line();
  char number[32];
  for (std::size_t k = 0; k < rows; ++k) {
    for (const Quantity& q : series)
      for (std::size_t c = 0; c < q.columns; ++c) {
        std::snprintf(number, sizeof number, "%.17g,", q.values[k * q.columns + c]);
        line += number;
      }
    end_line();
  }
}

}  // namespace

int export_command(const std::filesystem::path& run, const std::optional<std::filesystem::path>& out) {
  const std::vector<Quantity> series = read_series(run);
  if (series.empty()) throw BadInput(run.string() + " has no series; give the directory of a run");
  if (!out) {
    write_csv(series, std::cout);
    return exit_done;
  }
  std::ofstream file(*out, std::ios::binary);
  write_csv(series, file);
  file.close();
  if (!file) throw OutputError(out->string() + ": cannot be written");
  return exit_done;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "core/base/errors.hpp"
#include "io/hdf5/hdf5.hpp"

#include <algorithm>
#include <array>
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
  std::vector<double> sizes = {};  ///< of the sieves of the columns, where they are sieves [m]
  std::size_t rows() const { return values.size() / columns; }
};

/// "time_s", "mantle_force_x_N", "passing_12.5mm": spaces would not survive every reader.
std::string heading(const Quantity& q, std::size_t column) {
  std::string text = q.name;
  if (column < q.sizes.size()) {
    std::array<char, 32> size;
    std::snprintf(size.data(), size.size(), "_%.4gmm", q.sizes[column] * 1e3);
    return text + size.data();
  }
  if (q.columns > 1)
    text += std::string("_") + (q.columns == 3 ? std::string(1, "xyz"[column]) : std::to_string(column));
  if (q.units != "1") text += "_" + q.units;
  std::ranges::replace(text, ' ', '.');
  return text;
}

/// Sizes of the sieves of a table, or nothing: columns of `passing` are named after them.
std::vector<double> sizes_of(const hdf5::File& results, const std::string& group) {
  return results.contains(group + "/sizes") ? results.dataset(group + "/sizes").read() : std::vector<double>();
}

hdf5::File open_results(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "results.h5";
  if (!std::filesystem::exists(file))
    throw BadInput(run.string() + " holds no results.h5; give the directory of a run");
  return hdf5::File::open(file);
}

/// The tables of a run that have rows of their own. Groups within groups, as those of /liners, mix them with datasets
/// that are written once.
std::vector<std::string> tables_in(const hdf5::File& results) {
  std::vector<std::string> names = results.children("/");
  std::erase_if(names, [&](const std::string& name) { return !results.contains("/" + name + "/time"); });
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<Quantity> read_table(const std::filesystem::path& run, const std::string& table) {
  const hdf5::File results = open_results(run);
  const std::string group = "/" + table;
  if (const std::vector<std::string> tables = tables_in(results); std::ranges::find(tables, table) == tables.end())
    throw BadInput(run.string() + " has no table " + table + "; it has " + listed(tables));
  std::vector<Quantity> quantities;
  std::vector<std::string> names = results.children(group);
  std::ranges::stable_partition(names, [](const std::string& name) { return name == "time"; });
  for (const std::string& name : names) {
    if (name == "sizes") continue;  // one row for all times
    const hdf5::Dataset dataset = results.dataset(group + "/" + name);
    quantities.push_back({name, dataset.string_attribute("units"), static_cast<std::size_t>(dataset.columns()),
                          dataset.read(),
                          name.starts_with("passing") ? sizes_of(results, group) : std::vector<double>()});
  }
  return quantities;
}

void write_csv(const std::vector<Quantity>& table, std::ostream& out) {
  std::size_t rows = table.empty() ? 0 : table.front().rows();
  for (const Quantity& q : table) rows = std::min(rows, q.rows());  // of a run in progress the last may be unequal
  std::string line;
  const auto end_line = [&] {
    line.back() = '\n';
    out << line;
    line.clear();
  };
  for (const Quantity& q : table)
    for (std::size_t c = 0; c < q.columns; ++c) line += heading(q, c) + ",";
  end_line();
  char number[32];
  for (std::size_t k = 0; k < rows; ++k) {
    for (const Quantity& q : table)
      for (std::size_t c = 0; c < q.columns; ++c) {
        std::snprintf(number, sizeof number, "%.17g,", q.values[k * q.columns + c]);
        line += number;
      }
    end_line();
  }
}

}  // namespace

int export_command(const ExportArguments& arguments) {
  const std::vector<Quantity> table = read_table(arguments.run, arguments.table);
  if (!arguments.out) {
    write_csv(table, std::cout);
    return exit_done;
  }
  std::ofstream file(*arguments.out, std::ios::binary);
  write_csv(table, file);
  file.close();
  if (!file) throw OutputError(arguments.out->string() + ": cannot be written");
  return exit_done;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/table.hpp"

#include <algorithm>

namespace gyro::report {

std::vector<double> Column::part(std::size_t k) const {
  std::vector<double> numbers;
  for (std::size_t at = k; at < values.size(); at += width) numbers.push_back(values[at]);
  return numbers;
}

Table::Table(const hdf5::File& file, const std::string& group, const std::vector<std::string>& names) {
  time_ = file.dataset(group + "/time").read();
  for (const std::string& name : file.children(group)) {
    if (file.is_group(group + "/" + name)) continue;
    if (std::ranges::find(names, name) == names.end()) continue;
    const hdf5::Dataset data = file.dataset(group + "/" + name);
    columns_.push_back({name, data.string_attribute("units"), data.string_attribute("description"),
                        data.string_attribute("sampling"),
                        static_cast<std::size_t>(std::max<std::int64_t>(1, data.columns())), data.read()});
  }
  std::size_t rows = time_.size();
  for (const Column& c : columns_) rows = std::min(rows, c.values.size() / c.width);
  time_.resize(rows);
  for (Column& c : columns_) c.values.resize(rows * c.width);
}

std::vector<double> Table::time_of(const Column& column) const {
  if (!column.is_mean()) return time_;
  std::vector<double> middles(time_);
  for (std::size_t k = 0; k < time_.size(); ++k) middles[k] = (time_[k] + (k > 0 ? time_[k - 1] : 0)) / 2;
  return middles;
}

const Column* Table::find(std::string_view name) const {
  const auto found = std::ranges::find(columns_, name, &Column::name);
  return found == columns_.end() ? nullptr : &*found;
}

std::vector<double> Table::values(std::string_view name) const {
  const Column* column = find(name);
  return column && column->width == 1 ? column->values : std::vector<double>();
}

std::optional<Table> read_table(const hdf5::File& file, const std::string& group,
                                const std::vector<std::string>& names) {
  if (!file.contains(group) || !file.is_group(group) || !file.contains(group + "/time")) return std::nullopt;
  return Table(file, group, names);
}

}  // namespace gyro::report

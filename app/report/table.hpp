// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/hdf5/hdf5.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyro::report {

/// A dataset of results.h5.
struct Column {
  std::string name, units, description, sampling;
  std::size_t width = 1;
  std::vector<double> values;  ///< row after row

  /// One of its numbers in all rows.
  std::vector<double> part(std::size_t k) const;
  bool is_mean() const { return sampling == "mean"; }
};

/// A group of results.h5 with a row for each time. Of a run in progress the last rows may differ in number: all columns
/// are cut to the shortest.
class Table {
 public:
  /// @param names  columns that are read beside `time`, where the group has them
  Table(const hdf5::File& file, const std::string& group, const std::vector<std::string>& names);

  std::size_t rows() const { return time_.size(); }
  const std::vector<double>& time() const { return time_; }
  /// Times of a column: a mean belongs to the middle of its interval.
  std::vector<double> time_of(const Column& column) const;
  const Column* find(std::string_view name) const;  ///< null if there is no such column
  /// Numbers of a column with one number a row; empty if there is no such column.
  std::vector<double> values(std::string_view name) const;
  const std::vector<Column>& columns() const { return columns_; }

 private:
  std::vector<double> time_;
  std::vector<Column> columns_;
};

/// The table, or nothing where the file has no such group or the group no time.
std::optional<Table> read_table(const hdf5::File& file, const std::string& group,
                                const std::vector<std::string>& names);

}  // namespace gyro::report

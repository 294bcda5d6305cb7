// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/channel.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gyro {

/// The datasets of one group while they grow. Rows wait in memory until flush().
class ResultsTable {
 public:
  /// Creates the datasets.
  ResultsTable(hdf5::File& file, const ResultsGroup& group);
  /// Continues datasets that have `rows` rows.
  ResultsTable(const hdf5::File& file, const ResultsGroup& group, std::int64_t rows);

  /// Adds a row. @param row  values of all columns of all channels, in the order of the channels
  void append(std::span<const double> row);
  /// Passes all waiting rows to the operating system.
  void flush();
  std::size_t waiting_rows() const { return waiting_rows_; }
  std::int64_t rows() const { return rows_; }  ///< written and waiting

 private:
  ResultsGroup group_;
  std::vector<hdf5::Dataset> datasets_;
  std::vector<std::vector<double>> waiting_;  ///< one buffer for each channel
  std::size_t row_length_ = 0, waiting_rows_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace gyro

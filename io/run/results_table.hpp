// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/channel.hpp"
#include "io/run/rows_digest.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// How far a group of results.h5 has come, so that a resumed run can find out whether its rows are still the same.
struct GroupMark {
  std::int64_t rows = 0;
  std::map<std::string, std::string> digests;  ///< of these rows, by channel (rows_digest.hpp)
  friend bool operator==(const GroupMark&, const GroupMark&) = default;
};

/// The datasets of one group while they grow. Rows wait in memory until flush().
class ResultsTable {
 public:
  /// Creates the datasets.
  ResultsTable(hdf5::File& file, const ResultsGroup& group);
  /// Continues datasets that have `rows` rows. @param digests  of them, one a channel
  ResultsTable(const hdf5::File& file, const ResultsGroup& group, std::int64_t rows, std::vector<RowsDigest> digests);

  /// Adds a row. @param row  values of all columns of all channels, in the order of the channels
  void append(std::span<const double> row);
  /// Passes all waiting rows to the operating system.
  void flush();
  std::size_t waiting_rows() const { return waiting_rows_; }
  GroupMark mark() const;  ///< of rows written and waiting

 private:
  ResultsGroup group_;
  std::vector<hdf5::Dataset> datasets_;
  std::vector<RowsDigest> digests_;           ///< one a channel
  std::vector<std::vector<double>> waiting_;  ///< one buffer a channel
  std::size_t row_length_ = 0, waiting_rows_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace gyro

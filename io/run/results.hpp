// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/case_record.hpp"
#include "io/run/channel.hpp"
#include "io/run/results_table.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// What results.h5 of a run holds.
struct ResultsContent {
  CaseRecord record;
  std::vector<ResultsGroup> groups;  ///< in the order in which they are made
  std::vector<FixedNumbers> fixed;
};

/// How far the groups of results.h5 have come, by group, as "/series".
using ResultsMarks = std::map<std::string, GroupMark>;

/// results.h5 of a run: /case, groups that grow by rows, and datasets that are written once. Rows are
/// written about every 5 s of wall clock and when the file closes. Readable while it grows and after
/// the process was killed; then the datasets of a group may differ by the last few rows.
/// @throws OutputError on any failure to write
class ResultsFile {
 public:
  ResultsFile(const std::filesystem::path& path, const ResultsContent& content);
  /// Continues the file of a run from the rows `keep`; later rows are dropped. A kill in between leaves
  /// the file as it was. @throws BadInput for a file with less or other content, or with other numbers in these rows
  ResultsFile(const std::filesystem::path& path, const ResultsContent& content, const ResultsMarks& keep);
  /// Closes without reporting failures; call close() on the normal way out.
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Adds a row to a group of the content. @param row  see ResultsTable::append
  void append(const std::string& group, std::span<const double> row);
  /// Hands every waiting row to the operating system.
  void flush();
  /// Waits until the disk has every row.
  void sync();
  ResultsMarks marks() const;
  /// Writes what waits and closes; nothing can be appended afterwards.
  void close();

 private:
  void abandon();

  std::filesystem::path path_;
  std::optional<hdf5::File> file_;
  std::map<std::string, ResultsTable> tables_;  ///< by group
  std::chrono::steady_clock::time_point last_flush_;
};

}  // namespace gyro

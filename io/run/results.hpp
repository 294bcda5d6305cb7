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

/// The contents of results.h5 of a run.
struct ResultsContent {
  CaseRecord record;
  std::vector<ResultsGroup> groups;  ///< in the order in which they are created
  std::vector<FixedNumbers> fixed;
};

/// Rows and digests of each group of results.h5, by its name, such as "/series".
using ResultsMarks = std::map<std::string, GroupMark>;

/// results.h5 of a run: /case, groups that grow by rows, and datasets that are written once. Rows are written about
/// every 5 s of wall-clock time and when the file is closed. The file can be read while it grows and after the process
/// was killed; the datasets of a group may then differ in the number of their last rows.
/// @throws OutputError on any failure to write
class ResultsFile {
 public:
  ResultsFile(const std::filesystem::path& path, const ResultsContent& content);
  /// Continues the file of a run after the rows `keep`; later rows are removed. If the process is killed meanwhile, the
  /// file is unchanged. @throws BadInput for a file with fewer rows, other content, or other numbers in these rows
  ResultsFile(const std::filesystem::path& path, const ResultsContent& content, const ResultsMarks& keep);
  /// Closes the file without reporting failures. Normally close() is called before.
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Adds a row to a group of the content. @param row  see ResultsTable::append
  void append(const std::string& group, std::span<const double> row);
  /// Passes all waiting rows to the operating system.
  void flush();
  /// Waits until all rows are on the disk.
  void sync();
  ResultsMarks marks() const;
  /// Writes all waiting rows and closes the file; nothing can be appended afterwards.
  void close();

 private:
  void abandon();

  std::filesystem::path path_;
  std::optional<hdf5::File> file_;
  std::map<std::string, ResultsTable> tables_;  ///< by group
  std::chrono::steady_clock::time_point last_flush_;
};

}  // namespace gyro

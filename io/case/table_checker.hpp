// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/case/csv.hpp"
#include "io/case/parts.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// Checks a table row by row. Its problems are added to those of the case when the checker ends; one that many rows
/// have is told where it is first.
class TableChecker {
 public:
  TableChecker(const std::filesystem::path& file, const CsvTable& table, CaseProblems& problems);
  ~TableChecker();
  TableChecker(const TableChecker&) = delete;
  TableChecker& operator=(const TableChecker&) = delete;

  /// Reports a problem of row k unless `good`. @return good
  bool expect(bool good, std::size_t k, std::string_view message);
  /// Reports a problem of a line, whose message may quote it. @param cause  the same for all lines that have it
  void bad(int line, std::string_view cause, std::string_view message);
  void expect_rows(std::size_t minimum);
  void expect_rising(std::size_t column);

 private:
  struct RowProblem {
    int line;  ///< the first one with this cause
    std::string message;
    std::size_t more;  ///< rows
  };

  const std::filesystem::path& file_;
  const CsvTable& table_;
  CaseProblems& problems_;
  std::vector<RowProblem> found_;
  std::map<std::string, std::size_t, std::less<>> by_cause_;  ///< index in found_
};

}  // namespace gyro

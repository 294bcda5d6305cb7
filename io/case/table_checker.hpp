// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/case/csv.hpp"
#include "io/case/parts.hpp"

#include <filesystem>
#include <string>
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
  bool expect(bool good, std::size_t k, const std::string& message);
  void expect_rows(std::size_t minimum);
  void expect_rising(std::size_t column);

 private:
  struct RowProblem {
    int line;
    std::string message;
    std::size_t more;  ///< rows with the same
  };

  const std::filesystem::path& file_;
  const CsvTable& table_;
  CaseProblems& problems_;
  std::vector<RowProblem> found_;
};

}  // namespace gyro

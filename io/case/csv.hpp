// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// A problem of a table, at a line and column of its file, both from 1.
struct CsvProblem {
  int line = 1, column = 1;
  std::string message;
};

/// A table of finite numbers with a header row.
struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;            ///< for each row, its line in the file
  std::vector<CsvProblem> problems;  ///< at most 20; use the table only if there are none

  /// Column of a name; -1 if the table has none.
  int column(std::string_view name) const;
};

/// " (3 more rows like this)", behind a problem that many rows have; empty for none.
std::string rows_like_this(std::size_t more);

/// Reads a table in the forms in which spreadsheets write it. The header decides whether commas, semicolons or tabs
/// separate the cells. Quotes, decimal points, a byte-order mark and any line ends are read; decimal commas are read if
/// they are unambiguous: "1,500" is refused unless another cell, such as 2,5 or 0,125, shows that the commas of the
/// file are decimal; so is "1.500" beside whole numbers below 1000, in a file of semicolons or tabs that has no other
/// decimal points. Where all numbers of a column are like 1.500, the points are decimal. Lines that begin with #, empty
/// rows and empty columns after the last are skipped. A cause that many rows share is reported as one problem.
/// @param header  required columns, in this order
/// @param groups  optional columns that may follow in this order; each group must be complete or absent
CsvTable read_csv(const std::filesystem::path& file, const std::vector<std::string>& header,
                  const std::vector<std::vector<std::string>>& groups = {});

}  // namespace gyro

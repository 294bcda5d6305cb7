// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/table_checker.hpp"

#include <algorithm>

namespace gyro {

TableChecker::TableChecker(const std::filesystem::path& file, const CsvTable& table, CaseProblems& problems)
    : file_(file), table_(table), problems_(problems) {
  for (const CsvProblem& problem : table.problems)
    problems.add_in_file(file, problem.line, problem.column, problem.message);
}

TableChecker::~TableChecker() {
  for (const RowProblem& found : found_)
    problems_.add_in_file(file_, found.line, 1, found.message + rows_like_this(found.more));
}

bool TableChecker::expect(bool good, std::size_t k, const std::string& message) {
  if (good) return true;
  const auto known = std::ranges::find(found_, message, &RowProblem::message);
  if (known != found_.end())
    ++known->more;
  else
    found_.push_back({table_.lines.at(k), message, 0});
  return false;
}

void TableChecker::expect_rows(std::size_t minimum) {
  if (table_.rows.size() < minimum)
    problems_.add_in_file(
        file_, 1, 1,
        "the table has " + std::to_string(table_.rows.size()) + " rows; it needs at least " + std::to_string(minimum));
}

void TableChecker::expect_rising(std::size_t column) {
  for (std::size_t k = 1; k < table_.rows.size(); ++k)
    expect(table_.rows[k][column] > table_.rows[k - 1][column], k,
           table_.header[column] + " does not rise; each row must be larger than the one before");
}

}  // namespace gyro

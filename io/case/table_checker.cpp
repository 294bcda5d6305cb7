// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/table_checker.hpp"

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

bool TableChecker::expect(bool good, std::size_t k, std::string_view message) {
  if (!good) bad(table_.lines.at(k), message, message);
  return good;
}

void TableChecker::bad(int line, std::string_view cause, std::string_view message) {
  const auto known = by_cause_.find(cause);
  if (known == by_cause_.end()) {
    by_cause_.emplace(cause, found_.size());
    found_.push_back({line, std::string(message), 0});
    return;
  }
  RowProblem& problem = found_[known->second];
  ++problem.more;
  if (line < problem.line) problem.line = line, problem.message = message;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/csv.hpp"

#include "io/files/read_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace gyro {
namespace {

constexpr std::size_t max_problems = 20;

/// A cell without the blanks around it, and the column of the file where it begins.
struct Cell {
  std::string_view text;
  int column;
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin, last = end;
    while (first < last && (line[first] == ' ' || line[first] == '\t')) ++first;
    while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) --last;
    cells.push_back({line.substr(first, last - first), static_cast<int>(first) + 1});
    begin = end + 1;
  }
  return cells;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

class CsvReader {
 public:
  CsvReader(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& groups)
      : wanted_(header), groups_(groups) {}

  CsvTable read(std::istream& stream) {
    std::string line;
    for (int number = 1; std::getline(stream, line) && table_.problems.size() < max_problems; ++number) {
      if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
      if (line.ends_with('\r')) line.pop_back();
      if (line.find_first_not_of(" \t") == std::string::npos || line[0] == '#') continue;
      if (table_.header.empty()) {
        if (!read_header(line, number)) return table_;
      } else {
        read_row(line, number);
      }
    }
    if (table_.header.empty()) problem(1, 1, "the table is empty; it must begin with the header row " + expected());
    return table_;
  }

 private:
  void problem(int line, int column, std::string message) {
    if (table_.problems.size() < max_problems) table_.problems.push_back({line, column, std::move(message)});
  }
  std::string expected() const {
    std::string text = joined(wanted_);
    for (const auto& group : groups_) text += "[," + joined(group) + "]";
    return text;
  }
  bool read_header(const std::string& line, int number) {
    std::vector<std::string> names;
    for (const Cell& cell : cells_of(line)) names.emplace_back(cell.text);
    std::vector<std::string> rest = names;
    const auto take = [&](const std::vector<std::string>& group) {
      if (rest.size() < group.size() || !std::equal(group.begin(), group.end(), rest.begin())) return false;
      rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(group.size()));
      return true;
    };
    bool good = take(wanted_);
    for (const auto& group : groups_)
      if (good) take(group);
    good = good && rest.empty();
    if (!good) problem(number, 1, "the header row is \"" + line.substr(0, 120) + "\"; it must be " + expected());
    table_.header = std::move(names);
    return good;
  }
  void read_row(const std::string& line, int number) {
    const std::vector<Cell> cells = cells_of(line);
    if (cells.size() != table_.header.size())
      return problem(number, 1,
                     "the row has " + std::to_string(cells.size()) + " cells; it must have " +
                         std::to_string(table_.header.size()) + ", as the header");
    std::vector<double> row;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::string_view text = cells[k].text;
      double value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        problem(number, cells[k].column,
                "\"" + std::string(text.substr(0, 40)) + "\" is not a value of " + table_.header[k] +
                    "; give a finite number");
      row.push_back(value);
    }
    table_.rows.push_back(std::move(row));
    table_.lines.push_back(number);
  }

  const std::vector<std::string>& wanted_;
  const std::vector<std::vector<std::string>>& groups_;
  CsvTable table_;
};

}  // namespace

int CsvTable::column(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() ? -1 : static_cast<int>(found - header.begin());
}

CsvTable read_csv(const std::filesystem::path& file, const std::vector<std::string>& header,
                  const std::vector<std::vector<std::string>>& groups) {
  try {
    std::istringstream stream(read_file(file));
    return CsvReader(header, groups).read(stream);
  } catch (const UnreadableFile& unreadable) {
    CsvTable table;
    table.problems.push_back({1, 1, unreadable.problem});
    return table;
  }
}

}  // namespace gyro

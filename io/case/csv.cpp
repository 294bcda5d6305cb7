// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/csv.hpp"

#include "core/base/encoding.hpp"
#include "io/files/read_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

namespace gyro {
namespace {

constexpr std::size_t max_problems = 20;

/// The text of a cell without quotes and surrounding blanks, and the column of the file where it begins.
struct Cell {
  std::string text;
  int column;
};

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Divides a line at the separators outside of quotes.
std::vector<Cell> cells_of(std::string_view line, char separator) {
  std::vector<Cell> cells;
  bool quoted = false;
  for (std::size_t begin = 0, end = 0; begin <= line.size(); begin = ++end) {
    for (; end < line.size() && (quoted || line[end] != separator); ++end) quoted ^= line[end] == '"';
    std::size_t first = begin, last = std::min(end, line.size());
    while (first < last && is_blank(line[first])) ++first;
    while (last > first && is_blank(line[last - 1])) --last;
    std::string_view text = line.substr(first, last - first);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    cells.push_back({std::string(text), static_cast<int>(first) + 1});
  }
  return cells;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

/// Removes the next line from a text. @return the line, without its end: \n, \r\n or \r
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const std::size_t length = text.substr(end).starts_with("\r\n") ? 2 : 1;
  text.remove_prefix(std::min(end + length, text.size()));
  return line;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether the sign in a number may be a thousands separator: in "1,500", but not in "0,500", "1,50" or "1500,125".
bool may_be_thousands(std::string_view number, char sign) {
  if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
  const std::size_t at = number.find(sign);
  if (at < 1 || at > 3 || number.size() != at + 4 || number[0] == '0') return false;
  return std::ranges::all_of(number.substr(0, at), is_digit) && std::ranges::all_of(number.substr(at + 1), is_digit);
}

/// A whole number that needs no sign between thousands.
bool is_below_thousand(std::string_view number) {
  return !number.empty() && number.size() <= 3 && number[0] != '0' && std::ranges::all_of(number, is_digit);
}

/// Whether digits have other signs between them than points and commas: 1'500, 1 500 (also with a no-break space).
bool has_other_signs(std::string_view number) {
  const std::size_t first = number.find_first_not_of("0123456789");
  if (first == 0 || first == std::string_view::npos || !is_digit(number.back())) return false;
  for (const std::string_view sign : {"'", " ", "_", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"})
    if (number.substr(first).starts_with(sign)) return true;
  return false;
}

/// The separator of the cells. Spreadsheets use semicolons where the decimal sign is a comma.
char separator_of(std::string_view header) {
  for (const char separator : {';', '\t'})
    if (header.find(separator) != std::string_view::npos) return separator;
  return ',';
}

class CsvReader {
 public:
  CsvReader(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& groups)
      : wanted_(header), groups_(groups) {}

  CsvTable read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (is_utf16(text) || text.substr(0, 200).find('\0') != std::string_view::npos) {
      problem(1, 1, is_utf16(text) ? utf16_problem : "is not a text in UTF-8; export the table as CSV in UTF-8");
      return std::move(table_);
    }
    for (int number = 1; !text.empty() && !mixed_; ++number) {
      const std::string_view line = next_line(text);
      if (line.starts_with("sep=") && line.size() == 5 && table_.header.empty()) continue;  // written by Excel
      if (line.find_first_not_of(" \t,;\"") == std::string_view::npos || line[0] == '#') continue;
      if (!table_.header.empty()) {
        read_row(line, number);
      } else if (!read_header(line, number)) {
        return std::move(table_);
      }
    }
    if (table_.header.empty()) problem(1, 1, "the table is empty; it must begin with the header row " + expected());
    if (!decimal_commas_ && !mixed_) refuse_thousands(unclear_);
    if (!decimal_points_ && !mixed_ && separator_ != ',') refuse_pointed_thousands();
    finish_problems();
    return std::move(table_);
  }

 private:
  void problem(int line, int column, std::string message) {
    if (table_.problems.size() < max_problems) table_.problems.push_back({line, column, std::move(message)});
  }
  /// Adds a problem that may have the same cause in many rows. Only its first place is reported; further rows are
  /// counted.
  void row_problem(const std::string& cause, int line, int column, std::string message) {
    if (const auto known = more_.find(cause); known != more_.end()) {
      ++known->second.rows;
    } else if (table_.problems.size() < max_problems) {
      more_[cause] = {table_.problems.size(), 0};
      problem(line, column, std::move(message));
    }
  }
  /// In a file of a decimal comma, "1.500" beside 500 is 1500; of three decimals, all numbers of a column would have a
  /// point.
  void refuse_pointed_thousands() {
    for (const Pointed& column : pointed_)
      if (column.has_whole) refuse_thousands(column.unclear);
  }
  /// Reports cells such as "1,500" in a file in which no other cell shows what its signs mean.
  void refuse_thousands(const std::vector<std::pair<int, Cell>>& unclear) {
    for (const auto& [line, cell] : unclear)
      row_problem("thousands", line, cell.column,
                  "\"" + cell.text.substr(0, 40) +
                      "\" has a sign that may mean thousands or decimals; write thousands without a separator, and "
                      "decimals with a point");
  }
  void finish_problems() {
    for (const auto& [cause, again] : more_) table_.problems[again.problem].message += rows_like_this(again.rows);
  }
  std::string expected() const {
    std::string text = joined(wanted_);
    for (const auto& group : groups_) text += "[," + joined(group) + "]";
    return text;
  }
  bool read_header(std::string_view line, int number) {
    separator_ = separator_of(line);
    std::vector<std::string> names;
    for (const Cell& cell : cells_of(line, separator_)) names.push_back(cell.text);
    while (!names.empty() && names.back().empty()) names.pop_back();  // empty columns of a spreadsheet
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
    if (!good)
      problem(number, 1, "the header row is \"" + std::string(line.substr(0, 120)) + "\"; it must be " + expected());
    table_.header = std::move(names);
    return good;
  }
  void read_row(std::string_view line, int number) {
    std::vector<Cell> cells = cells_of(line, separator_);
    while (cells.size() > table_.header.size() && cells.back().text.empty()) cells.pop_back();
    if (cells.size() != table_.header.size()) {
      const bool commas = separator_ == ',' && cells.size() > table_.header.size();
      return row_problem("cells", number, 1,
                         "the row has " + std::to_string(cells.size()) + " cells; it must have " +
                             std::to_string(table_.header.size()) + ", as the header" +
                             (commas ? " (decimal commas need semicolons between the cells: export as CSV with "
                                       "semicolons, or with decimal points)"
                                     : ""));
    }
    std::vector<double> row;
    for (std::size_t k = 0; k < cells.size(); ++k) row.push_back(number_of(cells[k], k, number));
    table_.rows.push_back(std::move(row));
    table_.lines.push_back(number);
  }
  double number_of(const Cell& cell, std::size_t column, int line) {
    std::string text = cell.text;
    const auto commas = std::count(text.begin(), text.end(), ','), points = std::count(text.begin(), text.end(), '.');
    if (commas == 1 && points == 0) text[text.find(',')] = '.';
    if (text.starts_with('+')) text.erase(0, 1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
      row_problem("value " + std::to_string(column), line, cell.column,
                  "\"" + cell.text.substr(0, 40) + "\" is not a value of " + table_.header[column] +
                      "; give a finite number" +
                      (commas + points > 1 || has_other_signs(cell.text) ? ", without thousands separators" : ""));
      return value;
    }
    if (commas > 0 || points > 0) expect_same_sign(commas > 0, cell, line);
    if (commas > 0 && may_be_thousands(cell.text, ',')) {
      unclear_.emplace_back(line, cell);
    } else if (commas > 0) {
      decimal_commas_ = true;
    }
    note_points(cell, column, line);
    return value;
  }
  void note_points(const Cell& cell, std::size_t column, int line) {
    pointed_.resize(table_.header.size());
    if (may_be_thousands(cell.text, '.')) {
      pointed_[column].unclear.emplace_back(line, cell);
    } else if (cell.text.find('.') != std::string::npos) {
      decimal_points_ = true;
    }
    pointed_[column].has_whole |= is_below_thousand(cell.text);
  }
  /// Reports a file that has both decimal points and decimal commas: in it, 1,500 could be 1500.
  void expect_same_sign(bool comma, const Cell& cell, int line) {
    if (sign_ == 0) sign_ = comma ? ',' : '.';
    if ((sign_ == ',') == comma) return;
    mixed_ = true;
    problem(line, cell.column,
            "\"" + cell.text.substr(0, 40) +
                "\" has a different decimal sign from the cells before; use either points or commas, " +
                "and no thousands separators");
  }

  struct Again {
    std::size_t problem, rows;
  };
  /// The points of a column.
  struct Pointed {
    std::vector<std::pair<int, Cell>> unclear;  ///< lines and cells such as "1.500"
    bool has_whole = false;                     ///< a cell such as "500"
  };
  const std::vector<std::string>& wanted_;
  const std::vector<std::vector<std::string>>& groups_;
  CsvTable table_;
  std::map<std::string, Again> more_;  ///< by cause
  char separator_ = ',', sign_ = 0;
  bool mixed_ = false;
  bool decimal_commas_ = false;                ///< a cell has a comma that can only be a decimal sign
  bool decimal_points_ = false;                ///< the same for points
  std::vector<std::pair<int, Cell>> unclear_;  ///< lines and cells such as "1,500"
  std::vector<Pointed> pointed_;               ///< by column
};

}  // namespace

std::string rows_like_this(std::size_t more) {
  if (more == 0) return {};
  return " (" + std::to_string(more) + (more > 1 ? " more rows" : " more row") + " like this)";
}

int CsvTable::column(std::string_view name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() ? -1 : static_cast<int>(found - header.begin());
}

CsvTable read_csv(const std::filesystem::path& file, const std::vector<std::string>& header,
                  const std::vector<std::vector<std::string>>& groups) {
  try {
    return CsvReader(header, groups).read(read_file(file));
  } catch (const UnreadableFile& unreadable) {
    CsvTable table;
    table.problems.push_back({1, 1, unreadable.problem});
    return table;
  }
}

}  // namespace gyro

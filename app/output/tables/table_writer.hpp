// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/tables/column.hpp"
#include "core/base/errors.hpp"
#include "io/run/results.hpp"

#include <utility>

namespace gyro {

/// Writes a table of one run. The header and all rows are made from the same columns: those that this run has.
template <class Now, class Window = NoWindow>
class TableWriter {
 public:
  /// Sums for the row that is not complete yet, for a checkpoint.
  struct State {
    double length = 0;         ///< of the windows since the last row [s]
    std::vector<double> sums;  ///< of value x window length since the last row, by number of the means

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("length", s.length...);
      f("sums", s.sums...);
    }
  };

  /// @param array  numbers of the table's arrays
  /// @param group  path in results.h5, such as "/liners/mantle"; empty: that of the table
  TableWriter(const Table<Now, Window>& table, const OutputForm& form, std::size_t array = 0, std::string group = {}) {
    declaration_.name = group.empty() ? std::string(table.group) : std::move(group);
    std::size_t means = 0;
    for (const Column<Now, Window>& column : table.columns) {
      if (!column.presence.holds(form)) continue;
      std::size_t width = 0;
      for (Channel& channel : channels_of(column, form, array)) {
        width += static_cast<std::size_t>(channel.columns);
        declaration_.channels.push_back(std::move(channel));
      }
      if (column.value.is_mean()) means += width;
      columns_.push_back({column.value, width});
    }
    state_.sums.assign(means, 0.0);
  }

  /// Its group in results.h5.
  const ResultsGroup& declaration() const { return declaration_; }
  double length() const { return state_.length; }  ///< of the windows since the last row [s]

  /// Adds a window to the means of the next row.
  void add(const Window& window) {
    std::vector<double> values;
    for (const Placed& column : columns_)
      if (column.value.is_mean()) column.value.put(window, values);
    for (std::size_t k = 0; k < values.size(); ++k) state_.sums.at(k) += values[k] * window.length;
    state_.length += window.length;
  }

  /// Writes a row; the means are those since the last one.
  void append(ResultsFile& file, const Now& now) {
    std::vector<double> row;
    std::size_t mean = 0;
    for (const Placed& column : columns_) {
      if (!column.value.is_mean()) column.value.put(now, row);
      for (std::size_t k = 0; column.value.is_mean() && k < column.width; ++k)
        row.push_back(state_.sums.at(mean++) / state_.length);
    }
    file.append(declaration_.name, row);
    state_ = {0, std::vector<double>(state_.sums.size(), 0.0)};
  }

  const State& state() const { return state_; }
  /// @throws BadInput for the state of a run with other means
  void restore(State state) {
    if (state.sums.size() != state_.sums.size())
      throw BadInput("has " + std::to_string(state.sums.size()) + " sums of " + declaration_.name + ", not " +
                     std::to_string(state_.sums.size()));
    state_ = std::move(state);
  }

 private:
  struct Placed {
    Value<Now, Window> value;
    std::size_t width;  ///< numbers in a row
  };

  ResultsGroup declaration_;
  std::vector<Placed> columns_;
  State state_;
};

/// The datasets of a table of arrays that are written once.
template <class Now>
std::vector<FixedNumbers> fixed_numbers(const Table<Now>& table, const OutputForm& form, const Now& now,
                                        const std::string& group) {
  std::vector<FixedNumbers> all;
  for (const Column<Now>& column : table.columns) {
    if (!column.presence.holds(form)) continue;
    FixedNumbers fixed{group + "/" + std::string(column.name), channels_of(column, form, 1).front(), {}};
    column.value.put(now, fixed.numbers);
    all.push_back(std::move(fixed));
  }
  return all;
}

}  // namespace gyro

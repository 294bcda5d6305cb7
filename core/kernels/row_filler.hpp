// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

namespace gyro {

/// Fills rows of different lengths in two runs of the same kernel: the first counts what each row will hold, an
/// exclusive scan turns the counts into the begin of each row, the second run writes the entries.
template <class Entry>
struct RowFiller {
  Index* counts;   ///< counting run: entries of each row; filling run: first entry of each row
  Entry* entries;  ///< null in the counting run

  /// @param found  entries of this row so far
  GYRO_HD void add(Index row, Index& found, const Entry& entry) const {
    if (entries != nullptr) entries[counts[row] + found] = entry;
    ++found;
  }
  /// Whether the filling run has all entries of a row that the counting run has found.
  GYRO_HD bool is_full(Index row, Index found) const {
    return entries != nullptr && counts[row] + found == counts[row + 1];
  }
  GYRO_HD void end_row(Index row, Index found) const {
    if (entries == nullptr) counts[row] = found;
  }
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/base/hd.hpp"

#include <cstdint>
#include <vector>

// What the two neighbour lists have in common.

namespace gyro {

/// The rows whose flag is set.
template <class T>
std::vector<T> where(const std::vector<std::int8_t>& set, const std::vector<T>& rows) {
  GYRO_EXPECT(set.size() == rows.size());
  std::vector<T> found;
  for (std::size_t n = 0; n < rows.size(); ++n)
    if (set[n]) found.push_back(rows[n]);
  return found;
}

/// Lengthens the begins of rows to one a particle and one past the end; the new rows are empty.
/// @param end  of the last row
template <class Exec>
void extend_rows(typename Exec::template Buffer<Index>& row_begin, Index particles, std::size_t end) {
  const auto rows = static_cast<std::size_t>(particles) + 1;
  if (row_begin.size() < rows)
    Exec::append(row_begin, std::vector<Index>(rows - row_begin.size(), static_cast<Index>(end)));
}

}  // namespace gyro

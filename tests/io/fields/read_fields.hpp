// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fields/field_frame.hpp"

#include <string>
#include <vector>

namespace gyro {

inline std::vector<double> numbers_of(const hdf5::File& file, const FieldRows& rows) {
  return rows.rows == 0 ? std::vector<double>() : file.dataset(rows.dataset).read_rows(rows.first, rows.rows);
}

/// All numbers of a frame: its time, points, cells and fields.
inline std::vector<double> numbers_of(const hdf5::File& file, const std::string& group, std::int64_t number) {
  const FieldFrame frame = read_frame(file, group, number);
  std::vector<double> all{frame.time};
  std::vector<FieldRows> parts{frame.points, frame.connectivity};
  parts.insert(parts.end(), frame.point_fields.begin(), frame.point_fields.end());
  parts.insert(parts.end(), frame.cell_fields.begin(), frame.cell_fields.end());
  for (const FieldRows& rows : parts) {
    const std::vector<double> numbers = numbers_of(file, rows);
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
  return all;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fields/field_frame.hpp"

#include <string>
#include <vector>

namespace gyro {

inline std::vector<double> numbers_of(const hdf5::File& file, const FieldRows& rows) {
  return rows.rows == 0 ? std::vector<double>() : file.dataset(rows.dataset).read_rows(rows.first, rows.rows);
}

/// Where the cells of a frame begin, of all kinds of cells.
inline std::vector<double> cell_begins(const hdf5::File& file, const std::string& group, std::int64_t frame) {
  const std::vector<double> offsets = file.dataset(group + "/Steps/CellOffsets").read_rows(frame, 1);
  std::vector<double> all;
  std::size_t kind = 0;
  for (const char* name : {"/Vertices", "/Lines", "/Polygons", "/Strips"}) {
    const double cells = file.dataset(group + name + "/NumberOfCells").read_rows(frame, 1)[0];
    const std::vector<double> begins =
        file.dataset(group + name + "/Offsets")
            .read_rows(static_cast<std::int64_t>(offsets[kind++]) + frame, static_cast<std::int64_t>(cells) + 1);
    all.insert(all.end(), begins.begin(), begins.end());
  }
  return all;
}

/// All numbers of a frame: its time, points, cells and fields.
inline std::vector<double> numbers_of(const hdf5::File& file, const std::string& group, std::int64_t number) {
  const FieldFrame frame = read_frame(file, group, number);
  std::vector<double> all = cell_begins(file, group, number);
  all.push_back(frame.time);
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

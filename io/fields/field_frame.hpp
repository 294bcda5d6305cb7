// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/hdf5/hdf5.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace gyro {

/// The rows of a dataset that belong to a frame.
struct FieldRows {
  std::string dataset;  ///< path in fields.h5
  hdf5::Number number = hdf5::Number::int32;
  std::int64_t columns = 1;
  std::int64_t first = 0, rows = 0;
  std::int64_t rows_of_all = 0;  ///< of the dataset

  std::string name() const { return dataset.substr(dataset.rfind('/') + 1); }
};

enum class CellKind { vertices, lines, triangles };

/// Where the numbers of one frame of a group lie in fields.h5.
struct FieldFrame {
  double time = 0;  ///< [s]
  CellKind kind = CellKind::vertices;
  std::int64_t cells = 0;
  FieldRows points, connectivity;
  std::vector<FieldRows> point_fields, cell_fields;
};

/// Frames of a group that count.
std::int64_t frame_count(const hdf5::File& file, const std::string& group);
/// @param group  as FieldGroup writes it, with one kind of cells; without cells the kind is unknown, and vertices
FieldFrame read_frame(const hdf5::File& file, const std::string& group, std::int64_t frame);

}  // namespace gyro

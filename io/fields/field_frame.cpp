// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields/field_frame.hpp"

#include <array>

namespace gyro {
namespace {

/// Numbers of a frame in one of the small datasets.
std::vector<double> row_of(const hdf5::File& file, const std::string& dataset, std::int64_t frame) {
  return file.dataset(dataset).read_rows(frame, 1);
}

std::int64_t count_of(const hdf5::File& file, const std::string& dataset, std::int64_t frame) {
  return static_cast<std::int64_t>(row_of(file, dataset, frame)[0]);
}

FieldRows rows_of(const hdf5::File& file, const std::string& name, std::int64_t first, std::int64_t rows) {
  const hdf5::Dataset dataset = file.dataset(name);
  return {name, dataset.number(), dataset.columns(), first, rows, dataset.rows()};
}

std::vector<FieldRows> fields_of(const hdf5::File& file, const std::string& group, const std::string& of,
                                 std::int64_t frame, std::int64_t rows) {
  std::vector<FieldRows> fields;
  for (const std::string& name : file.children(group + "/" + of + "Data")) {
    const std::int64_t first = count_of(file, group + "/Steps/" + of + "DataOffsets/" + name, frame);
    fields.push_back(rows_of(file, group + "/" + of + "Data/" + name, first, rows));
  }
  return fields;
}

}  // namespace

std::int64_t frame_count(const hdf5::File& file, const std::string& group) {
  return static_cast<std::int64_t>(file.integer_attribute(group + "/Steps", "NSteps"));
}

FieldFrame read_frame(const hdf5::File& file, const std::string& group, std::int64_t frame) {
  constexpr std::array kinds{"/Vertices", "/Lines", "/Polygons"};
  FieldFrame read;
  read.time = row_of(file, group + "/Steps/Values", frame)[0];
  const std::int64_t points = count_of(file, group + "/NumberOfPoints", frame);
  read.points = rows_of(file, group + "/Points", count_of(file, group + "/Steps/PointOffsets", frame), points);
  const std::vector<double> first_id = row_of(file, group + "/Steps/ConnectivityIdOffsets", frame);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const std::int64_t cells = count_of(file, group + kinds[kind] + "/NumberOfCells", frame);
    if (cells == 0) continue;
    read.kind = static_cast<CellKind>(kind);
    read.cells = cells;
    read.connectivity = rows_of(file, group + kinds[kind] + "/Connectivity", static_cast<std::int64_t>(first_id[kind]),
                                count_of(file, group + kinds[kind] + "/NumberOfConnectivityIds", frame));
  }
  read.point_fields = fields_of(file, group, "Point", frame, points);
  read.cell_fields = fields_of(file, group, "Cell", frame, read.cells);
  return read;
}

}  // namespace gyro

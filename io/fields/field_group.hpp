// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/fields/field_column.hpp"
#include "io/run/poly_data.hpp"
#include "io/run/snapshots.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace gyro {

/// A group of fields.h5: points, lines or triangles over time, in the form of VTKHDF 2.0 (VTK File Formats,
/// docs.vtk.org: PolyData with Steps). Positions, cells and fields of all frames stand one after the other; /Steps has
/// the time of each frame and where its rows begin, in datasets and in number:
///
///   NumberOfPoints[k], Steps/PointOffsets[k]       points of frame k, and the first of them in Points
///   {Vertices,Lines,Polygons}/NumberOfCells[k]     cells; Offsets has one number more for each frame
///   Steps/{Point,Cell}DataOffsets/NAME[k]          first row in {Point,Cell}Data/NAME
///
/// Frames are counted by the attribute NSteps, which is changed last.
class FieldGroup {
 public:
  /// Creates an empty group. @param like  data of the form that all frames have: fields and their numbers
  static void create(hdf5::File& file, const std::string& name, const PolyData& like,
                     const std::vector<SnapshotField>& fields);
  /// @param frame_count  frames of the group so far
  FieldGroup(std::string name, const PolyData& like, std::int64_t frame_count);

  /// Writes a frame that does not count yet. @param file  opened by append_to()
  void append(const hdf5::File& file, const PolyData& data);
  /// Makes it count. @param file  opened by change()
  void count(hdf5::File& file);

 private:
  struct Cells {
    FieldColumn connectivity, offsets;
  };
  void append_cells(const hdf5::File& file, const PolyData& data);
  void append_fields(const hdf5::File& file, std::vector<FieldColumn>& columns, const std::vector<PolyArray>& fields,
                     const std::string& offsets);
  void note(const hdf5::File& file, const std::string& dataset, std::span<const double> row) const;

  std::string name_;
  std::int64_t frames_;
  FieldColumn points_;
  std::vector<Cells> cells_;
  std::vector<FieldColumn> point_fields_, cell_fields_;
};

}  // namespace gyro

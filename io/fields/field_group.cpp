// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields/field_group.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace gyro {
namespace {

using hdf5::Number;

// Kinds of cells in the order of the columns of CellOffsets. Strips are never used, but VTK's reader asks for them.
constexpr std::array kinds{"Vertices", "Lines", "Polygons", "Strips"};
constexpr std::int64_t kind_count = kinds.size();
constexpr std::array<std::int64_t, 2> version{2, 0};  // of VTKHDF: the first with PolyData over time
constexpr hdf5::Layout count_layout{Number::int64, 1, 256};
constexpr hdf5::Layout kinds_layout{Number::int64, kind_count, 256};

std::array<const PolyCells*, kinds.size()> cells_of(const PolyData& data) {
  static const PolyCells no_strips;
  return {&data.vertices, &data.lines, &data.triangles, &no_strips};
}

Number number_of(const PolyArray& array) {
  return std::visit(
      [](const auto& values) { return hdf5::number_of<typename std::decay_t<decltype(values)>::value_type>(); },
      array.values);
}

std::size_t rows_of(const PolyArray& array) {
  return std::visit([&](const auto& values) { return values.size() / static_cast<std::size_t>(array.components); },
                    array.values);
}

/// Units and meaning of a field, where the table of fields has it.
void describe(hdf5::File& file, const std::string& dataset, const std::string& field,
              const std::vector<SnapshotField>& fields) {
  const auto known = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == field; });
  if (known == fields.end()) return;
  file.set_attribute(dataset, "units", known->units);
  file.set_attribute(dataset, "description", known->description);
}

void create_fields(hdf5::File& file, const std::string& group, const std::string& of,
                   const std::vector<PolyArray>& arrays, const std::vector<SnapshotField>& fields) {
  file.create_group(group + "/" + of + "Data");
  file.create_group(group + "/Steps/" + of + "DataOffsets");
  for (const PolyArray& array : arrays) {
    const std::string dataset = group + "/" + of + "Data/" + array.name;
    FieldColumn::create(file, dataset, number_of(array), array.components, rows_of(array));
    describe(file, dataset, array.name, fields);
    file.create_dataset(group + "/Steps/" + of + "DataOffsets/" + array.name, count_layout);
  }
}

void create_steps(hdf5::File& file, const std::string& steps) {
  file.create_group(steps);
  file.set_integer(steps, "NSteps", 0);
  file.create_dataset(steps + "/Values", {Number::float64, 1, 256});
  for (const char* counts : {"PartOffsets", "NumberOfParts", "PointOffsets"})
    file.create_dataset(steps + "/" + counts, count_layout);
  for (const char* counts : {"CellOffsets", "ConnectivityIdOffsets"})
    file.create_dataset(steps + "/" + counts, kinds_layout);
}

}  // namespace

void FieldGroup::create(hdf5::File& file, const std::string& name, const PolyData& like,
                        const std::vector<SnapshotField>& fields) {
  file.create_group(name);
  file.set_attribute(name, "Version", version);
  file.set_fixed_text(name, "Type", "PolyData");
  file.create_dataset(name + "/NumberOfPoints", count_layout);
  FieldColumn::create(file, name + "/Points", Number::float32, 3, like.positions.size() / 3);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const std::string group = name + "/" + kinds[kind];
    const PolyCells& cells = *cells_of(like)[kind];
    file.create_dataset(group + "/NumberOfCells", count_layout);
    file.create_dataset(group + "/NumberOfConnectivityIds", count_layout);
    FieldColumn::create(file, group + "/Offsets", Number::int32, 1, cells.ends.size());
    FieldColumn::create(file, group + "/Connectivity", Number::int32, 1, cells.points.size());
  }
  create_steps(file, name + "/Steps");
  create_fields(file, name, "Point", like.point_fields, fields);
  create_fields(file, name, "Cell", like.cell_fields, fields);
}

FieldGroup::FieldGroup(std::string name, const PolyData& like, std::int64_t frame_count)
    : name_(std::move(name)), frames_(frame_count), points_(name_ + "/Points") {
  for (const char* kind : kinds)
    cells_.push_back({FieldColumn(name_ + "/" + kind + "/Connectivity"), FieldColumn(name_ + "/" + kind + "/Offsets")});
  for (const PolyArray& field : like.point_fields) point_fields_.emplace_back(name_ + "/PointData/" + field.name);
  for (const PolyArray& field : like.cell_fields) cell_fields_.emplace_back(name_ + "/CellData/" + field.name);
}

/// Writes numbers of the frame that is being appended.
void FieldGroup::note(const hdf5::File& file, const std::string& dataset, std::span<const double> row) const {
  file.dataset(name_ + "/" + dataset).write_row(frames_, row);
}

void FieldGroup::append(const hdf5::File& file, const PolyData& data) {
  const auto note_one = [&](const std::string& dataset, std::int64_t number) {
    const auto value = static_cast<double>(number);
    note(file, dataset, {&value, 1});
  };
  note_one("NumberOfPoints", static_cast<std::int64_t>(data.positions.size() / 3));
  note_one("Steps/PartOffsets", frames_);  // every frame has one part
  note_one("Steps/NumberOfParts", 1);
  note_one("Steps/PointOffsets", points_.store(file, data.positions));
  append_cells(file, data);
  append_fields(file, point_fields_, data.point_fields, "Steps/PointDataOffsets/");
  append_fields(file, cell_fields_, data.cell_fields, "Steps/CellDataOffsets/");
  const double time = data.time.value_or(0);
  note(file, "Steps/Values", {&time, 1});
}

void FieldGroup::append_cells(const hdf5::File& file, const PolyData& data) {
  std::array<double, kinds.size()> first_cell{}, first_id{};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const PolyCells& cells = *cells_of(data)[kind];
    const std::array counts{static_cast<double>(cells.ends.size()), static_cast<double>(cells.points.size())};
    note(file, std::string(kinds[kind]) + "/NumberOfCells", {&counts[0], 1});
    note(file, std::string(kinds[kind]) + "/NumberOfConnectivityIds", {&counts[1], 1});
    std::vector<std::int32_t> offsets{0};
    offsets.insert(offsets.end(), cells.ends.begin(), cells.ends.end());
    // The reader finds the offsets of frame k behind k further numbers, one for each frame before.
    first_cell[kind] = static_cast<double>(cells_[kind].offsets.append(file, offsets) - frames_);
    first_id[kind] = static_cast<double>(cells_[kind].connectivity.store(file, cells.points));
  }
  note(file, "Steps/CellOffsets", first_cell);
  note(file, "Steps/ConnectivityIdOffsets", first_id);
}

void FieldGroup::append_fields(const hdf5::File& file, std::vector<FieldColumn>& columns,
                               const std::vector<PolyArray>& fields, const std::string& offsets) {
  for (std::size_t f = 0; f < columns.size(); ++f) {
    const auto first = static_cast<double>(
        std::visit([&](const auto& values) { return columns[f].store(file, values); }, fields[f].values));
    note(file, offsets + fields[f].name, {&first, 1});
  }
}

void FieldGroup::count(hdf5::File& file) {
  file.overwrite_integer(name_ + "/Steps", "NSteps", ++frames_);
}

}  // namespace gyro

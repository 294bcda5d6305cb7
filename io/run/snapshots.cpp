// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/snapshots.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeUInt32Array.h>
#include <vtkXMLPolyDataWriter.h>
#include <array>
#include <cstdio>
#include <string_view>

namespace gyro {
namespace {

/// A named column of `count` numbers; value(row) may return any number.
template <class Array, class Value>
vtkNew<Array> column(const char* name, std::size_t count, Value value) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(count));
  for (std::size_t row = 0; row < count; ++row)
    array->SetValue(static_cast<vtkIdType>(row), static_cast<typename Array::ValueType>(value(row)));
  return array;
}

void set_vector(vtkFloatArray* array, std::size_t row, const Vec3d& v) {
  const std::array<float, 3> tuple{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  array->SetTypedTuple(static_cast<vtkIdType>(row), tuple.data());
}

vtkNew<vtkFloatArray> vectors(const char* name, const std::vector<Vec3d>& values) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t row = 0; row < values.size(); ++row) set_vector(array, row, values[row]);
  return array;
}

void set_points(vtkPolyData* data, vtkFloatArray* positions) {
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  data->SetPoints(points);
}

/// Cells of `corners` points each, with 32-bit numbers.
template <class Corner>
vtkNew<vtkCellArray> cells_of(std::size_t count, int corners, Corner corner) {
  vtkNew<vtkCellArray> cells;
  cells->Use32BitStorage();
  cells->AllocateExact(static_cast<vtkIdType>(count), static_cast<vtkIdType>(count) * corners);
  for (std::size_t cell = 0; cell < count; ++cell) {
    cells->InsertNextCell(corners);
    for (int k = 0; k < corners; ++k) cells->InsertCellPoint(static_cast<vtkIdType>(corner(cell, k)));
  }
  return cells;
}

vtkNew<vtkPolyData> particle_data(const ParticleSnapshot& s) {
  vtkNew<vtkPolyData> data;
  set_points(data, vectors("position", s.position));
  // One cell holds all points: without a cell ParaView's surface view shows nothing.
  const auto count = static_cast<int>(s.size());
  data->SetVerts(cells_of(count > 0 ? 1 : 0, count, [](std::size_t, int k) { return k; }));
  vtkPointData* fields = data->GetPointData();
  fields->AddArray(column<vtkTypeUInt32Array>("id", s.size(), [&](std::size_t p) { return s.id[p]; }));
  fields->AddArray(column<vtkTypeInt32Array>("rock", s.size(), [&](std::size_t p) { return s.rock[p]; }));
  fields->AddArray(column<vtkTypeUInt32Array>(
      "fragment", s.size(), [&](std::size_t p) { return s.id[static_cast<std::size_t>(s.fragment[p])]; }));
  fields->AddArray(column<vtkFloatArray>("radius", s.size(), [&](std::size_t p) { return s.radius[p]; }));
  fields->AddArray(column<vtkFloatArray>("mass", s.size(), [&](std::size_t p) { return s.mass[p]; }));
  fields->AddArray(vectors("velocity", s.velocity));
  fields->AddArray(vectors("force", s.force));
  return data;
}

vtkNew<vtkPolyData> bond_data(const BondSnapshot& s, const ParticleSnapshot& particles) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkFloatArray> ends;
  ends->SetNumberOfComponents(3);
  ends->SetNumberOfTuples(static_cast<vtkIdType>(2 * s.size()));
  for (std::size_t b = 0; b < s.size(); ++b) {
    set_vector(ends, 2 * b, particles.position[static_cast<std::size_t>(s.i[b])]);
    set_vector(ends, 2 * b + 1, particles.position[static_cast<std::size_t>(s.j[b])]);
  }
  set_points(data, ends);
  data->SetLines(
      cells_of(s.size(), 2, [](std::size_t bond, int end) { return 2 * bond + static_cast<std::size_t>(end); }));
  data->GetPointData()->AddArray(
      column<vtkFloatArray>("radius", 2 * s.size(), [&](std::size_t end) { return s.radius[end / 2]; }));
  vtkCellData* fields = data->GetCellData();
  fields->AddArray(column<vtkFloatArray>("normal_force", s.size(), [&](std::size_t b) { return s.normal_force[b]; }));
  fields->AddArray(column<vtkFloatArray>("stress_ratio", s.size(), [&](std::size_t b) { return s.stress_ratio[b]; }));
  return data;
}

vtkNew<vtkPolyData> wall_data(std::span<const PosedWall> walls) {
  TriangleMesh all;
  std::vector<Index> wall_of_triangle;
  for (const PosedWall& wall : walls) {
    const auto first = static_cast<Index>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), wall.mesh.vertices.begin(), wall.mesh.vertices.end());
    for (const Vec3<Index>& t : wall.mesh.triangles) {
      all.triangles.push_back({t.x + first, t.y + first, t.z + first});
      wall_of_triangle.push_back(wall.wall);
    }
  }
  vtkNew<vtkPolyData> data;
  set_points(data, vectors("position", all.vertices));
  data->SetPolys(cells_of(all.triangles.size(), 3, [&](std::size_t t, int k) {
    const Vec3<Index>& triangle = all.triangles[t];
    return k == 0 ? triangle.x : k == 1 ? triangle.y : triangle.z;
  }));
  data->GetCellData()->AddArray(
      column<vtkTypeInt32Array>("wall", wall_of_triangle.size(), [&](std::size_t t) { return wall_of_triangle[t]; }));
  return data;
}

void write_data(const std::filesystem::path& path, vtkPolyData* data, double time) {
  vtkNew<vtkDoubleArray> stamp;
  stamp->SetName("TimeValue");
  stamp->InsertNextValue(time);
  data->GetFieldData()->AddArray(stamp);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  // Into memory, because VTK does not report every failed write to a file.
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw OutputError(path.string() + ": cannot write: VTK could not put the data together");
  replace_file(path, writer->GetOutputString());
}

std::string frame_file(const std::string& kind, std::size_t frame) {
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "_%06zu.vtp", frame);
  return "snapshots/" + kind + number.data();
}

}  // namespace

SnapshotWriter::SnapshotWriter(std::filesystem::path directory, std::vector<double> earlier)
    : directory_(std::move(directory)), times_(std::move(earlier)) {
  std::error_code error;
  std::filesystem::create_directories(directory_ / "snapshots", error);
  if (error) throw OutputError((directory_ / "snapshots").string() + ": cannot make it: " + error.message());
  drop_later_frames();
}

/// Frames that another run left behind: indices first, so that they never name a missing file.
void SnapshotWriter::drop_later_frames() const {
  const auto file = [this](const char* kind, std::size_t frame) { return directory_ / frame_file(kind, frame); };
  for (const char* kind : {"particles", "bonds", "walls"}) {
    if (!std::filesystem::exists(file(kind, times_.size()))) continue;
    write_index(kind);
    std::error_code error;
    for (std::size_t frame = times_.size(); std::filesystem::remove(file(kind, frame), error); ++frame) {
    }
    if (error) throw OutputError(file(kind, times_.size()).string() + ": cannot remove: " + error.message());
  }
}

void SnapshotWriter::write(const SnapshotFrame& frame) {
  const std::size_t number = times_.size();
  if (frame.particles)
    write_data(directory_ / frame_file("particles", number), particle_data(*frame.particles), frame.time);
  if (frame.bonds)
    write_data(directory_ / frame_file("bonds", number), bond_data(*frame.bonds, *frame.particles), frame.time);
  if (!frame.walls.empty()) write_data(directory_ / frame_file("walls", number), wall_data(frame.walls), frame.time);
  times_.push_back(frame.time);
  // The indices last: they never name a file that is not there.
  if (frame.particles) write_index("particles");
  if (frame.bonds) write_index("bonds");
  if (!frame.walls.empty()) write_index("walls");
}

void SnapshotWriter::write_index(const std::string& kind) const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (std::size_t frame = 0; frame < times_.size(); ++frame) {
    std::array<char, 32> time;
    std::snprintf(time.data(), time.size(), "%.12g", times_[frame]);
    text += "    <DataSet timestep=\"" + std::string(time.data()) + "\" part=\"0\" file=\"" + frame_file(kind, frame) +
            "\"/>\n";
  }
  replace_file(directory_ / (kind + ".pvd"), text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace gyro

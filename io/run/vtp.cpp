// SPDX-License-Identifier: GPL-3.0-or-later
// Writes snapshots with VTK's library.
#include "core/base/errors.hpp"
#include "io/run/poly_data.hpp"
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

#include <algorithm>

namespace gyro {
namespace {

vtkNew<vtkFloatArray> new_array(float) {
  return {};
}
vtkNew<vtkTypeInt32Array> new_array(std::int32_t) {
  return {};
}
vtkNew<vtkTypeUInt32Array> new_array(std::uint32_t) {
  return {};
}

/// A VTK array with a copy of the values.
template <class T>
auto array_of(const std::string& name, int components, const std::vector<T>& values) {
  auto array = new_array(T{});
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

void add(const std::vector<PolyArray>& fields, vtkFieldData* to) {
  for (const PolyArray& field : fields)
    std::visit([&](const auto& values) { to->AddArray(array_of(field.name, field.components, values)); }, field.values);
}

/// VTK cells with 32-bit numbers.
vtkNew<vtkCellArray> cells_of(const PolyCells& cells) {
  vtkNew<vtkCellArray> made;
  made->Use32BitStorage();
  made->AllocateExact(static_cast<vtkIdType>(cells.ends.size()), static_cast<vtkIdType>(cells.points.size()));
  std::size_t next = 0;
  for (const std::int32_t end : cells.ends) {
    made->InsertNextCell(end - static_cast<int>(next));
    for (; next < static_cast<std::size_t>(end); ++next) made->InsertCellPoint(cells.points[next]);
  }
  return made;
}

vtkNew<vtkPolyData> vtk_data(const PolyData& data) {
  vtkNew<vtkPolyData> made;
  vtkNew<vtkPoints> points;
  points->SetData(array_of("Points", 3, data.positions));
  made->SetPoints(points);
  made->SetVerts(cells_of(data.vertices));
  made->SetLines(cells_of(data.lines));
  made->SetPolys(cells_of(data.triangles));
  add(data.point_fields, made->GetPointData());
  add(data.cell_fields, made->GetCellData());
  if (data.time) {
    vtkNew<vtkDoubleArray> stamp;
    stamp->SetName("TimeValue");
    stamp->InsertNextValue(*data.time);
    made->GetFieldData()->AddArray(stamp);
  }
  return made;
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const PolyData& data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(vtk_data(data));
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  // The file is written to memory first, because VTK does not report every failed write to a file.
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw OutputError(path.string() + ": cannot write: VTK could not encode the data");
  replace_file(path, writer->GetOutputString());
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
// The two writers of snapshots: VTK must read the same data from the files of both.
#include "io/run/poly_data.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <string>

using namespace gyro;

namespace {

vtkSmartPointer<vtkPolyData> read(const std::filesystem::path& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  REQUIRE(reader->GetErrorCode() == 0);
  return reader->GetOutput();
}

void require_same(vtkDataArray* a, vtkDataArray* b) {
  REQUIRE(a->GetDataType() == b->GetDataType());
  REQUIRE(a->GetNumberOfComponents() == b->GetNumberOfComponents());
  REQUIRE(a->GetNumberOfTuples() == b->GetNumberOfTuples());
  bool same = true;
  for (vtkIdType row = 0; row < a->GetNumberOfTuples(); ++row)
    for (int c = 0; c < a->GetNumberOfComponents(); ++c) {
      const double x = a->GetComponent(row, c), y = b->GetComponent(row, c);
      same = same && (x == y || (std::isnan(x) && std::isnan(y)));
    }
  REQUIRE(same);
}

void require_same(vtkFieldData* a, vtkFieldData* b) {
  REQUIRE(a->GetNumberOfArrays() == b->GetNumberOfArrays());
  for (int k = 0; k < a->GetNumberOfArrays(); ++k) {
    REQUIRE(std::string(a->GetArrayName(k)) == b->GetArrayName(k));
    require_same(a->GetArray(k), b->GetArray(k));
  }
}

void require_same(vtkPolyData* a, vtkPolyData* b) {
  REQUIRE(a->GetNumberOfPoints() == b->GetNumberOfPoints());
  if (a->GetNumberOfPoints() > 0) require_same(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  REQUIRE(a->GetNumberOfVerts() == b->GetNumberOfVerts());
  REQUIRE(a->GetNumberOfLines() == b->GetNumberOfLines());
  REQUIRE(a->GetNumberOfPolys() == b->GetNumberOfPolys());
  vtkNew<vtkIdList> x, y;
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell) {
    a->GetCellPoints(cell, x);
    b->GetCellPoints(cell, y);
    REQUIRE(x->GetNumberOfIds() == y->GetNumberOfIds());
    for (vtkIdType k = 0; k < x->GetNumberOfIds(); ++k) REQUIRE(x->GetId(k) == y->GetId(k));
  }
  require_same(a->GetPointData(), b->GetPointData());
  require_same(a->GetCellData(), b->GetCellData());
  require_same(a->GetFieldData(), b->GetFieldData());
}

void require_same_files(const PolyData& data) {
  const ScratchDirectory scratch;
  write_vtp(scratch.path() / "vtk.vtp", data);
  write_vtp_plain(scratch.path() / "plain.vtp", data);
  require_same(read(scratch.path() / "vtk.vtp"), read(scratch.path() / "plain.vtp"));
}

/// A strip of triangles with a line along it and one vertex cell, with fields of every type.
PolyData strip(int points) {
  PolyData data;
  std::vector<float> real;
  std::vector<std::int32_t> whole;
  for (int k = 0; k < points; ++k) {
    data.positions.insert(data.positions.end(), {0.1F * static_cast<float>(k), static_cast<float>(k % 2), -1.5F});
    data.vertices.points.push_back(k);
    real.push_back(k == 1 ? std::nanf("") : 1 / static_cast<float>(k + 1));
    whole.push_back(-k);
  }
  data.vertices.ends = {points};
  data.lines = {{0, 1, 2}, {3}};
  for (int k = 0; k + 2 < points; ++k) {
    data.triangles.points.insert(data.triangles.points.end(), {k, k + 1, k + 2});
    data.triangles.ends.push_back(3 * (k + 1));
  }
  data.point_fields = {{"position", 3, data.positions}, {"real", 1, real}, {"whole", 1, whole}};
  data.cell_fields = {{"id", 1, std::vector<std::uint32_t>(static_cast<std::size_t>(points), 4000000000U)}};
  data.time = 0.1;
  return data;
}

}  // namespace

TEST_CASE("VTK reads the same data from the files of both writers") {
  require_same_files(strip(4));
  require_same_files(strip(200'000));  // more than one block
  PolyData timeless = strip(5);
  timeless.time.reset();
  require_same_files(timeless);
}

TEST_CASE("VTK reads the same data from the files of both writers if there are no points") {
  PolyData none;
  none.point_fields = {{"real", 1, std::vector<float>{}}};
  none.time = 1;
  require_same_files(none);
}

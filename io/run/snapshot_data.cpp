// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/snapshot_data.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeUInt32Array.h>
#include <array>
#include <cmath>
#include <type_traits>

namespace gyro {
namespace {

void set_vector(vtkFloatArray* array, std::size_t row, const Vec3d& v) {
  const std::array<float, 3> tuple{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  array->SetTypedTuple(static_cast<vtkIdType>(row), tuple.data());
}

/// A field of a snapshot: what is said of it, and the function (source, row) that gives its numbers. A function that
/// returns Vec3d makes three components.
template <class Source>
struct Field {
  using Add = void (*)(const Source& source, std::size_t rows, const char* name, vtkDataSetAttributes* to);

  const char *name, *units;
  int width;
  Add add;
  const char* description;
};

template <class Array, class Source, class F>
constexpr Field<Source> field(const char* name, const char* units, F, const char* description) {
  constexpr bool vector = std::is_same_v<std::invoke_result_t<F, const Source&, std::size_t>, Vec3d>;
  const auto add = [](const Source& source, std::size_t rows, const char* array_name, vtkDataSetAttributes* to) {
    vtkNew<Array> array;
    array->SetName(array_name);
    if constexpr (vector) array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
    for (std::size_t row = 0; row < rows; ++row)
      if constexpr (vector)
        set_vector(array, row, F{}(source, row));
      else
        array->SetValue(static_cast<vtkIdType>(row), static_cast<typename Array::ValueType>(F{}(source, row)));
    to->AddArray(array);
  };
  return {name, units, vector ? 3 : 1, add, description};
}

using Row = std::size_t;
using Particles = ParticleSnapshot;
using Bonds = BondSnapshot;

/// The triangles of all walls of a file.
struct WallTriangles {
  std::vector<Index> wall;
  WallLoads loads;  ///< NaN for the triangles of walls without; empty when there are none
};

constexpr Field<Particles> particle_fields[] = {
    field<vtkTypeUInt32Array, Particles>(
        "id", "1", [](const Particles& s, Row p) { return s.id[p]; }, "id of the particle"),
    field<vtkTypeInt32Array, Particles>(
        "rock", "1", [](const Particles& s, Row p) { return s.rock[p]; }, "number of the rock that it was made in"),
    field<vtkTypeUInt32Array, Particles>(
        "fragment", "1", [](const Particles& s, Row p) { return s.id[static_cast<std::size_t>(s.fragment[p])]; },
        "lowest id of the particles of its fragment"),
    field<vtkFloatArray, Particles>(
        "radius", "m", [](const Particles& s, Row p) { return s.radius[p]; }, "radius"),
    field<vtkFloatArray, Particles>(
        "mass", "kg", [](const Particles& s, Row p) { return s.mass[p]; }, "mass"),
    field<vtkFloatArray, Particles>(
        "velocity", "m/s", [](const Particles& s, Row p) { return s.velocity[p]; }, "velocity"),
    field<vtkFloatArray, Particles>(
        "force", "N", [](const Particles& s, Row p) { return s.force[p]; },
        "force of contacts, walls and bonds on it, without gravity"),
};

/// At the ends of the bonds, two rows each: the Tube filter of ParaView needs them there.
constexpr Field<Bonds> bond_end_fields[] = {
    field<vtkFloatArray, Bonds>(
        "radius", "m", [](const Bonds& s, Row end) { return s.radius[end / 2]; }, "radius of the bond"),
};

constexpr Field<Bonds> bond_fields[] = {
    field<vtkFloatArray, Bonds>(
        "normal_force", "N", [](const Bonds& s, Row b) { return s.normal_force[b]; }, "axial force, tension positive"),
    field<vtkFloatArray, Bonds>(
        "stress_ratio", "1", [](const Bonds& s, Row b) { return s.stress_ratio[b]; },
        "larger of tensile stress / strength and shear stress / strength; the bond fails at 1"),
};

constexpr Field<WallTriangles> wall_fields[] = {
    field<vtkTypeInt32Array, WallTriangles>(
        "wall", "1", [](const WallTriangles& s, Row t) { return s.wall[t]; },
        "number of the wall, in the order of the case file"),
};

/// With output.liners.
constexpr Field<WallTriangles> load_fields[] = {
    field<vtkFloatArray, WallTriangles>(
        "pressure", "Pa", [](const WallTriangles& s, Row t) { return s.loads.pressure[t]; },
        "with output.liners: mean pressure of rock since the start"),
    field<vtkFloatArray, WallTriangles>(
        "sliding_work", "J", [](const WallTriangles& s, Row t) { return s.loads.sliding_work[t]; },
        "with output.liners: work of friction since the start"),
};

constexpr Field<WallTriangles> wear_fields[] = {
    field<vtkFloatArray, WallTriangles>(
        "wear", "m", [](const WallTriangles& s, Row t) { return s.loads.wear[t]; },
        "with output.liners.wear_coefficient: depth of wear since the start"),
};

template <class Source, std::size_t N>
void add_fields(const Field<Source> (&fields)[N], const Source& source, std::size_t rows, vtkDataSetAttributes* to) {
  for (const Field<Source>& f : fields) f.add(source, rows, f.name, to);
}

template <class Source, std::size_t N>
void list_fields(const Field<Source> (&fields)[N], const char* kind, const char* row, std::vector<SnapshotField>& all) {
  for (const Field<Source>& f : fields) all.push_back({kind, row, f.name, f.units, f.width, f.description});
}

vtkNew<vtkFloatArray> positions(const std::vector<Vec3d>& values) {
  vtkNew<vtkFloatArray> array;
  array->SetName("position");
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

}  // namespace

std::vector<SnapshotField> snapshot_fields() {
  std::vector<SnapshotField> all;
  list_fields(particle_fields, "particles", "particle", all);
  list_fields(bond_end_fields, "bonds", "end of a bond", all);
  list_fields(bond_fields, "bonds", "bond", all);
  list_fields(wall_fields, "walls", "triangle", all);
  list_fields(load_fields, "walls", "triangle", all);
  list_fields(wear_fields, "walls", "triangle", all);
  return all;
}

vtkNew<vtkPolyData> particle_data(const ParticleSnapshot& s) {
  vtkNew<vtkPolyData> data;
  set_points(data, positions(s.position));
  // One cell holds all points: without a cell ParaView's surface view shows nothing.
  const auto count = static_cast<int>(s.size());
  data->SetVerts(cells_of(count > 0 ? 1 : 0, count, [](std::size_t, int k) { return k; }));
  add_fields(particle_fields, s, s.size(), data->GetPointData());
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
  add_fields(bond_end_fields, s, 2 * s.size(), data->GetPointData());
  add_fields(bond_fields, s, s.size(), data->GetCellData());
  return data;
}

namespace {

/// Appends the numbers of a wall behind those of the walls before it, which had none so far.
void append_loads(std::vector<double>& to, const std::vector<double>& numbers, std::size_t triangles_before) {
  if (numbers.empty()) return;
  to.resize(triangles_before, std::nan(""));
  to.insert(to.end(), numbers.begin(), numbers.end());
}

WallTriangles triangles_of(std::span<const PosedWall> walls) {
  WallTriangles all;
  for (const PosedWall& wall : walls) {
    if (wall.loads) {
      append_loads(all.loads.pressure, wall.loads->pressure, all.wall.size());
      append_loads(all.loads.sliding_work, wall.loads->sliding_work, all.wall.size());
      append_loads(all.loads.wear, wall.loads->wear, all.wall.size());
    }
    all.wall.insert(all.wall.end(), wall.mesh.triangles.size(), wall.wall);
  }
  for (auto* numbers : {&all.loads.pressure, &all.loads.sliding_work, &all.loads.wear})
    if (!numbers->empty()) numbers->resize(all.wall.size(), std::nan(""));
  return all;
}

}  // namespace

vtkNew<vtkPolyData> wall_data(std::span<const PosedWall> walls) {
  TriangleMesh all;
  for (const PosedWall& wall : walls) {
    const auto first = static_cast<Index>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), wall.mesh.vertices.begin(), wall.mesh.vertices.end());
    for (const Vec3<Index>& t : wall.mesh.triangles) all.triangles.push_back({t.x + first, t.y + first, t.z + first});
  }
  const WallTriangles triangles = triangles_of(walls);
  vtkNew<vtkPolyData> data;
  set_points(data, positions(all.vertices));
  data->SetPolys(cells_of(all.triangles.size(), 3, [&](std::size_t t, int k) {
    const Vec3<Index>& triangle = all.triangles[t];
    return k == 0 ? triangle.x : k == 1 ? triangle.y : triangle.z;
  }));
  const std::size_t count = triangles.wall.size();
  add_fields(wall_fields, triangles, count, data->GetCellData());
  if (!triangles.loads.pressure.empty()) add_fields(load_fields, triangles, count, data->GetCellData());
  if (!triangles.loads.wear.empty()) add_fields(wear_fields, triangles, count, data->GetCellData());
  return data;
}

}  // namespace gyro

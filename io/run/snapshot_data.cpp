// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/snapshot_data.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>

namespace gyro {
namespace {

void append(std::vector<float>& to, const Vec3d& v) {
  to.insert(to.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

/// A field of a snapshot: its name, units and description, and the function that makes its array. field() makes this
/// function from a function (source, row) that gives the numbers; one that returns Vec3d gives three components.
template <class Source>
struct Field {
  using Make = PolyArray (*)(const Source& source, std::size_t rows, const char* name);

  const char *name, *units;
  int width;
  Make make;
  const char* description;
};

template <class Number, class Source, class F>
constexpr Field<Source> field(const char* name, const char* units, F, const char* description) {
  constexpr bool vector = std::is_same_v<std::invoke_result_t<F, const Source&, std::size_t>, Vec3d>;
  constexpr int width = vector ? 3 : 1;
  const auto make = [](const Source& source, std::size_t rows, const char* array_name) {
    std::vector<Number> values;
    values.reserve(rows * width);
    for (std::size_t row = 0; row < rows; ++row)
      if constexpr (vector)
        append(values, F{}(source, row));
      else
        values.push_back(static_cast<Number>(F{}(source, row)));
    return PolyArray{array_name, width, std::move(values)};
  };
  return {name, units, width, make, description};
}

using Row = std::size_t;
using Particles = ParticleSnapshot;
using Bonds = BondSnapshot;
using Fragments = FragmentSnapshot;

/// The triangles of all walls in a file.
struct WallTriangles {
  std::vector<Index> wall;
  WallLoads loads;  ///< NaN for the triangles of walls without loads; empty if no wall has loads
};

constexpr Field<Particles> particle_fields[] = {
    field<std::uint32_t, Particles>(
        "id", "1", [](const Particles& s, Row p) { return s.id[p]; }, "id of the particle"),
    field<std::int32_t, Particles>(
        "rock", "1", [](const Particles& s, Row p) { return s.rock[p]; },
        "number of the rock that the particle was made in"),
    field<std::uint32_t, Particles>(
        "fragment", "1", [](const Particles& s, Row p) { return s.id[static_cast<std::size_t>(s.fragment[p])]; },
        "lowest particle id in its fragment"),
    field<float, Particles>(
        "radius", "m", [](const Particles& s, Row p) { return s.radius[p]; }, "radius"),
    field<float, Particles>(
        "mass", "kg", [](const Particles& s, Row p) { return s.mass[p]; }, "mass"),
    field<float, Particles>(
        "velocity", "m/s", [](const Particles& s, Row p) { return s.velocity[p]; }, "velocity"),
    field<float, Particles>(
        "force", "N", [](const Particles& s, Row p) { return s.force[p]; },
        "force of contacts, walls and bonds on the particle, without gravity"),
};

/// Fields at the two ends of each bond, where the Tube filter of ParaView needs them.
constexpr Field<Bonds> bond_end_fields[] = {
    field<float, Bonds>(
        "radius", "m", [](const Bonds& s, Row end) { return s.radius[end / 2]; }, "radius of the bond"),
};

constexpr Field<Bonds> bond_fields[] = {
    field<float, Bonds>(
        "normal_force", "N", [](const Bonds& s, Row b) { return s.normal_force[b]; }, "axial force, tension positive"),
    field<float, Bonds>(
        "stress_ratio", "1", [](const Bonds& s, Row b) { return s.stress_ratio[b]; },
        "larger of tensile stress / strength and shear stress / strength; the bond fails at 1"),
};

constexpr Field<Fragments> fragment_fields[] = {
    field<std::uint32_t, Fragments>(
        "id", "1", [](const Fragments& s, Row f) { return s.record[f].id; },
        "number of the fragment: the lowest id of its particles"),
    field<std::uint32_t, Fragments>(
        "parent", "1", [](const Fragments& s, Row f) { return s.parent[f]; },
        "number of the fragment of the snapshot before, or of an earlier one, that it broke off; its own for a rock "
        "as it was fed, and for what broke before the first snapshot of its rock"),
    field<std::int32_t, Fragments>(
        "rock", "1", [](const Fragments& s, Row f) { return s.record[f].rock; },
        "number of the rock that the fragment belonged to"),
    field<std::int32_t, Fragments>(
        "particles", "1", [](const Fragments& s, Row f) { return s.record[f].particles; }, "number of its particles"),
    field<float, Fragments>(
        "mass", "kg", [](const Fragments& s, Row f) { return s.record[f].mass; }, "mass"),
    field<float, Fragments>(
        "size", "m", [](const Fragments& s, Row f) { return s.record[f].size; }, "sieve size, as in /fragments"),
    field<float, Fragments>(
        "velocity", "m/s", [](const Fragments& s, Row f) { return s.record[f].velocity; },
        "velocity of the centre of mass"),
    field<float, Fragments>(
        "residence", "s", [](const Fragments& s, Row f) { return s.record[f].time - s.record[f].fed; },
        "time since its rock came into the scene"),
    field<float, Fragments>(
        "age", "s", [](const Fragments& s, Row f) { return s.record[f].time - s.formed[f]; },
        "time since the snapshot that first found the fragment as it is; of a rock as it was fed, its residence"),
};

constexpr Field<WallTriangles> wall_fields[] = {
    field<std::int32_t, WallTriangles>(
        "wall", "1", [](const WallTriangles& s, Row t) { return s.wall[t]; },
        "number of the wall, in the order of the case file"),
};

/// Fields that exist only with output.liners.
constexpr Field<WallTriangles> load_fields[] = {
    field<float, WallTriangles>(
        "pressure", "Pa", [](const WallTriangles& s, Row t) { return s.loads.pressure[t]; },
        "with output.liners: mean pressure of the rock since the start"),
    field<float, WallTriangles>(
        "sliding_work", "J", [](const WallTriangles& s, Row t) { return s.loads.sliding_work[t]; },
        "with output.liners: work of friction since the start"),
};

constexpr Field<WallTriangles> wear_fields[] = {
    field<float, WallTriangles>(
        "wear", "m", [](const WallTriangles& s, Row t) { return s.loads.wear[t]; },
        "with output.liners.wear_coefficient: depth of wear since the start"),
};

template <class Source, std::size_t N>
void add_fields(const Field<Source> (&fields)[N], const Source& source, std::size_t rows, std::vector<PolyArray>& to) {
  for (const Field<Source>& f : fields) to.push_back(f.make(source, rows, f.name));
}

template <class Source, std::size_t N>
void list_fields(const Field<Source> (&fields)[N], const char* kind, const char* row, std::vector<SnapshotField>& all) {
  for (const Field<Source>& f : fields) all.push_back({kind, row, f.name, f.units, f.width, f.description});
}

std::vector<float> positions(const std::vector<Vec3d>& values) {
  std::vector<float> all;
  all.reserve(3 * values.size());
  for (const Vec3d& value : values) append(all, value);
  return all;
}

}  // namespace

std::vector<SnapshotField> snapshot_fields() {
  std::vector<SnapshotField> all;
  list_fields(particle_fields, "particles", "particle", all);
  list_fields(bond_end_fields, "bonds", "end of a bond", all);
  list_fields(bond_fields, "bonds", "bond", all);
  list_fields(fragment_fields, "fragments", "fragment", all);
  list_fields(wall_fields, "walls", "triangle", all);
  list_fields(load_fields, "walls", "triangle", all);
  list_fields(wear_fields, "walls", "triangle", all);
  return all;
}

namespace {

/// Points in one cell, because without a cell ParaView's surface view shows nothing.
PolyData points_at(std::vector<float> positions_of_points) {
  PolyData data;
  data.positions = std::move(positions_of_points);
  const std::size_t count = data.positions.size() / 3;
  if (count > 0) data.vertices.ends = {static_cast<std::int32_t>(count)};
  data.vertices.points.resize(count);
  std::iota(data.vertices.points.begin(), data.vertices.points.end(), 0);
  return data;
}

}  // namespace

PolyData particle_data(const ParticleSnapshot& s) {
  PolyData data = points_at(positions(s.position));
  add_fields(particle_fields, s, s.size(), data.point_fields);
  return data;
}

PolyData fragment_data(const FragmentSnapshot& s) {
  std::vector<Vec3d> centres;
  for (const FragmentRecord& record : s.record) centres.push_back(record.position);
  PolyData data = points_at(positions(centres));
  add_fields(fragment_fields, s, s.size(), data.point_fields);
  return data;
}

PolyData bond_data(const BondSnapshot& s, const ParticleSnapshot& particles) {
  PolyData data;
  for (std::size_t b = 0; b < s.size(); ++b) {
    append(data.positions, particles.position[static_cast<std::size_t>(s.i[b])]);
    append(data.positions, particles.position[static_cast<std::size_t>(s.j[b])]);
    data.lines.ends.push_back(static_cast<std::int32_t>(2 * b + 2));
  }
  data.lines.points.resize(2 * s.size());
  std::iota(data.lines.points.begin(), data.lines.points.end(), 0);
  add_fields(bond_end_fields, s, 2 * s.size(), data.point_fields);
  add_fields(bond_fields, s, s.size(), data.cell_fields);
  return data;
}

namespace {

/// Appends the numbers of a wall; earlier triangles without numbers get NaN.
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

PolyData wall_data(std::span<const PosedWall> walls) {
  PolyData data;
  for (const PosedWall& wall : walls) {
    const auto first = static_cast<Index>(data.positions.size() / 3);
    for (const Vec3d& vertex : wall.mesh.vertices) append(data.positions, vertex);
    for (const Vec3<Index>& t : wall.mesh.triangles) {
      data.triangles.points.insert(data.triangles.points.end(), {t.x + first, t.y + first, t.z + first});
      data.triangles.ends.push_back(static_cast<std::int32_t>(data.triangles.points.size()));
    }
  }
  const WallTriangles triangles = triangles_of(walls);
  const std::size_t count = triangles.wall.size();
  add_fields(wall_fields, triangles, count, data.cell_fields);
  if (!triangles.loads.pressure.empty()) add_fields(load_fields, triangles, count, data.cell_fields);
  if (!triangles.loads.wear.empty()) add_fields(wear_fields, triangles, count, data.cell_fields);
  return data;
}

}  // namespace gyro

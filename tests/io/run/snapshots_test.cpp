// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/snapshots.hpp"

#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <sys/stat.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

vtkSmartPointer<vtkPolyData> read(const std::filesystem::path& path) {
  REQUIRE(std::filesystem::exists(path));
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  REQUIRE(reader->GetErrorCode() == 0);
  return reader->GetOutput();
}

ParticleSnapshot three_particles() {
  ParticleSnapshot s;
  s.id = {5, 9, 4000000000u};
  s.rock = {0, 0, 3};
  s.fragment = {0, 0, 2};
  s.position = {{0, 0, 1}, {0.5, 0, 1}, {2, -1, 0.25}};
  s.velocity = {{1, 2, 3}, {0, 0, 0}, {0, 0, -1}};
  s.angular_velocity.resize(3, {0, 0, 0});
  s.force = {{10, 0, 0}, {-10, 0, 0}, {0, 0, 7}};
  s.radius = {0.25, 0.25, 0.5};
  s.mass = {1, 1, 8};
  return s;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

double value(vtkDataSetAttributes* fields, const char* name, vtkIdType row, int component = 0) {
  vtkDataArray* array = fields->GetArray(name);
  REQUIRE(array != nullptr);
  return array->GetComponent(row, component);
}

}  // namespace

TEST_CASE("Particles read back with VTK as they were written") {
  const ScratchDirectory scratch;
  const ParticleSnapshot particles = three_particles();
  SnapshotWriter writer(scratch.path());
  writer.write({.time = 0.125, .particles = &particles});

  const auto data = read(scratch.path() / "snapshots" / "particles_000000.vtp");
  REQUIRE(data->GetNumberOfPoints() == 3);
  REQUIRE(data->GetNumberOfVerts() == 1);
  CHECK(data->GetCell(0)->GetNumberOfPoints() == 3);
  vtkPointData* fields = data->GetPointData();
  const double fragments[] = {5, 5, 4e9};  // id of the fragment's first particle
  for (vtkIdType p = 0; p < 3; ++p) {
    const auto row = static_cast<std::size_t>(p);
    CHECK(data->GetPoint(p)[0] == particles.position[row].x);
    CHECK(data->GetPoint(p)[2] == particles.position[row].z);
    CHECK(value(fields, "id", p) == particles.id[row]);
    CHECK(value(fields, "rock", p) == particles.rock[row]);
    CHECK(value(fields, "fragment", p) == fragments[p]);
    CHECK(value(fields, "radius", p) == particles.radius[row]);
    CHECK(value(fields, "mass", p) == particles.mass[row]);
    CHECK(value(fields, "velocity", p, 2) == particles.velocity[row].z);
    CHECK(value(fields, "force", p, 0) == particles.force[row].x);
  }
  CHECK(data->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 0.125);
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "bonds.pvd"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "walls.pvd"));
}

TEST_CASE("Bonds read back with VTK as they were written") {
  const ScratchDirectory scratch;
  const ParticleSnapshot particles = three_particles();
  const BondSnapshot bonds{{0, 1}, {1, 2}, {-5, 2.5}, {0.5, 0.75}, {0.125, 0.25}};
  SnapshotWriter(scratch.path()).write({.time = 1, .particles = &particles, .bonds = &bonds});

  const auto data = read(scratch.path() / "snapshots" / "bonds_000000.vtp");
  REQUIRE(data->GetNumberOfLines() == 2);
  REQUIRE(data->GetNumberOfPoints() == 4);
  for (vtkIdType b = 0; b < 2; ++b) {
    const auto row = static_cast<std::size_t>(b);
    CHECK(value(data->GetCellData(), "normal_force", b) == bonds.normal_force[row]);
    CHECK(value(data->GetCellData(), "stress_ratio", b) == bonds.stress_ratio[row]);
    CHECK(value(data->GetPointData(), "radius", 2 * b + 1) == bonds.radius[row]);
    CHECK(data->GetCell(b)->GetPointId(0) == 2 * b);
    CHECK(data->GetPoint(2 * b + 1)[0] == particles.position[static_cast<std::size_t>(bonds.j[row])].x);
  }
}

TEST_CASE("Fragments read back with VTK as they were written") {
  const ScratchDirectory scratch;
  FragmentRecord one{.time = 2, .id = 4000000000u, .rock = 7, .particles = 12, .mass = 3.5, .size = 0.25};
  one.position = {1, 2, 3};
  one.velocity = {0, 0, -4};
  one.fed = 0.5;
  const FragmentSnapshot fragments{{one, one}, {6, 4000000000u}, {1.5, 0.5}};
  SnapshotWriter(scratch.path()).write({.time = 2, .fragments = &fragments});
  const auto data = read(scratch.path() / "snapshots" / "fragments_000000.vtp");
  REQUIRE(data->GetNumberOfPoints() == 2);
  vtkPointData* fields = data->GetPointData();
  CHECK(data->GetPoint(1)[1] == 2);
  CHECK(value(fields, "id", 0) == 4e9);
  CHECK(value(fields, "parent", 0) == 6);
  CHECK(value(fields, "rock", 0) == 7);
  CHECK(value(fields, "particles", 0) == 12);
  CHECK(value(fields, "mass", 0) == 3.5);
  CHECK(value(fields, "size", 0) == 0.25);
  CHECK(value(fields, "velocity", 0, 2) == -4);
  CHECK(value(fields, "residence", 0) == 1.5);
  CHECK(value(fields, "age", 0) == 0.5);
  CHECK(value(fields, "age", 1) == 1.5);
  CHECK(std::filesystem::exists(scratch.path() / "fragments.pvd"));
}

TEST_CASE("Walls read back with VTK as they were written") {
  const ScratchDirectory scratch;
  const PosedWall walls[] = {{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 0, {}},
                             {{{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}}, {{0, 1, 2}, {1, 3, 2}}}, 2, {}}};
  SnapshotWriter(scratch.path()).write({.time = 1, .walls = walls});
  const auto data = read(scratch.path() / "snapshots" / "walls_000000.vtp");
  REQUIRE(data->GetNumberOfPolys() == 3);
  REQUIRE(data->GetNumberOfPoints() == 7);
  CHECK(value(data->GetCellData(), "wall", 0) == 0);
  CHECK(value(data->GetCellData(), "wall", 2) == 2);
  CHECK(data->GetCell(2)->GetPointId(1) == 6);  // vertex 3 of the second wall
  CHECK(data->GetPoint(6)[2] == 2);
}

TEST_CASE("Walls that never change are written once and belong to every frame") {
  const ScratchDirectory scratch;
  const PosedWall fixed[] = {{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 1, {}}};
  const auto moving = [](double z) { return PosedWall{{{{0, 0, z}, {1, 0, z}, {0, 1, z}}, {{0, 1, 2}}}, 0, {}}; };
  {
    SnapshotWriter writer(scratch.path());
    writer.write_fixed(fixed);
    for (const double time : {0.0, 0.5}) writer.write({.time = time, .walls = std::array{moving(time)}});
  }
  SnapshotWriter resumed(scratch.path(), {0.0});
  resumed.write_fixed(fixed);
  resumed.write({.time = 0.25, .walls = std::array{moving(0.25)}});
  CHECK(text_of(scratch.path() / "walls.pvd") ==
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n"
        "    <DataSet timestep=\"0\" part=\"0\" file=\"snapshots/walls_000000.vtp\"/>\n"
        "    <DataSet timestep=\"0\" part=\"1\" file=\"snapshots/walls_fixed.vtp\"/>\n"
        "    <DataSet timestep=\"0.25\" part=\"0\" file=\"snapshots/walls_000001.vtp\"/>\n"
        "    <DataSet timestep=\"0.25\" part=\"1\" file=\"snapshots/walls_fixed.vtp\"/>\n"
        "  </Collection>\n</VTKFile>\n");
  CHECK(value(read(scratch.path() / "snapshots/walls_fixed.vtp")->GetCellData(), "wall", 0) == 1);
  CHECK(read(scratch.path() / "snapshots/walls_000001.vtp")->GetPoint(0)[2] == 0.25);
}

TEST_CASE("Loads are fields of the walls that have them, and NaN for other walls") {
  const ScratchDirectory scratch;
  const TriangleMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const PosedWall walls[] = {{one, 0, {}}, {one, 1, WallLoads{{2e5}, {3}, {4e-6}}}, {one, 2, {}}};
  SnapshotWriter(scratch.path()).write({.time = 1, .walls = walls});
  const auto data = read(scratch.path() / "snapshots/walls_000000.vtp");
  vtkCellData* fields = data->GetCellData();
  CHECK(std::isnan(value(fields, "pressure", 0)));
  CHECK(value(fields, "pressure", 1) == 2e5);
  CHECK(value(fields, "sliding_work", 1) == 3);
  CHECK(value(fields, "wear", 1) == Approx(4e-6));
  CHECK(std::isnan(value(fields, "wear", 2)));
}

TEST_CASE("The cost of a frame does not grow with the number of frames") {
  const ScratchDirectory scratch;
  const auto index_bytes = [&] { return std::filesystem::file_size(scratch.path() / "particles.pvd"); };
  const ParticleSnapshot none_left;
  SnapshotWriter writer(scratch.path());
  struct stat before = {}, after = {};
  writer.write({.time = 0, .particles = &none_left});
  ::stat((scratch.path() / "particles.pvd").c_str(), &before);
  const auto bytes = index_bytes();
  for (int frame = 1; frame < 200; ++frame) writer.write({.time = 0.001 * frame, .particles = &none_left});
  ::stat((scratch.path() / "particles.pvd").c_str(), &after);
  CHECK(before.st_ino == after.st_ino);  // lines were appended, and the index was not rewritten
  CHECK(index_bytes() > 199 * (bytes / 4));
}

TEST_CASE("The files have the fields of the reference page, with the same numbers of components") {
  const ScratchDirectory scratch;
  const ParticleSnapshot particles = three_particles();
  const BondSnapshot bonds{{0}, {1}, {-5}, {0.5}, {0.125}};
  const PosedWall walls[] = {{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 0, WallLoads{{1}, {1}, {1}}}};
  const FragmentSnapshot fragments{{FragmentRecord{.time = 1, .id = 5, .particles = 2}}, {5}, {0.5}};
  SnapshotWriter(scratch.path())
      .write({.time = 1, .particles = &particles, .bonds = &bonds, .walls = walls, .fragments = &fragments});
  std::map<std::string, int> described, written;
  for (const SnapshotField& field : snapshot_fields()) described[field.kind + " " + field.name] = field.width;
  for (const std::string kind : {"particles", "bonds", "walls", "fragments"}) {
    const auto data = read(scratch.path() / "snapshots" / (kind + "_000000.vtp"));
    for (vtkDataSetAttributes* fields : {static_cast<vtkDataSetAttributes*>(data->GetPointData()),
                                         static_cast<vtkDataSetAttributes*>(data->GetCellData())})
      for (int k = 0; k < fields->GetNumberOfArrays(); ++k)
        written[kind + " " + fields->GetArrayName(k)] = fields->GetArray(k)->GetNumberOfComponents();
  }
  CHECK(described == written);
}

TEST_CASE("The indices contain every frame with its time, also after a resume") {
  const ScratchDirectory scratch;
  const ParticleSnapshot particles = three_particles();
  {
    SnapshotWriter writer(scratch.path());
    for (const double time : {0.0, 0.02}) writer.write({.time = time, .particles = &particles});
  }
  SnapshotWriter resumed(scratch.path(), {0.0, 0.02});
  resumed.write({.time = 0.04, .particles = &particles});
  CHECK(resumed.times() == std::vector{0.0, 0.02, 0.04});
  const std::string index = text_of(scratch.path() / "particles.pvd");
  CHECK_THAT(index, Contains("timestep=\"0\" part=\"0\" file=\"snapshots/particles_000000.vtp\"") &&
                        Contains("timestep=\"0.02\" part=\"0\" file=\"snapshots/particles_000001.vtp\"") &&
                        Contains("timestep=\"0.04\" part=\"0\" file=\"snapshots/particles_000002.vtp\""));
  CHECK(std::filesystem::exists(scratch.path() / "snapshots" / "particles_000002.vtp"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "particles.pvd.tmp"));
}

TEST_CASE("Frames after those that a resumed run keeps are removed from index and disk") {
  const ScratchDirectory scratch;
  const ParticleSnapshot particles = three_particles();
  {
    SnapshotWriter writer(scratch.path());
    for (const double time : {0.0, 0.02, 0.04, 0.06}) writer.write({.time = time, .particles = &particles});
  }
  const SnapshotWriter resumed(scratch.path(), {0.0, 0.02});
  const auto frame = [&](const char* name) { return std::filesystem::exists(scratch.path() / "snapshots" / name); };
  CHECK(frame("particles_000001.vtp"));
  CHECK_FALSE(frame("particles_000002.vtp"));
  CHECK_FALSE(frame("particles_000003.vtp"));
  const std::string index = text_of(scratch.path() / "particles.pvd");
  CHECK_THAT(index, Contains("particles_000001.vtp") && !Contains("particles_000002.vtp"));
}

TEST_CASE("An empty scene gives files that VTK reads") {
  const ScratchDirectory scratch;
  const ParticleSnapshot none_left;
  const BondSnapshot no_bonds;
  SnapshotWriter(scratch.path()).write({.time = 0, .particles = &none_left, .bonds = &no_bonds});
  CHECK(read(scratch.path() / "snapshots" / "particles_000000.vtp")->GetNumberOfPoints() == 0);
  CHECK(read(scratch.path() / "snapshots" / "bonds_000000.vtp")->GetNumberOfLines() == 0);
}

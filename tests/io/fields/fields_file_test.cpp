// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/fields/fields_file.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"
#include "tests/io/fields/read_fields.hpp"
#include "tests/io/fields/snapshots.hpp"
#include "tests/io/run/scratch.hpp"

#include <fstream>
#include <iterator>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

/// Writes the frame of a time: particles, bonds, and a wall that rises.
void write_frame(FieldsFile& fields, double time, std::size_t count) {
  const ParticleSnapshot particles = particles_at(time, count);
  const BondSnapshot bonds = bonds_at(time, count - 1);
  const PosedWall walls[] = {wall_at(time, 1)};
  fields.write({.time = time, .particles = &particles, .bonds = &bonds, .walls = walls});
}

const PosedWall floor_walls[] = {wall_at(-1, 0)};

void write_frames(const std::filesystem::path& directory, std::initializer_list<double> times) {
  FieldsFile fields(directory);
  fields.take_fixed(floor_walls);
  for (const double time : times) write_frame(fields, time, 3000);
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t count_of(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// All numbers of all frames of a run's file.
std::vector<std::vector<double>> frames_of(const std::filesystem::path& directory) {
  const hdf5::File file = hdf5::File::open_closed(directory / "fields.h5");
  std::vector<std::vector<double>> frames;
  for (const char* group : {"/VTKHDF", "/bonds", "/liners", "/liners_fixed"})
    for (std::int64_t frame = 0; frame < frame_count(file, group); ++frame)
      frames.push_back(numbers_of(file, group, frame));
  return frames;
}

}  // namespace

TEST_CASE("Frames of fields.h5 read back as they were written, with particles that become more and fewer") {
  const ScratchDirectory scratch;
  const std::size_t counts[] = {2, 5000, 7, 20000, 20000, 1};
  FieldsFile fields(scratch.path());
  for (std::size_t frame = 0; frame < std::size(counts); ++frame)
    write_frame(fields, 0.5 * static_cast<double>(frame), counts[frame]);

  const hdf5::File file = hdf5::File::open_closed(scratch.path() / "fields.h5");
  REQUIRE(frame_count(file, "/VTKHDF") == 6);
  for (std::size_t frame = 0; frame < std::size(counts); ++frame) {
    const double time = 0.5 * static_cast<double>(frame);
    const auto number = static_cast<std::int64_t>(frame), count = static_cast<std::int64_t>(counts[frame]);
    CAPTURE(frame);
    const FieldFrame particles = read_frame(file, "/VTKHDF", number), bonds = read_frame(file, "/bonds", number);
    CHECK(particles.time == time);
    CHECK(particles.points.rows == count);
    const std::vector<double> positions = numbers_of(file, particles.points);
    for (std::size_t p = 0; p < counts[frame]; p += 37) {
      CHECK(positions[3 * p] == static_cast<double>(p));
      CHECK(positions[3 * p + 2] == static_cast<float>(static_cast<double>(p) * time));
    }
    CHECK(bonds.cells == count - 1);
    CHECK((bonds.kind == CellKind::lines || bonds.cells == 0));
    const std::vector<double> begins = cell_begins(file, "/bonds", number);
    REQUIRE(begins.size() == counts[frame] + 3);  // of the lines one more than there are; 0 of each other kind
    for (std::size_t cell = 0; cell < counts[frame]; ++cell) REQUIRE(begins[1 + cell] == 2 * static_cast<double>(cell));
    const std::vector<double> ids = numbers_of(file, bonds.connectivity);
    for (std::size_t end = 0; end < ids.size(); ++end) REQUIRE(ids[end] == static_cast<double>(end));
  }
  CHECK(file.dataset("/VTKHDF/PointData/velocity").columns() == 3);
  CHECK(file.string_attribute("/VTKHDF/PointData/velocity", "units") == "m/s");
  CHECK(file.string_attribute("/bonds/PointData/radius", "description") == "radius of the bond");
}

TEST_CASE("What does not change from frame to frame is stored once") {
  const ScratchDirectory scratch;
  write_frames(scratch.path(), {0, 0.5, 1});
  const hdf5::File file = hdf5::File::open_closed(scratch.path() / "fields.h5");
  const auto first = [&](const std::string& dataset) { return file.dataset(dataset).read(); };
  CHECK(first("/liners_fixed/Steps/PointOffsets") == std::vector<double>{0, 0, 0});
  CHECK(first("/VTKHDF/Steps/PointDataOffsets/radius") == std::vector<double>{0, 0, 0});
  CHECK(first("/bonds/Steps/ConnectivityIdOffsets") == std::vector<double>(12, 0));
  const std::vector<double> moved = first("/liners/Steps/PointOffsets");
  CHECK((moved[0] < moved[1] && moved[1] < moved[2]));
  const std::size_t chunk = static_cast<std::size_t>(file.dataset("/VTKHDF/Points").chunk_rows());
  for (const double at : first("/VTKHDF/Steps/PointOffsets")) CHECK(static_cast<std::size_t>(at) % chunk == 0);
}

TEST_CASE("A resumed run keeps the frames before its checkpoint, and writes over later ones") {
  const ScratchDirectory whole, parts;
  write_frames(whole.path(), {0, 0.5, 1, 1.5});
  write_frames(parts.path(), {0, 0.5, 1, 1.25});
  {
    FieldsFile fields(parts.path(), {0, 0.5, 1});
    CHECK(count_of("<Time", text_of(parts.path() / "fields.xdmf")) == 3);
    fields.take_fixed(floor_walls);
    write_frame(fields, 1.5, 3000);
  }
  CHECK(frames_of(parts.path()) == frames_of(whole.path()));
  CHECK(count_of("<Time", text_of(parts.path() / "fields.xdmf")) == 4);
  CHECK(count_of("<Time", text_of(parts.path() / "fields" / "bonds.xdmf")) == 4);

  CHECK_THROWS_WITH(FieldsFile(parts.path(), {0, 0.75, 1}), Contains("fields.h5: has a frame at 0.5"));
  CHECK_THROWS_WITH(FieldsFile(parts.path(), {0, 0.5, 1, 1.5, 2}), Contains("has 4 frames, not the 5 before"));
  std::filesystem::resize_file(parts.path() / "fields.h5", 3000);
  CHECK_THROWS_AS(FieldsFile(parts.path(), {0, 0.5, 1}), BadInput);
  std::filesystem::remove(parts.path() / "fields.h5");
  CHECK_THROWS_WITH(FieldsFile(parts.path(), {0, 0.5, 1}), Contains("fields.h5: is missing"));
}

TEST_CASE("The XDMF index names the rows of each frame") {
  const ScratchDirectory scratch;
  write_frames(scratch.path(), {0, 0.5});
  const std::string all = text_of(scratch.path() / "fields.xdmf"), one = text_of(scratch.path() / "fields/bonds.xdmf");
  CHECK_THAT(all, Contains("fields.h5:/VTKHDF/Points|0 0:1 1:3000 3:"));
  CHECK_THAT(all, Contains("|3072 0:1 1:3000 3:6144 3"));  // frames begin with chunks of 1024 rows
  CHECK_THAT(all, Contains("TopologyType=\"Triangle\" NumberOfElements=\"2\""));
  CHECK_THAT(one, Contains("<Time Value=\"0.5\"/>"));
  CHECK_THAT(one, Contains("TopologyType=\"Polyline\" NumberOfElements=\"2999\" NodesPerElement=\"2\""));
  CHECK_THAT(one, Contains("../fields.h5:/bonds/CellData/stress_ratio|"));
  CHECK(count_of("<Grid ", all) == count_of("</Grid>", all));
}

TEST_CASE("A frame without particles and bonds is a point without size in the XDMF index") {
  const ScratchDirectory scratch;
  FieldsFile fields(scratch.path());
  const ParticleSnapshot none;
  const BondSnapshot no_bonds;
  const PosedWall walls[] = {wall_at(0, 1)};
  fields.write({.time = 0, .particles = &none, .bonds = &no_bonds, .walls = walls});
  write_frame(fields, 1, 4);
  const std::string particles = text_of(scratch.path() / "fields/particles.xdmf");
  CHECK_THAT(particles,
             Contains("Dimensions=\"1 3\" NumberType=\"Float\" Precision=\"4\">0 0 0</DataItem></Geometry>"));
  CHECK_THAT(particles, Contains("/VTKHDF/Points|0 0:1 1:4 3:"));
  const hdf5::File file = hdf5::File::open_closed(scratch.path() / "fields.h5");
  CHECK(read_frame(file, "/VTKHDF", 0).points.rows == 0);
  CHECK(read_frame(file, "/bonds", 1).cells == 3);
}

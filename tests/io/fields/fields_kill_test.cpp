// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/math/random.hpp"
#include "io/fields/fields_file.hpp"
#include "tests/catch.hpp"
#include "tests/io/fields/read_fields.hpp"
#include "tests/io/fields/snapshots.hpp"
#include "tests/io/run/kill_writer.hpp"
#include "tests/io/run/scratch.hpp"

using namespace gyro;

namespace {

constexpr std::size_t particle_count = 3000;

void write_frame(FieldsFile& fields, int frame) {
  const ParticleSnapshot particles = particles_at(frame, particle_count);
  const BondSnapshot bonds = bonds_at(frame, particle_count - 1);
  fields.write({.time = static_cast<double>(frame), .particles = &particles, .bonds = &bonds});
}

[[noreturn]] void write_forever(const std::filesystem::path& directory, int pipe_end) {
  FieldsFile fields(directory);
  for (int frame = 0;; ++frame) {
    write_frame(fields, frame);
    if (frame == 3 && ::write(pipe_end, "b", 1) != 1) ::_exit(1);
  }
}

/// Requires that frame k is that of the time k. @returns the number of frames
std::int64_t count_good_frames(const hdf5::File& file) {
  const std::int64_t frames = frame_count(file, "/VTKHDF");
  for (std::int64_t k = 0; k < frames; ++k) {
    const FieldFrame frame = read_frame(file, "/VTKHDF", k);
    REQUIRE(frame.time == static_cast<double>(k));
    REQUIRE(frame.points.rows == static_cast<std::int64_t>(particle_count));
    const std::vector<double> positions = numbers_of(file, frame.points);
    for (std::size_t p = 0; p < particle_count; ++p) REQUIRE(positions[3 * p + 1] == static_cast<double>(k));
    const FieldFrame bonds = read_frame(file, "/bonds", k);
    REQUIRE(bonds.cells == static_cast<std::int64_t>(particle_count) - 1);
    for (const FieldRows& field : bonds.cell_fields)
      if (field.name() == "normal_force") REQUIRE(numbers_of(file, field)[2] == 2.0 * static_cast<double>(k));
  }
  return frames;
}

/// Opens a file as any program does. The writer may be at a frame: then once more.
hdf5::File open_between_frames(const std::filesystem::path& path) {
  for (int attempt = 0;; ++attempt) {
    try {
      return hdf5::File::open_closed(path);
    } catch (const OutputError&) {
      if (attempt == 1000) throw;
      ::usleep(200);
    }
  }
}

}  // namespace

TEST_CASE("Frames can be read while more are written, and after the writer was killed at any time") {
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "fields.h5";
  for (int kill = 0; kill < 20; ++kill) {
    CAPTURE(kill);
    const double wait = 60e3 * uniform(3, Stream::place, static_cast<std::uint64_t>(kill), 0);
    kill_writer_after(
        static_cast<useconds_t>(wait), [&](int pipe_end) { write_forever(scratch.path(), pipe_end); },
        [&] { CHECK(count_good_frames(open_between_frames(path)) >= 4); });
    hdf5::File::modify(path).close();  // as a resumed run and h5clear do
    const std::int64_t left = count_good_frames(hdf5::File::open_closed(path));
    CHECK(left >= 4);
    FieldsFile resumed(scratch.path(), {0, 1, 2});  // from a checkpoint before the last frames
    write_frame(resumed, 3);
    CHECK(count_good_frames(hdf5::File::open_closed(path)) == 4);
  }
}

TEST_CASE("A reader that keeps the file open does not keep the writer out") {
  const ScratchDirectory scratch;
  FieldsFile fields(scratch.path());
  const ParticleSnapshot particles = particles_at(0, 10);
  fields.write({.time = 0, .particles = &particles});
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t reader = ::fork();
  if (reader == 0) {
    try {
      const hdf5::File open = hdf5::File::open_closed(scratch.path() / "fields.h5");
      if (::write(ends[1], "b", 1) == 1)
        for (;;) ::pause();
    } catch (const std::exception&) {  // the parent reads nothing
    }
    ::_exit(1);
  }
  ::close(ends[1]);
  char opened = 0;
  REQUIRE(::read(ends[0], &opened, 1) == 1);
  const ParticleSnapshot next = particles_at(1, 10);
  CHECK_NOTHROW(fields.write({.time = 1, .particles = &next}));
  CHECK_NOTHROW(FieldsFile(scratch.path(), {0}));
  ::kill(reader, SIGKILL);
  ::waitpid(reader, nullptr, 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/view3d/encode.hpp"
#include "app/report/view3d/frames.hpp"
#include "core/base/errors.hpp"
#include "io/run/poly_data.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <fstream>

using namespace gyro;
using namespace gyro::report;
using Catch::Matchers::Contains;

namespace {

/// A snapshot of particles in a row; every second pair belongs to one fragment.
void write_particles(const std::filesystem::path& file, std::uint32_t n, double time) {
  PolyData data;
  std::vector<float> radius;
  std::vector<std::uint32_t> fragment;
  for (std::uint32_t k = 0; k < n; ++k) {
    data.positions.insert(data.positions.end(), {static_cast<float>(k), 0.5f, 2});
    radius.push_back(k == 3 ? 9.0f : 1.0f);
    fragment.push_back(k % 4 == 1 ? k - 1 : k);
  }
  data.point_fields = {{"fragment", 1, fragment}, {"radius", 1, radius}};
  data.time = time;
  write_vtp(file, data);
}

}  // namespace

TEST_CASE("Frames are chosen evenly, with the first and the last") {
  CHECK(chosen_frames(51, 8) == std::vector<std::size_t>{0, 7, 14, 21, 28, 35, 42, 50});
  CHECK(chosen_frames(3, 8) == std::vector<std::size_t>{0, 1, 2});
  CHECK(chosen_frames(5, 1) == std::vector<std::size_t>{4});
  CHECK(chosen_frames(0, 8).empty());
}

TEST_CASE("A frame has the largest particles, and the colour of a fragment only where it has several") {
  const ScratchDirectory run;
  CHECK(read_frames(run.path(), {}).empty());
  std::filesystem::create_directory(run.path() / "snapshots");
  write_particles(run.path() / "snapshots/particles_000000.vtp", 100, 0);
  write_particles(run.path() / "snapshots/particles_000001.vtp", 100, 0.25);
  const std::vector<ViewFrame> frames = read_frames(run.path(), {.frames = 8, .particles = 10});
  REQUIRE(frames.size() == 2);
  CHECK(frames[1].time == 0.25);
  CHECK(frames[1].particles == 100);
  CHECK(frames[1].spheres.size() == 40);
  CHECK(frames[1].spheres[3] == 9);  // the largest one
  const ViewFrame all = read_frames(run.path(), {}).front();
  std::size_t joined = 0;
  for (const std::uint8_t colour : all.colours) joined += colour > 0;
  CHECK(joined == 50);
  const std::string html = html_frame(all);
  CHECK_THAT(html, Contains("data-spheres=\"100\"") && Contains("data-triangles=\"0\""));
  CHECK_THAT(slice_picture(all), Contains("<circle class=\"p p") && Contains("</svg>"));
}

TEST_CASE("A damaged snapshot is bad input with its path") {
  const ScratchDirectory run;
  std::filesystem::create_directory(run.path() / "snapshots");
  const auto file = run.path() / "snapshots/particles_000000.vtp";
  write_particles(file, 500, 0);
  const auto size = std::filesystem::file_size(file);
  for (const auto length : {size / 2, size / 10, std::uintmax_t{0}}) {
    std::filesystem::resize_file(file, length);
    CHECK_THROWS_WITH(read_frames(run.path(), {}), Contains("particles_000000.vtp"));
    CHECK_THROWS_AS(read_frames(run.path(), {}), BadInput);
  }
}

TEST_CASE("A fine mesh keeps its shape with fewer corners") {
  WallMesh tube;
  constexpr int rings = 200, sectors = 300;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double angle = 2 * 3.14159265358979 * j / sectors;
      tube.positions.insert(tube.positions.end(),
                            {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                             static_cast<float>(2.0 * i / rings)});
    }
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t j = 0; j < sectors; ++j) {
      const std::uint32_t a = i * sectors + j, b = i * sectors + (j + 1) % sectors;
      tube.corners.insert(tube.corners.end(), {a, b, a + sectors, b, b + sectors, a + sectors});
    }
  const WallMesh few = simplified(tube, 0.1);
  CHECK(few.positions.size() / 3 < 2000);
  CHECK(few.corners.size() / 3 > 1000);
  CHECK(few.corners.size() / 3 < 4000);
  for (std::size_t k = 0; k < few.positions.size(); k += 3)
    CHECK(std::hypot(few.positions[k], few.positions[k + 1]) == Approx(1).margin(0.01));
}

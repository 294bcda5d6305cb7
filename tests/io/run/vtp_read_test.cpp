// SPDX-License-Identifier: GPL-3.0-or-later
// Our reader of snapshots gives back what both writers have written, and refuses damaged files.
#include "core/base/errors.hpp"
#include "io/run/poly_data.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <fstream>
#include <sstream>

using namespace gyro;

namespace {

PolyData sample(std::size_t points) {
  PolyData data;
  std::vector<float> radius;
  std::vector<std::uint32_t> id;
  for (std::size_t k = 0; k < points; ++k) {
    const auto x = static_cast<float>(k);
    data.positions.insert(data.positions.end(), {x, 0.5f * x, -x});
    radius.push_back(1 / (1 + x));
    id.push_back(static_cast<std::uint32_t>(7 * k));
  }
  data.point_fields = {{"radius", 1, radius}, {"id", 1, id}};
  if (points >= 3) {
    data.triangles = {{0, 1, 2}, {3}};
    data.cell_fields = {{"wall", 1, std::vector<std::int32_t>{5}}};
  }
  data.time = 0.125;
  return data;
}

void require_same(const PolyData& a, const PolyData& b) {
  REQUIRE(a.positions == b.positions);
  REQUIRE(a.triangles.points == b.triangles.points);
  REQUIRE(a.triangles.ends == b.triangles.ends);
  REQUIRE(a.time == b.time);
  REQUIRE(a.point_fields.size() == b.point_fields.size());
  for (std::size_t k = 0; k < a.point_fields.size(); ++k) {
    CHECK(a.point_fields[k].name == b.point_fields[k].name);
    CHECK(a.point_fields[k].values == b.point_fields[k].values);
  }
  REQUIRE(a.cell_fields.size() == b.cell_fields.size());
  for (std::size_t k = 0; k < a.cell_fields.size(); ++k) CHECK(a.cell_fields[k].values == b.cell_fields[k].values);
}

}  // namespace

TEST_CASE("A snapshot is read back as it was written, by both writers, in one block or in several") {
  const ScratchDirectory scratch;
  for (const std::size_t points : {0, 1, 3, 300'000}) {
    INFO(points);
    const PolyData data = sample(points);
    write_vtp(scratch.path() / "a.vtp", data);
    write_vtp_plain(scratch.path() / "b.vtp", data);
    require_same(read_vtp(scratch.path() / "a.vtp"), data);
    require_same(read_vtp(scratch.path() / "b.vtp"), data);
  }
}

TEST_CASE("A snapshot with any byte changed or its end missing is read or refused, and never crashes") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "a.vtp";
  write_vtp_plain(file, sample(50));
  std::stringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string good = bytes.str();
  const auto read_changed = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    try {
      read_vtp(file);
    } catch (const BadInput& problem) {
      CHECK(std::string(problem.what()).starts_with(file.string()));
    }
  };
  for (std::size_t k = 0; k < good.size(); k += 3) {
    std::string changed = good;
    changed[k] = static_cast<char>(changed[k] ^ 0xff);
    read_changed(changed);
  }
  for (std::size_t length = 0; length < good.size(); length += 17) read_changed(good.substr(0, length));
  CHECK_THROWS_AS(read_vtp(scratch.path() / "none.vtp"), BadInput);
}

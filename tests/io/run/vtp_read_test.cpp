// SPDX-License-Identifier: GPL-3.0-or-later
// Our reader of snapshots gives back what both writers have written, and refuses damaged files.
#include "core/base/errors.hpp"
#include "io/files/base64.hpp"
#include "io/run/poly_data.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <array>
#include <fstream>
#include <sstream>

using namespace gyro;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

constexpr std::array<unsigned char, 18> zlib_of_three_floats{
    0x78, 0x9c, 0x63, 0x60, 0x68, 0xb0, 0x67, 0x60, 0x60,
    0x70, 0x00, 0x22, 0x07, 0x00, 0x09, 0x43, 0x01, 0x80};  ///< 1, 2, 3

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

std::string text_of(const std::filesystem::path& file) {
  std::stringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Why the text is refused as a snapshot; empty if it is read.
std::string refusal(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  try {
    read_vtp(file);
  } catch (const BadInput& problem) {
    CHECK_THAT(problem.what(), StartsWith(file.string()));
    return problem.what();
  }
  return {};
}

std::string array_text(const std::vector<std::uint64_t>& header, const std::string& blocks) {
  return base64({reinterpret_cast<const char*>(header.data()), header.size() * sizeof(std::uint64_t)}) + base64(blocks);
}

/// A snapshot with this text as the array of its points.
std::string snapshot_of(const std::string& array) {
  return "<VTKFile type=\"PolyData\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"><Points>"
         "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"binary\">" +
         array + "</DataArray></Points></VTKFile>";
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
  for (const auto write : {write_vtp, write_vtp_plain}) {
    write(file, sample(50));
    const std::string good = text_of(file);
    for (std::size_t k = 0; k < good.size(); k += 3) {
      std::string changed = good;
      changed[k] = static_cast<char>(changed[k] ^ (k % 2 == 0 ? 0xff : 1));
      std::ofstream(file, std::ios::binary) << changed;
      try {
        read_vtp(file);
      } catch (const BadInput& problem) {
        CHECK_THAT(problem.what(), StartsWith(file.string()));
      }
    }
    const std::size_t end = good.rfind('>');
    for (std::size_t length = 0; length <= end; length += 17)
      CHECK_THAT(refusal(file, good.substr(0, length)), Contains("is damaged"));
    CHECK_THAT(refusal(file, good.substr(0, end)), Contains("cut off"));
  }
  CHECK_THROWS_AS(read_vtp(scratch.path() / "none.vtp"), BadInput);
}

TEST_CASE("The array of a snapshot must have the sizes that its header says, which are checked before room is made") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "a.vtp";
  const std::string block(reinterpret_cast<const char*>(zlib_of_three_floats.data()), zlib_of_three_floats.size());
  const std::uint64_t length = block.size(), much = std::uint64_t{1} << 61;
  std::ofstream(file) << snapshot_of(array_text({1, 12, 0, length}, block));
  CHECK(read_vtp(file).positions == std::vector<float>{1, 2, 3});
  std::ofstream(file) << snapshot_of(" \t\r\n" + array_text({2, 12, 12, length, length}, block + block) + "\n ");
  CHECK(read_vtp(file).positions == std::vector<float>{1, 2, 3, 1, 2, 3});
  const auto refused = [&](const std::string& text) { return refusal(file, snapshot_of(text)); };
  CHECK_THAT(refused(array_text({much, 12, 0, length}, block)), Contains("cut off"));
  CHECK_THAT(refused(array_text({1000, 12, 0, length}, block)), Contains("cut off"));
  CHECK_THAT(refused(array_text({1, much, 0, length}, block)), Contains("too short"));
  CHECK_THAT(refused(array_text({1, 12, much, length}, block)), Contains("wrong header"));
  CHECK_THAT(refused(array_text({1, 0, 0, length}, block)), Contains("wrong header"));
  CHECK_THAT(refused(array_text({1, 12, 0, much}, block)), Contains("cut off"));
  CHECK_THAT(refused(array_text({1, 12, 0, length + 1}, block)), Contains("cut off"));
  CHECK_THAT(refused(array_text({1, 16, 0, length}, block)), Contains("cannot be decompressed"));
  CHECK_THAT(refused(array_text({1, 8, 0, length}, block)), Contains("cannot be decompressed"));
  CHECK_THAT(refused(array_text({1, 12, 0, length}, block + "?")), Contains("behind its last block"));
  CHECK_THAT(refused(array_text({0, 12, 0}, block)), Contains("behind its last block"));
  CHECK_THAT(refused(array_text({1, 12}, block)), Contains("no base64"));
  CHECK_THAT(refused(""), Contains("cut off"));
  CHECK_THAT(refused("1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16"), Contains("no base64"));
}

TEST_CASE("A snapshot of another form is refused with the reason") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "a.vtp";
  write_vtp_plain(file, sample(3));
  const std::string good = text_of(file);
  const auto with = [&](const std::string& old, const std::string& replacement) {
    std::string text = good;
    return text.replace(text.find(old), old.size(), replacement);
  };
  CHECK_THAT(refusal(file, with("</VTKFile>", "<AppendedData encoding=\"raw\">_")),
             Contains("earlier gyrosim") && !Contains("damaged"));
  CHECK_THAT(refusal(file, with("\"PolyData\"", "\"ImageData\"")), Contains("no VTK PolyData"));
  CHECK_THAT(refusal(file, with("UInt64", "UInt32")), Contains("headers of UInt64"));
  CHECK_THAT(refusal(file, with("vtkZLib", "vtkLZ4")), Contains("compressed by zlib"));
  CHECK_THAT(refusal(file, with("format=\"binary\"", "format=\"ascii\"")), Contains("not in binary form"));
  CHECK_THAT(refusal(file, with("NumberOfComponents=\"1\" format", "NumberOfComponents=\"0\" format")),
             Contains("number of components"));
  CHECK_THAT(refusal(file, "{}"), Contains("no VTK PolyData"));
}

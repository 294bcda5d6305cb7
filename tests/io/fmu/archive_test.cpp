// SPDX-License-Identifier: GPL-3.0-or-later
// Archives are read and written, and an archive that could write outside its folder is refused as a whole.
#include "io/fmu/archive.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <sys/stat.h>
#include <zip.h>
#include <fstream>
#include <iterator>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("An archive reads back as it was written, and the same entries give the same bytes") {
  const ScratchDirectory place;
  const std::string all_bytes = [] {
    std::string text(70'000, 'x');
    for (std::size_t k = 0; k < text.size(); ++k) text[k] = static_cast<char>(k * k % 251);
    return text;
  }();
  for (const char* name : {"a.zip", "b.zip"})
    write_archive(place.path() / name, {{"one.txt", "1"}, {"deep/er/two.bin", all_bytes}, {"empty", ""}});
  CHECK(bytes_of(place.path() / "a.zip") == bytes_of(place.path() / "b.zip"));
  const Archive archive(place.path() / "a.zip");
  CHECK(archive.names() == std::vector<std::string>{"one.txt", "deep/er/two.bin", "empty"});
  CHECK(archive.read("deep/er/two.bin") == all_bytes);
  CHECK(archive.read("empty").empty());
  CHECK_THROWS_WITH(archive.read("three"), Contains("has no three"));
  const TemporaryFolder folder;
  archive.unpack("deep/", folder.path());
  CHECK(bytes_of(folder.path() / "deep/er/two.bin") == all_bytes);
  CHECK(!fs::exists(folder.path() / "one.txt"));
}

TEST_CASE("An archive with an entry outside its own folder is refused") {
  const ScratchDirectory place;
  const fs::path file = place.path() / "evil.zip";
  const auto [name, reason] = GENERATE(table<std::string, std::string>({
      {"/etc/passwd", "absolute path"},
      {"C:/windows", "absolute path"},
      {"../outside", "leaves"},
      {"resources/../../outside", "leaves"},
      {"resources\\..\\outside", "backslash"},
  }));
  write_archive(file, {{"modelDescription.xml", "x"}, {name, "y"}});
  CHECK_THROWS_WITH(Archive(file), Contains(name) && Contains(reason) && Contains("; only plain files"));
  CHECK_THROWS_AS(Archive(file), BadInput);
}

TEST_CASE("Archives with links, duplicates or damage, and files that are not archives, are refused") {
  const ScratchDirectory place;
  const fs::path file = place.path() / "bad.fmu";
  SECTION("link") {
    int code = 0;
    zip_t* zip = zip_open(file.c_str(), ZIP_CREATE, &code);
    const auto entry = zip_file_add(zip, "resources/link", zip_source_buffer(zip, "/etc", 4, 0), 0);
    zip_file_set_external_attributes(zip, static_cast<zip_uint64_t>(entry), 0, ZIP_OPSYS_UNIX,
                                     zip_uint32_t{S_IFLNK | 0777} << 16);
    REQUIRE(zip_close(zip) == 0);
    CHECK_THROWS_WITH(Archive(file), Contains("resources/link") && Contains("is a link"));
  }
  SECTION("twice") {
    write_archive(file, {{"a/b", "1"}, {"a/./b", "2"}});
    CHECK_THROWS_WITH(Archive(file), Contains("occurs twice"));
  }
  SECTION("text") {
    std::ofstream(file) << "no archive at all";
    CHECK_THROWS_WITH(Archive(file), Contains("is not a readable zip archive"));
  }
  SECTION("damaged") {
    write_archive(file, {{"a", std::string(5000, 'a') + "b"}});
    std::string bytes = bytes_of(file);
    bytes[36] = static_cast<char>(bytes[36] ^ 0x55);  // in the middle of the packed data
    std::ofstream(file, std::ios::binary) << bytes;
    CHECK_THROWS_WITH(Archive(file).read("a"), Contains("damaged"));
  }
}

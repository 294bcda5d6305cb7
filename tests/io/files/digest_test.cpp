// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/digest.hpp"
#include "core/base/errors.hpp"
#include "io/files/seal.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <fstream>
#include <iterator>

using namespace gyro;

namespace {

void write(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("The digest is the 128-bit XXH3 hash", "[digest]") {
  // The hash of no bytes, as `xxhsum -H2` of Debian's package xxhash prints it.
  CHECK(digest_of("") == "99aa06d3014798d86001c324468d497f");
  Digest in_pieces;
  in_pieces.update(std::string_view("gyratory "));
  in_pieces.update(std::string_view("crusher"));
  CHECK(in_pieces.hex() == digest_of("gyratory crusher"));
  CHECK(digest_of(std::string(4096, '\0')) != digest_of(std::string(4096, '\xff')));
}

TEST_CASE("The digest of a file that cannot be read is refused", "[digest]") {
  const ScratchDirectory folder;
  CHECK_THROWS_AS(digest_of_file(folder.path() / "none"), BadInput);
  CHECK_THROWS_AS(digest_of_file("/proc/self/mem"), BadInput);  // reading its first byte is an input/output error
  CHECK_THROWS_AS(digest_of_file(folder.path()), BadInput);
}

TEST_CASE("A sealed file is recognised, and any changed, missing or added byte breaks the seal", "[digest]") {
  const ScratchDirectory folder;
  const auto file = folder.path() / "some.h5";
  std::string content(3'000'000, '\0');  // more than one piece
  for (std::size_t k = 0; k < content.size(); k += 7) content[k] = static_cast<char>(k);
  write(file, content);
  CHECK_FALSE(is_sealed(file));
  seal(file);
  CHECK(is_sealed(file));
  const std::string sealed = read(file);
  CHECK(sealed.substr(0, content.size()) == content);
  for (const std::size_t at : {std::size_t{0}, std::size_t{1 << 20}, content.size() - 1, sealed.size() - 1}) {
    std::string changed = sealed;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    write(file, changed);
    CHECK_FALSE(is_sealed(file));
  }
  write(file, sealed.substr(0, sealed.size() - 1));
  CHECK_FALSE(is_sealed(file));
  write(file, sealed + "x");
  CHECK_FALSE(is_sealed(file));
  write(file, "short");
  CHECK_FALSE(is_sealed(file));
  CHECK_FALSE(is_sealed(folder.path() / "none"));
}

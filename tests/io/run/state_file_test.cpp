// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/state_file.hpp"

#include "io/files/seal.hpp"
#include "io/hdf5/hdf5.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

using namespace gyro;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// A row of three numbers.
struct Place {
  float x, y, z;
};

}  // namespace

template <>
struct gyro::RowOf<Place> : gyro::MadeOf<float> {};

namespace {

SavedState some_state() {
  constexpr double tiny = std::numeric_limits<double>::denorm_min(), nan = std::numeric_limits<double>::quiet_NaN();
  SavedState s;
  s.put("numbers/double", std::vector<double>{1.0 / 3, -0.0, tiny, nan, 1e308, -INFINITY});
  s.put("numbers/float", std::vector<float>{1.0F / 3, -0.0F, 1e-45F, 3e38F});
  s.put("numbers/int64", std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), (1LL << 60) + 1});
  s.put("numbers/int32", std::vector<std::int32_t>{-1, 0, std::numeric_limits<std::int32_t>::min()});
  s.put("numbers/uint32", std::vector<std::uint32_t>{0, 4294967295U});
  s.put("numbers/none", std::vector<double>{});
  s.put("rows/deep/place", std::vector<Place>{{1, 2, 3}, {4, 5, 1e-40F}});
  s.put("rows/none", std::vector<Place>{});
  s.put_text("text", std::string("a: \"\xc3\xa4\"\n\0b", 10));
  return s;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const SavedColumn& a, const SavedColumn& b) {
  return a.width == b.width && a.numbers.index() == b.numbers.index() &&
         std::visit(
             [&](const auto& numbers) {
               return same_bits(numbers, std::get<std::remove_cvref_t<decltype(numbers)>>(b.numbers));
             },
             a.numbers);
}

bool same(const SavedState& a, const SavedState& b) {
  return std::equal(a.columns().begin(), a.columns().end(), b.columns().begin(), b.columns().end(),
                    [](const auto& x, const auto& y) { return x.first == y.first && same(x.second, y.second); });
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void put_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("A state reads back from its file to the bit") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "checkpoint.h5";
  write_state(file, some_state());
  const SavedState back = read_state(file);
  CHECK(same(back, some_state()));
  CHECK(back.get<Place>("rows/deep/place", 2)[1].z == 1e-40F);
  CHECK(back.get_text("text") == some_state().get_text("text"));
  std::vector<double> many(300000);
  for (std::size_t k = 0; k < many.size(); ++k) many[k] = std::sqrt(static_cast<double>(k));
  SavedState large;
  large.put("more/than/a/chunk", many);
  write_state(file, large);
  CHECK(same(read_state(file), large));
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path()), {}) == 1);
}

TEST_CASE("A state file with any byte changed is refused") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "checkpoint.h5", damaged = scratch.path() / "damaged.h5";
  SavedState state;
  state.put("numbers/double", std::vector<double>{1, 2, 3, 4, 5});
  state.put_text("case/resolved", "case: {seed: 42}");
  write_state(file, state);
  const std::string whole = bytes_of(file);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    std::string bytes = whole;
    bytes[k] = static_cast<char>(bytes[k] ^ 0x10);
    put_bytes(damaged, bytes);
    CAPTURE(k);
    REQUIRE_THROWS_WITH(read_state(damaged), StartsWith(damaged.string()) && Contains("damaged"));
  }
}

TEST_CASE("A state file in which a part was replaced by zeros is refused") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "checkpoint.h5";
  SavedState state;
  state.put("bonds/strength", std::vector<double>(100'000, 1.5));
  write_state(file, state);
  std::string bytes = bytes_of(file);
  std::fill_n(bytes.begin() + 100'000, 4096, '\0');
  put_bytes(file, bytes);
  CHECK_THROWS_AS(read_state(file), BadInput);
}

TEST_CASE("A file that is cut off, empty, missing, not a state or of another format is refused") {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "checkpoint.h5";
  CHECK_THROWS_WITH(read_state(file), StartsWith(file.string()) && Contains("no such checkpoint"));
  write_state(file, some_state());
  const std::string whole = bytes_of(file);
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    put_bytes(file, whole.substr(0, length));
    CAPTURE(length);
    CHECK_THROWS_WITH(read_state(file), StartsWith(file.string()) && Contains("damaged"));
  }
  put_bytes(file, "no HDF5 file");
  CHECK_THROWS_AS(read_state(file), BadInput);
  hdf5::File::create(file).close();
  CHECK_THROWS_AS(read_state(file), BadInput);
  hdf5::File other = hdf5::File::create(file);
  other.set_attribute("/", "format", state_format + 1);
  other.close();
  seal(file);
  CHECK_THROWS_WITH(read_state(file), Contains("has format " + std::to_string(state_format + 1)));
}

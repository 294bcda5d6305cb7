// SPDX-License-Identifier: GPL-3.0-or-later
// The operations of the CPU executor against the standard library.
#include "tests/catch.hpp"

#include "core/exec/cpu.hpp"
#include "core/math/random.hpp"

#include <cstring>
#include <limits>

using namespace gyro;

namespace {

std::uint64_t random_bits(std::uint64_t k) {
  const auto half = [k](std::uint32_t draw) {
    return static_cast<std::uint64_t>(uniform(5, Stream::place, k, draw) * 4294967296.0);
  };
  return half(0) << 32 | half(1);
}

/// Keys with their places as values, sorted by the executor and by the library.
void check_sort(const std::vector<std::uint64_t>& keys) {
  std::vector<Index> places(keys.size());
  std::iota(places.begin(), places.end(), 0);
  std::vector<Index> expected = places;
  std::stable_sort(expected.begin(), expected.end(), [&](Index a, Index b) {
    return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)];
  });
  Cpu cpu(1);
  std::vector<std::uint64_t> sorted = keys;
  cpu.sort_by_key(sorted, places);
  CHECK(places == expected);
  CHECK(std::is_sorted(sorted.begin(), sorted.end()));
  for (std::size_t k = 0; k < sorted.size(); ++k) REQUIRE(sorted[k] == keys[static_cast<std::size_t>(places[k])]);
}

struct CountCalls {
  std::int32_t* calls;
  void operator()(Index i) const { ++calls[i]; }
};

/// Numbers whose sum depends on the order of addition.
struct Uneven {
  double operator()(Index i) const {
    const double x = uniform(6, Stream::place, static_cast<std::uint64_t>(i), 0) - 0.5;
    return i % 7 == 0 ? 1e12 * x : x;
  }
};

struct Largest {
  Index value = -1;
  friend Largest operator+(const Largest& a, const Largest& b) { return {std::max(a.value, b.value)}; }
};
struct LargestOf {
  Largest operator()(Index i) const { return {(i * 37) % 1009}; }
};

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST_CASE("for_each calls every index once", "[exec]") {
  const int threads = GENERATE(1, 2, 5);
  const Index n = GENERATE(0, 1, 127, 128, 129, 1000, 4097);
  Cpu cpu(threads);
  std::vector<std::int32_t> calls(static_cast<std::size_t>(n) + 1, 0);
  cpu.for_each("test", n, CountCalls{calls.data()});
  CHECK(std::count(calls.begin(), calls.end() - 1, 1) == n);
  CHECK(calls.back() == 0);
}

TEST_CASE("A reduction adds in the same order for any number of threads", "[exec]") {
  const Index n = GENERATE(1, 1023, 1024, 1025, 5000, 100'000);
  const double one = Cpu(1).reduce<double>("test", n, Uneven{});
  for (const int threads : {2, 3, 7, 16}) CHECK(same_bits(one, Cpu(threads).reduce<double>("test", n, Uneven{})));
  double chunks = 0;  // as the GPU adds: chunks of 1024, then the chunks
  for (Index first = 0; first < n; first += 1024) {
    double sum = 0;
    for (Index i = first; i < std::min(n, first + 1024); ++i) sum += Uneven{}(i);
    chunks += sum;
  }
  CHECK(same_bits(one, chunks));
  if (n == 100'000) {  // checks that the order matters, otherwise this test could not fail
    double straight = 0;
    for (Index i = 0; i < n; ++i) straight += Uneven{}(i);
    CHECK_FALSE(same_bits(one, straight));
  }
}

TEST_CASE("A reduction begins with the neutral element, and works for other sums", "[exec]") {
  Cpu cpu(3);
  CHECK(cpu.reduce<double>("test", 0, Uneven{}) == 0);
  CHECK(cpu.reduce<Largest>("test", 0, LargestOf{}).value == -1);
  CHECK(cpu.reduce<Largest>("test", 5000, LargestOf{}).value == 1008);
}

TEST_CASE("An exclusive scan gives the beginning of each row and the total", "[exec]") {
  const std::size_t n = GENERATE(std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{1000});
  std::vector<Index> counts(n + 1);
  for (std::size_t k = 0; k < n; ++k) counts[k] = static_cast<Index>(random_bits(k) % 9);
  counts[n] = 123;  // is not counted
  std::vector<Index> expected(n + 1);
  std::exclusive_scan(counts.begin(), counts.end(), expected.begin(), 0);
  CHECK(Cpu::exclusive_scan(static_cast<Index>(n), counts.data()) == expected.back());
  CHECK(counts == expected);
}

TEST_CASE("The sort orders by all bytes of the keys", "[exec]") {
  std::vector<std::uint64_t> keys;
  for (std::uint64_t k = 0; k < 3000; ++k) keys.push_back(random_bits(k));
  keys.push_back(0);
  keys.push_back(std::numeric_limits<std::uint64_t>::max());
  check_sort(keys);
  for (int byte = 0; byte < 8; ++byte) {  // keys that differ in one byte only: the other passes are skipped
    std::vector<std::uint64_t> one_byte;
    for (std::uint64_t k = 0; k < 700; ++k) one_byte.push_back(0x0101010101010101u ^ random_bits(k) % 256 << 8 * byte);
    check_sort(one_byte);
  }
}

TEST_CASE("The sort keeps the order of equal keys", "[exec]") {
  std::vector<std::uint64_t> keys;
  for (std::uint64_t k = 0; k < 5000; ++k) keys.push_back(random_bits(k) % 13 * 0x100000001u);
  check_sort(keys);
  check_sort(std::vector<std::uint64_t>(300, 42));
}

TEST_CASE("The sort works for short, sorted and reversed keys", "[exec]") {
  check_sort({});
  check_sort({7});
  check_sort({9, 9});
  check_sort({2, 1});
  std::vector<std::uint64_t> keys(1000);
  std::iota(keys.begin(), keys.end(), 1u << 15);
  check_sort(keys);
  std::reverse(keys.begin(), keys.end());
  check_sort(keys);
}

TEST_CASE("A sort after a longer one is not disturbed by it", "[exec]") {
  Cpu cpu(1);
  for (const std::size_t n : {2000, 3, 500}) {
    std::vector<std::uint64_t> keys(n);
    std::vector<Index> values(n);
    for (std::size_t k = 0; k < n; ++k) keys[k] = random_bits(k + n), values[k] = static_cast<Index>(k);
    std::vector<std::uint64_t> expected = keys;
    std::sort(expected.begin(), expected.end());
    cpu.sort_by_key(keys, values);
    CHECK(keys == expected);
    CHECK(values.size() == n);
  }
}

TEST_CASE("keep shortens a buffer to the elements named", "[exec]") {
  std::vector<double> buffer{10, 11, 12, 13, 14, 15};
  Cpu::keep(buffer, {0, 2, none, 5});
  CHECK(buffer == std::vector<double>{10, 12, 0, 15});
  Cpu::keep(buffer, {0, 1, 2, 3});
  CHECK(buffer == std::vector<double>{10, 12, 0, 15});
  Cpu::keep(buffer, {});
  CHECK(buffer.empty());
}

TEST_CASE("append adds at the end of a buffer, resize adds zeros", "[exec]") {
  std::vector<Index> buffer;
  Cpu::append(buffer, {1, 2});
  Cpu::append(buffer, {});
  Cpu::append(buffer, {3});
  CHECK(Cpu::host(buffer) == std::vector<Index>{1, 2, 3});
  buffer.resize(1);
  buffer.resize(3);
  CHECK(buffer == std::vector<Index>{1, 0, 0});
}

TEST_CASE("Buffers take the memory that they need, not twice as much", "[exec]") {
  std::vector<Index> buffer, rows(1000, 7);
  const Index* const there = rows.data();
  Cpu::append(buffer, std::move(rows));
  CHECK(buffer.data() == there);  // an empty buffer takes the rows as they are
  Cpu::append(buffer, std::vector<Index>(100, 8));
  CHECK(buffer.size() == 1100);
  CHECK(buffer.front() == 7);
  CHECK(buffer.back() == 8);
  CHECK(buffer.capacity() <= 1100 + 1100 / 8);
  Cpu::renew(buffer, 2000);
  CHECK(buffer.size() == 2000);
  CHECK(buffer.capacity() <= 2000 + 2000 / 8);
  const Index* const room = buffer.data();
  Cpu::renew(buffer, 10);
  Cpu::renew(buffer, 2100);
  CHECK(buffer.size() == 2100);
  CHECK(buffer.data() == room);
  Cpu::release(buffer);
  CHECK(buffer.capacity() == 0);
}

TEST_CASE("A scratch of any size can be written and read", "[exec]") {
  Cpu::Scratch<Index> scratch;
  CHECK(scratch.size() == 0);
  for (const std::size_t size : {5U, 3U, 100U}) {
    scratch.resize(size);
    REQUIRE(scratch.size() == size);
    std::iota(scratch.data(), scratch.data() + size, 0);
    CHECK(Cpu::host(scratch).size() == size);
    CHECK(Cpu::host(scratch)[size - 1] == static_cast<Index>(size) - 1);
  }
}

TEST_CASE("The timer sums the seconds of each phase, in order of first use", "[exec]") {
  Cpu cpu(2);
  std::vector<std::int32_t> calls(10, 0);
  const CountCalls count{calls.data()};
  cpu.for_each("first", 10, count);
  cpu.for_each("second", 10, count);
  cpu.for_each("first", 10, count);
  const auto seconds = cpu.timer().seconds();
  REQUIRE(seconds.size() == 2);
  CHECK(seconds[0].first == "first");
  CHECK(seconds[1].first == "second");
  CHECK(seconds[0].second > 0);
}

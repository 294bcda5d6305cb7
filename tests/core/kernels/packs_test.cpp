// SPDX-License-Identifier: GPL-3.0-or-later
// Packs of either width read and write the same as one lane, whatever the processor's own width is.
#include "core/kernels/bond_pack.hpp"
#include "core/kernels/pair_pack.hpp"
#include "tests/catch.hpp"

#include <vector>

using namespace gyro;

namespace {

std::vector<Motion> motions() {
  std::vector<Motion> rows;
  for (int k = 0; k < 40; ++k) rows.push_back({{k + 0.1, 100 * k + 0.2, -k - 0.3}, 1000.0 * k + 0.4});
  return rows;
}

/// Rows in an order without a pattern.
template <class Rows, int N>
Rows scattered(int first) {
  Rows rows;
  for (int k = 0; k < N; ++k) rows.v[k] = (first + 17 * k) % 40;
  return rows;
}

template <int N, class T>
void check_vectors() {
  CAPTURE(N, sizeof(T));
  const std::vector<Motion> rows = motions();
  const auto a = scattered<Pack<Index, N>, N>(3), b = scattered<Pack<Index, N>, N>(11);
  const PackLanes<N> lanes{0};
  const Vec3<Pack<T, N>> v = lanes.template vector<T>(rows.data(), a),
                         d = lanes.template difference<T>(rows.data(), a, b);
  for (int k = 0; k < N; ++k) {
    const OneLane one{0};
    const Vec3<T> v1 = one.vector<T>(rows.data(), a.v[k]), d1 = one.difference<T>(rows.data(), a.v[k], b.v[k]);
    CHECK((v.x[k] == v1.x && v.y[k] == v1.y && v.z[k] == v1.z));
    CHECK((d.x[k] == d1.x && d.y[k] == d1.y && d.z[k] == d1.z));
  }
}

template <int N>
void check_rows() {
  CAPTURE(N);
  const std::vector<Motion> rows = motions();
  const std::vector<Index> numbers{5, 0, 31, 2, 39, 17, 8, 23};
  const PackOfPairs<N> lanes{numbers.data()};
  const auto particle = scattered<RowNumbers<N>, N>(7);
  const ParticleRow<Pack<double, N>> row = lanes.row(rows.data(), particle);
  for (int k = 0; k < N; ++k) {
    const ParticleRow<double> one = row_of(rows[static_cast<std::size_t>(particle.v[k])]);
    CHECK((row.vector.x[k] == one.vector.x && row.vector.y[k] == one.vector.y && row.vector.z[k] == one.vector.z));
    CHECK(row.number[k] == one.number);
  }
}

template <int N, class T>
void check_structs() {
  CAPTURE(N, sizeof(T));
  const std::vector<Index> numbers{5, 0, 31, 2, 39, 17, 8, 23};
  const PackOfPairs<N> lanes{numbers.data()};
  std::vector<ContactHistory<T>> from(40), to(40);
  for (std::size_t k = 0; k < from.size(); ++k) {
    const T x = static_cast<T>(k);
    from[k] = {{x, x + 100, x + 200}, x + 300, {x + 400, x + 500, x + 600}};
  }
  lanes.store(to.data(), lanes.load(from.data()));
  std::vector<EndLoad<T>> ends(40);
  const auto h = lanes.load(from.data());
  const auto at = scattered<RowNumbers<N>, N>(2);
  lanes.store_at(ends.data(), at, EndLoad<Pack<T, N>>{h.elastic, h.drag, h.overlap, h.overlap + h.overlap});
  std::vector<bool> written(40, false), loaded(40, false);
  for (int k = 0; k < N; ++k) {
    const ContactHistory<T>& f = from[static_cast<std::size_t>(numbers[static_cast<std::size_t>(k)])];
    const ContactHistory<T>& t = to[static_cast<std::size_t>(numbers[static_cast<std::size_t>(k)])];
    written[static_cast<std::size_t>(numbers[static_cast<std::size_t>(k)])] = true;
    CHECK((t.elastic.x == f.elastic.x && t.elastic.z == f.elastic.z && t.overlap == f.overlap && t.drag.y == f.drag.y));
    const EndLoad<T>& e = ends[static_cast<std::size_t>(at.v[k])];
    loaded[static_cast<std::size_t>(at.v[k])] = true;
    CHECK((e.force.y == f.elastic.y && e.torque.x == f.drag.x && e.damped == f.overlap && e.slipped == 2 * f.overlap));
  }
  for (std::size_t k = 0; k < 40; ++k) {
    if (!written[k]) CHECK(to[k].overlap == 0);
    if (!loaded[k]) CHECK(ends[k].slipped == 0);
  }
}

}  // namespace

TEST_CASE("Two packs of pairs are joined in their order", "[kernels]") {
  const std::vector<Index> numbers{5, 0, 31, 2, 39, 17, 8, 23};
  std::vector<ContactHistory<float>> from(40);
  for (std::size_t k = 0; k < from.size(); ++k) {
    const auto x = static_cast<float>(k);
    from[k] = {{x, x + 100, x + 200}, x + 300, {x + 400, x + 500, x + 600}};
  }
  const auto both =
      joined(PackOfPairs<4>{numbers.data()}.load(from.data()), PackOfPairs<4>{numbers.data() + 4}.load(from.data()));
  for (int k = 0; k < 8; ++k) {
    const ContactHistory<float>& one = from[static_cast<std::size_t>(numbers[static_cast<std::size_t>(k)])];
    CHECK((both.elastic.x[k] == one.elastic.x && both.elastic.z[k] == one.elastic.z && both.overlap[k] == one.overlap &&
           both.drag.y[k] == one.drag.y && both.drag.z[k] == one.drag.z));
  }
}

namespace {

template <int N>
void check_ends() {
  CAPTURE(N);
  const std::vector<Index> numbers{5, 0, 31, 2, 39, 17, 8, 23};
  std::vector<Pair> pairs;
  for (Index k = 0; k < 40; ++k) pairs.push_back({1000 + k, 3000000 - k, -7});
  const auto [i, j] = PackOfPairs<N>{numbers.data()}.both_ends(pairs.data());
  for (int k = 0; k < N; ++k) {
    const Pair& pair = pairs[static_cast<std::size_t>(numbers[static_cast<std::size_t>(k)])];
    CHECK((i.v[k] == pair.i && j.v[k] == pair.j));
  }
  for (std::uint32_t bits = 0; bits < 1u << N; ++bits) {  // all patterns
    std::vector<std::int8_t> flags(50, 1);
    std::vector<Index> neighbours;
    for (int k = 0; k < N; ++k) {
      neighbours.push_back(21 + k);
      flags[static_cast<std::size_t>(21 + k)] = static_cast<std::int8_t>(bits >> k & 1u);
    }
    REQUIRE(PackOfPairs<N>{neighbours.data()}.neighbour_flags(flags.data()) == bits);
  }
}

}  // namespace

TEST_CASE("Packs of four and of eight read the ends and the flags of pairs", "[kernels]") {
  check_ends<4>();
  check_ends<8>();
}

TEST_CASE("Packs of four and of eight take the rows of particles apart as one lane does", "[kernels]") {
  check_vectors<4, float>();
  check_vectors<4, double>();
  check_vectors<8, float>();
  check_vectors<8, double>();
  check_rows<4>();
  check_rows<8>();
}

TEST_CASE("Packs of four and of eight read and write the structs of pairs as one lane does", "[kernels]") {
  check_structs<4, float>();
  check_structs<4, double>();
  check_structs<8, float>();
  check_structs<8, double>();
}

namespace {

template <class To, class From, int N>
void check_casts() {
  CAPTURE(N, sizeof(To), sizeof(From));
  Pack<From, N> numbers;
  for (int k = 0; k < N; ++k) numbers.v[k] = static_cast<From>(17 * k - 30) / 7;
  const Pack<To, N> out = pack_cast<To>(numbers);
  for (int k = 0; k < N; ++k) CHECK(out[k] == static_cast<To>(numbers[k]));
}

}  // namespace

TEST_CASE("Numbers of packs of four and of eight change their type as single numbers do", "[kernels]") {
  check_casts<double, float, 4>();
  check_casts<double, float, 8>();
  check_casts<float, double, 4>();
  check_casts<float, double, 8>();
  check_casts<double, std::int32_t, 4>();
  check_casts<float, std::int32_t, 8>();
}

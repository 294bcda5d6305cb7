// SPDX-License-Identifier: GPL-3.0-or-later
// Work by blocks, with a kernel without physics.
#include "tests/catch.hpp"

#include "core/exec/cpu.hpp"

#include <atomic>

using namespace gyro;

namespace {

/// Four items in a row.
struct FourItems {
  static constexpr int count = 4;
  Index first;
};

/// One item, for the last ones of a block.
struct OneItem {
  static constexpr int count = 1;
  Index first;
};

/// Three rows, in any order.
struct ThreeRows {
  static constexpr int count = 3;
  Index first;
};

/// Blocks of rows; each item adds its number to a row of its block, after all that came before.
struct MixItems {
  using Pack = FourItems;
  using Lane = OneItem;
  using RowPack = ThreeRows;
  const std::vector<IndexRange>* block_rows;
  const std::vector<IndexRange>* block_items;
  std::uint64_t* row_values;
  std::int32_t* block_of_item;
  int max_passes;

  IndexRange rows(Index block) const { return (*block_rows)[static_cast<std::size_t>(block)]; }
  IndexRange items(Index block) const { return (*block_items)[static_cast<std::size_t>(block)]; }
  IndexRange share(Index block) const { return rows(block); }
  int passes(Index block) const { return block % 4 == 3 ? max_passes - 1 : max_passes; }
  void prepare(Index row, Index, int pass) const { row_values[row] = pass == 0 ? 1 : row_values[row] ^ 5; }
  void prepare(const ThreeRows& pack, Index block, int pass) const {
    for (Index row = pack.first; row < pack.first + ThreeRows::count; ++row) prepare(row, block, pass);
  }
  template <class Items>
  void operator()(const Items& pack, Index block, int pass) const {
    const IndexRange own = rows(block);
    for (Index item = pack.first; item < pack.first + Items::count; ++item) {
      std::uint64_t& value = row_values[own.begin + item % (own.end - own.begin)];
      value = value * 6364136223846793005u + static_cast<std::uint64_t>(item + pass);  // depends on the order
      block_of_item[item] = block;
    }
  }
};

struct Blocks {
  std::vector<IndexRange> rows, items;
  /// Blocks of 1 to 11 rows and 0 to 30 items.
  explicit Blocks(Index count) {
    Index row = 3, item = 0;
    for (Index k = 0; k < count; ++k) {
      const Index more_rows = 1 + k * 5 % 11, more_items = k * 13 % 31;
      rows.push_back({row, row + more_rows});
      items.push_back({item, item + more_items});
      row += more_rows + (k % 4 == 0);  // rows that belong to no block
      item += more_items;
    }
  }
  std::size_t row_count() const { return rows.empty() ? 4 : static_cast<std::size_t>(rows.back().end) + 1; }
  std::size_t item_count() const { return items.empty() ? 0 : static_cast<std::size_t>(items.back().end); }
};

struct Mixed {
  std::vector<std::uint64_t> rows;
  std::vector<std::int32_t> block_of_item;
};

Mixed mixed(const Blocks& blocks, int threads, int passes = 1) {
  Mixed out{std::vector<std::uint64_t>(blocks.row_count(), 77), std::vector<std::int32_t>(blocks.item_count(), none)};
  Cpu cpu(threads);
  cpu.for_each_block("mix", {static_cast<Index>(blocks.rows.size()), 1},
                     MixItems{&blocks.rows, &blocks.items, out.rows.data(), out.block_of_item.data(), passes});
  return out;
}

}  // namespace

TEST_CASE("Every block is processed once, its items in order, for any number of threads", "[exec]") {
  const Index count = GENERATE(0, 1, 2, 7, 300);
  const int passes = GENERATE(2, 3);
  const Blocks blocks(count);
  const Mixed one = mixed(blocks, 1, passes);
  for (std::size_t k = 0; k < blocks.items.size(); ++k)
    for (Index item = blocks.items[k].begin; item < blocks.items[k].end; ++item)
      REQUIRE(one.block_of_item[static_cast<std::size_t>(item)] == static_cast<Index>(k));
  for (const int threads : {2, 3, 8, 20}) {
    const Mixed other = mixed(blocks, threads, passes);
    CHECK(other.rows == one.rows);
    CHECK(other.block_of_item == one.block_of_item);
  }
}

TEST_CASE("A second pass begins with what the first one has left", "[exec]") {
  const Blocks blocks(3);
  const Mixed once = mixed(blocks, 1, 1), twice = mixed(blocks, 1, 2);
  for (std::size_t k = 0; k < blocks.rows.size(); ++k) {
    std::vector<std::uint64_t> values;
    const Index first = blocks.rows[k].begin, count = blocks.rows[k].end - first;
    for (Index row = 0; row < count; ++row) values.push_back(once.rows[static_cast<std::size_t>(first + row)] ^ 5);
    for (Index item = blocks.items[k].begin; item < blocks.items[k].end; ++item) {
      std::uint64_t& value = values[static_cast<std::size_t>(item % count)];
      value = value * 6364136223846793005u + static_cast<std::uint64_t>(item + 1);
    }
    for (Index row = 0; row < count; ++row)
      CHECK(twice.rows[static_cast<std::size_t>(first + row)] == values[static_cast<std::size_t>(row)]);
  }
}

namespace {

/// Counts how often each item is worked on. A kernel without rows.
struct CountItems {
  using Pack = FourItems;
  using Lane = OneItem;
  const std::vector<Index>* begin;
  std::atomic<int>* visits;

  IndexRange items(Index k) const {
    return {(*begin)[static_cast<std::size_t>(k)], (*begin)[static_cast<std::size_t>(k) + 1]};
  }
  IndexRange share(Index k) const { return items(k); }
  static int passes(Index) { return 2; }
  template <class Items>
  void operator()(const Items& pack, Index, int) const {
    for (Index item = pack.first; item < pack.first + Items::count; ++item) ++visits[item];
  }
};

}  // namespace

TEST_CASE("Blocks without rows, some of them empty, are shared by their items", "[exec]") {
  const std::vector<Index> begin{3, 4, 4, 21, 120, 1000, 1003};
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> visits(1003);
    Cpu cpu(threads);
    cpu.for_each_block("count", {static_cast<Index>(begin.size()) - 1, 1}, CountItems{&begin, visits.data()});
    for (std::size_t item = 0; item < visits.size(); ++item) CHECK(visits[item] == (item >= 3 ? 2 : 0));
  }
}

namespace {

template <int N>
struct Picked {
  static constexpr int count = N;
  const Index* n;
  Index operator[](int k) const { return n[k]; }
};
template <>
struct Picked<1> {
  static constexpr int count = 1;
  Index n;
  Index operator[](int) const { return n; }
};

/// What is picked: in no pattern that fills packs evenly.
bool wanted(Index i) {
  return i % 3 == 1 || i % 7 == 0;
}

/// Counts how often each number is looked at and worked on; some are picked, or all.
template <int N>
struct CountPicked {
  using Lane = Picked<1>;
  using Pack = Picked<N>;
  int* looks;
  int* works;
  bool all;

  bool pick(Index i) const {
    ++looks[i];
    return all || wanted(i);
  }
  template <class Lanes>
  void operator()(const Lanes& lanes) const {
    for (int k = 0; k < Lanes::count; ++k) ++works[lanes[k]];
  }
};

template <int N>
struct CountPickedSingly : CountPicked<N> {};

/// The same; packs of neighbours are looked at together, `looks` of them.
template <int N, int looks>
struct CountLookedAt : CountPicked<N> {
  using PickPack = Picked<looks>;
  std::uint32_t pick_each(const Picked<looks>& run) const {
    std::uint32_t bits = 0;
    for (int k = 0; k < looks; ++k) {
      CHECK(run[k] == run[0] + k);
      bits |= (this->pick(run[k]) ? 1u : 0u) << k;
    }
    return bits;
  }
};

template <int N>
struct CountPickedTogether : CountLookedAt<N, N> {};
template <int N>
struct CountPickedByFour : CountLookedAt<N, 4> {};

template <int N, template <int> class Kernel>
void check_picked(Index n, int threads, bool all) {
  std::vector<int> looks(static_cast<std::size_t>(n)), works(looks);
  Cpu cpu(threads);
  cpu.for_each_picked("pick", n, Kernel<N>{looks.data(), works.data(), all});
  for (std::size_t i = 0; i < looks.size(); ++i) {
    CAPTURE(N, n, threads, all, i);
    REQUIRE(looks[i] == 1);
    REQUIRE(works[i] == (all || wanted(static_cast<Index>(i)) ? 1 : 0));
  }
}

}  // namespace

TEST_CASE("What is picked is worked on once, in packs of any width", "[exec]") {
  const Index n = GENERATE(0, 1, 7, 63, 64, 65, 129, 191, 192, 1000, 5003);
  const int threads = GENERATE(1, 2, 7);
  for (const bool all : {true, false}) {
    check_picked<1, CountPickedSingly>(n, threads, all);
    check_picked<4, CountPickedSingly>(n, threads, all);
    check_picked<8, CountPickedSingly>(n, threads, all);
    check_picked<4, CountPickedTogether>(n, threads, all);
    check_picked<8, CountPickedTogether>(n, threads, all);
    check_picked<8, CountPickedByFour>(n, threads, all);
  }
}

TEST_CASE("Rows of all blocks are prepared, also of blocks without items, and other rows are unchanged", "[exec]") {
  const Blocks blocks(9);
  const Mixed out = mixed(blocks, 2);
  std::vector<bool> owned(blocks.row_count(), false);
  for (std::size_t k = 0; k < blocks.rows.size(); ++k)
    for (Index row = blocks.rows[k].begin; row < blocks.rows[k].end; ++row) {
      owned[static_cast<std::size_t>(row)] = true;
      if (blocks.items[k].begin == blocks.items[k].end) CHECK(out.rows[static_cast<std::size_t>(row)] == 1);
    }
  for (std::size_t row = 0; row < owned.size(); ++row)
    if (!owned[row]) CHECK(out.rows[row] == 77);
}

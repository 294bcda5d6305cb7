// SPDX-License-Identifier: GPL-3.0-or-later
// Work by blocks, with a kernel without physics.
#include "tests/catch.hpp"

#include "core/exec/cpu.hpp"

using namespace gyro;

namespace {

/// Four items in a row.
struct FourItems {
  static constexpr int count = 4;
  Index first;
};

/// Blocks of rows; each item adds its number to a row of its block, after all that came before.
struct MixItems {
  using Pack = FourItems;
  const std::vector<IndexRange>* block_rows;
  const std::vector<IndexRange>* block_items;
  std::uint64_t* row_values;
  std::int32_t* block_of_item;

  IndexRange rows(Index block) const { return (*block_rows)[static_cast<std::size_t>(block)]; }
  IndexRange items(Index block) const { return (*block_items)[static_cast<std::size_t>(block)]; }
  void clear(Index row) const { row_values[row] = 1; }
  void operator()(const FourItems& pack, Index block) const {
    const IndexRange own = rows(block);
    for (Index item = pack.first; item < pack.first + FourItems::count; ++item) {
      std::uint64_t& value = row_values[own.begin + item % (own.end - own.begin)];
      value = value * 6364136223846793005u + static_cast<std::uint64_t>(item);  // depends on the order
      block_of_item[item] = block;
    }
  }
};

struct Blocks {
  std::vector<IndexRange> rows, items;
  /// Blocks of 1 to 11 rows and 0 to 7 packs.
  explicit Blocks(Index count) {
    Index row = 3, item = 0;
    for (Index k = 0; k < count; ++k) {
      const Index more_rows = 1 + k * 5 % 11, more_items = 4 * (k * 3 % 8);
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

Mixed mixed(const Blocks& blocks, int threads) {
  Mixed out{std::vector<std::uint64_t>(blocks.row_count(), 77), std::vector<std::int32_t>(blocks.item_count(), none)};
  Cpu cpu(threads);
  cpu.for_each_block("mix", {static_cast<Index>(blocks.rows.size()), 1},
                     MixItems{&blocks.rows, &blocks.items, out.rows.data(), out.block_of_item.data()});
  return out;
}

}  // namespace

TEST_CASE("Every block is processed once, its items in order, for any number of threads", "[exec]") {
  const Index count = GENERATE(0, 1, 2, 7, 300);
  const Blocks blocks(count);
  const Mixed one = mixed(blocks, 1);
  for (std::size_t k = 0; k < blocks.items.size(); ++k)
    for (Index item = blocks.items[k].begin; item < blocks.items[k].end; ++item)
      REQUIRE(one.block_of_item[static_cast<std::size_t>(item)] == static_cast<Index>(k));
  for (const int threads : {2, 3, 8, 20}) {
    const Mixed other = mixed(blocks, threads);
    CHECK(other.rows == one.rows);
    CHECK(other.block_of_item == one.block_of_item);
  }
}

TEST_CASE("Rows of all blocks are cleared, also of blocks without items, and other rows are unchanged", "[exec]") {
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

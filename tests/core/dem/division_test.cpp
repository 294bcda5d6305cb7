// SPDX-License-Identifier: GPL-3.0-or-later
// Broken rocks become several blocks.
#include "core/dem/division.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

/// Rocks of particles in a row, each bonded to the next: bonds of even and of odd number are the two colours.
struct Chains {
  std::vector<Index> i, j, colour_begin;
  std::vector<std::int32_t> state, starts;
  std::vector<Block> blocks;
  Index particles = 0;

  void add(Index count, std::int32_t block_state) {
    Block b{};
    b.first_particle = particles, b.end_particle = particles + count;
    b.first_bond = static_cast<Index>(i.size());
    b.first_colour = static_cast<Index>(colour_begin.size());
    b.state = block_state, b.free_of_load = 1, b.substeps = 4, b.table = 0, b.rock = static_cast<RockId>(blocks.size());
    for (const Index odd : {0, 1}) {
      colour_begin.push_back(static_cast<Index>(i.size()));
      for (Index n = odd; n + 1 < count; n += 2) i.push_back(particles + n), j.push_back(particles + n + 1);
    }
    colour_begin.push_back(static_cast<Index>(i.size()));
    starts.resize(colour_begin.size(), starts_colour);
    b.table_bonds = static_cast<Index>(i.size()) - b.first_bond;
    state.resize(i.size(), bond_intact);
    while (i.size() % bond_alignment != 0)
      i.push_back(b.first_particle), j.push_back(b.first_particle), state.push_back(bond_broken);
    b.end_bond = static_cast<Index>(i.size());
    b.end_colour = static_cast<Index>(colour_begin.size());
    blocks.push_back(b);
    particles += count;
  }
  void set(Index first, std::int32_t to) {  // the bond from `first` to the next particle
    for (std::size_t b = 0; b < i.size(); ++b)
      if (i[b] == first && j[b] == first + 1) state[b] = to;
  }
  DividedRocks divided() const { return divided_rocks({i, j, state, blocks, {colour_begin, starts}}, particles); }
};

/// The particles of a block, by their old numbers.
std::vector<Index> members(const DividedRocks& d, std::size_t k) {
  const Block& b = d.bonds.blocks[k];
  return {d.places.old_index.begin() + b.first_particle, d.places.old_index.begin() + b.end_particle};
}

void check_rows(const Chains& before, const DividedRocks& d) {
  REQUIRE(d.places.old_index.size() == static_cast<std::size_t>(before.particles));
  for (Index n = 0; n < before.particles; ++n)
    CHECK(d.places.old_index[static_cast<std::size_t>(d.places.new_index[static_cast<std::size_t>(n)])] == n);
  Index particle = d.bonds.blocks.front().first_particle, bond = 0;
  for (const Block& b : d.bonds.blocks) {
    CHECK(b.first_particle == particle);
    CHECK(b.first_bond == bond);
    CHECK(b.end_bond % bond_alignment == 0);
    particle = b.end_particle, bond = b.end_bond;
    for (Index n = b.first_bond; n < b.end_bond; ++n) {
      const auto at = static_cast<std::size_t>(n);
      CHECK((d.bonds.i[at] >= b.first_particle && d.bonds.i[at] < b.end_particle));
      CHECK((d.bonds.j[at] >= b.first_particle && d.bonds.j[at] < b.end_particle));
      const bool filler = n >= b.first_bond + b.table_bonds;
      CHECK((d.bonds.source[at] == none) == filler);
      if (filler) continue;
      const auto source = static_cast<std::size_t>(d.bonds.source[at]);
      CHECK(d.places.old_index[static_cast<std::size_t>(d.bonds.i[at])] == before.i[source]);
      CHECK(d.places.old_index[static_cast<std::size_t>(d.bonds.j[at])] == before.j[source]);
      CHECK(d.bonds.state[at] == before.state[source]);
    }
    const Index last = d.bonds.colour_begin[static_cast<std::size_t>(b.end_colour - 1)];
    CHECK(last == b.first_bond + b.table_bonds);
    for (Index c = b.first_colour; c + 1 < b.end_colour; ++c) {  // no two bonds of a colour share a particle
      std::vector<int> used(static_cast<std::size_t>(before.particles), 0);
      for (Index n = d.bonds.colour_begin[static_cast<std::size_t>(c)];
           n < d.bonds.colour_begin[static_cast<std::size_t>(c + 1)]; ++n)
        for (const Index end : {d.bonds.i[static_cast<std::size_t>(n)], d.bonds.j[static_cast<std::size_t>(n)]})
          CHECK(used[static_cast<std::size_t>(end)]++ == 0);
    }
  }
}

}  // namespace

TEST_CASE("A broken rock is divided into its pieces and its single particles", "[levels]") {
  Chains rocks;
  rocks.particles = 2;  // that belong to no rock
  rocks.add(4, block_intact);
  rocks.add(9, block_broken);  // particles 6 to 14
  rocks.add(3, block_broken);
  rocks.add(3, block_intact);
  for (const Index gap : {6, 9, 12, 13}) rocks.set(gap, bond_broken);  // 6 | 7 8 9 | 10 11 12 | 13 | 14
  rocks.set(10, bond_pressed);
  const DividedRocks d = rocks.divided();
  REQUIRE(d.any());
  check_rows(rocks, d);
  using Particles = std::vector<Index>;
  REQUIRE(d.bonds.blocks.size() == 6);
  CHECK(d.bonds.old_block == Particles{0, 1, 1, 1, 2, 3});
  CHECK(members(d, 0) == Particles{2, 3, 4, 5});
  CHECK(members(d, 1) == Particles{7, 8, 9});
  CHECK(members(d, 2) == Particles{10, 11, 12});
  CHECK(members(d, 3) == Particles{6, 13, 14});
  CHECK(members(d, 4) == Particles{15, 16, 17});
  CHECK(d.bonds.blocks[0].table == 0);
  CHECK(d.bonds.blocks[1].table == none);
  CHECK(d.bonds.blocks[3].first_bond == d.bonds.blocks[3].end_bond);
  for (std::size_t k = 1; k < 4; ++k) CHECK(d.bonds.blocks[k].rock == 1);
}

TEST_CASE("A rock that has lost a bond and still holds together loses the row of it", "[levels]") {
  Chains ring;
  ring.add(4, block_broken);
  ring.i[3] = 0, ring.j[3] = 3, ring.state[3] = bond_intact;  // in place of the first that fills up
  ring.colour_begin.back() = 4, ++ring.blocks[0].table_bonds;
  ring.set(1, bond_broken);
  const DividedRocks d = ring.divided();
  REQUIRE(d.any());
  check_rows(ring, d);
  REQUIRE(d.bonds.blocks.size() == 1);
  CHECK(d.bonds.blocks[0].table_bonds == 3);
  CHECK(d.bonds.blocks[0].table == none);
}

TEST_CASE("Rocks are left as they are that are whole, rigid, spent or not known without loads", "[levels]") {
  Chains rocks;
  rocks.add(3, block_broken);
  CHECK_FALSE(rocks.divided().any());
  rocks.set(0, bond_broken);
  CHECK(rocks.divided().any());
  SECTION("rigid") {
    rocks.blocks[0].rigid = 1;
  }
  SECTION("spent") {
    rocks.blocks[0].first_bond = rocks.blocks[0].end_bond;
  }
  SECTION("under load") {
    rocks.blocks[0].free_of_load = 0;
  }
  CHECK_FALSE(rocks.divided().any());
}

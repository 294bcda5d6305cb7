// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/pieces.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

Block block(Index first_particle, Index end_particle, Index bonds, std::int32_t substeps = 1) {
  return {first_particle, end_particle, 0, bonds, 0, 0, 0, block_intact, substeps};
}

/// Blocks whose colours do not matter.
Pieces pieces_of(const std::vector<Block>& blocks, Index particles) {
  return make_pieces(blocks, {{}, {}}, particles);
}

/// Whether the pieces cover these particles once, in their order.
bool cover(const std::vector<Piece>& pieces, Index begin, Index end) {
  for (const Piece& p : pieces) {
    if (p.first_particle != begin || p.end_particle <= p.first_particle) return false;
    begin = p.end_particle;
  }
  return begin == end;
}

}  // namespace

TEST_CASE("Pieces: rocks are pieces, and what has no bonds is cut into runs", "[state]") {
  const Pieces pieces = pieces_of({block(10, 40, 64), block(340, 341, 0)}, 500);
  CHECK(pieces.large.empty());
  CHECK(pieces.large_rows.empty());
  CHECK(cover(pieces.together, 0, 500));
  std::vector<Index> blocks, lengths;
  for (const Piece& p : pieces.together) {
    blocks.push_back(p.block);
    lengths.push_back(p.end_particle - p.first_particle);
  }
  CHECK(blocks == std::vector<Index>{none, 0, none, none, none, none});
  CHECK(lengths == std::vector<Index>{10, 30, 128, 128, 128, 76});
}

TEST_CASE("Pieces: the particles of a large rock are cut into runs, and its bonds into parts", "[state]") {
  Block large = block(50, 4050, large_rock);
  large.first_colour = 2;
  large.end_colour = 10;
  // Two rounds of two parts, of which the last has lost its bonds: 2, 1, 3 and 1 colours.
  const std::vector<Index> begin{0, 64, 100, 150, 180, 240, 300, 300, 380, 380};
  const std::vector<std::int32_t> starts{starts_colour, starts_colour, starts_round,  starts_colour, starts_part,
                                         starts_round,  starts_colour, starts_colour, starts_part,   starts_colour};
  const Pieces pieces =
      make_pieces({block(0, 50, 64), large, block(4050, 4060, large_rock - 8)}, {begin, starts}, 4060);
  REQUIRE(pieces.large.size() == 1);
  const LargeRock& rock = pieces.large[0];
  CHECK(rock.block == 1);
  CHECK(cover(pieces.large_rows, 50, 4050));
  CHECK(rock.rows.begin == 0);
  CHECK(rock.rows.end == static_cast<Index>(pieces.large_rows.size()));
  for (const Piece& p : pieces.large_rows) CHECK(p.block == none);
  const auto numbers = [](const Part& p) {
    return std::vector<Index>{p.first_bond, p.end_bond, p.first_colour, p.end_colour};
  };
  REQUIRE(pieces.parts.size() == 3);
  CHECK(numbers(pieces.parts[0]) == std::vector<Index>{100, 180, 2, 4});
  CHECK(numbers(pieces.parts[1]) == std::vector<Index>{180, 240, 4, 5});
  CHECK(numbers(pieces.parts[2]) == std::vector<Index>{240, 380, 5, 8});
  REQUIRE(rock.rounds.size() == 2);
  CHECK(std::pair(rock.rounds[0].begin, rock.rounds[0].end) == std::pair(0, 2));
  CHECK(std::pair(rock.rounds[1].begin, rock.rounds[1].end) == std::pair(2, 3));
  REQUIRE(pieces.together.size() == 2);
  CHECK(pieces.together[0].block == 0);
  CHECK(pieces.together[1].block == 2);
}

TEST_CASE("Pieces: all particles of a piece have the same sub-steps", "[state]") {
  // A rock, two rocks that have lost their bonds, a loose particle, a rock.
  const Pieces pieces =
      pieces_of({block(0, 10, 8, 3), block(10, 14, 0, 2), block(14, 16, 0, 2), block(17, 20, 16, 2)}, 22);
  REQUIRE(cover(pieces.together, 0, 22));
  std::vector<Index> begins;
  std::vector<std::int32_t> substeps;
  for (const Piece& p : pieces.together) {
    begins.push_back(p.first_particle);
    substeps.push_back(p.substeps);
  }
  CHECK(begins == std::vector<Index>{0, 10, 16, 17, 20});
  CHECK(substeps == std::vector<std::int32_t>{3, 2, 1, 2, 1});
  CHECK(pieces.max_substeps == 3);
}

TEST_CASE("Pieces of an empty scene, and of one without rocks", "[state]") {
  CHECK(pieces_of({}, 0).together.empty());
  CHECK(cover(pieces_of({}, 300).together, 0, 300));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/pieces.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

Block block(Index first_particle, Index end_particle, Index bonds, std::int32_t substeps = 1) {
  return {first_particle, end_particle, 0, bonds, 0, 0, 0, block_intact, substeps};
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
  const Pieces pieces = make_pieces({block(10, 40, 64), block(340, 341, 0)}, 500);
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

TEST_CASE("Pieces: the particles of a large rock are cut into runs, and its bonds stand apart", "[state]") {
  const Pieces pieces = make_pieces({block(0, 50, 64), block(50, 4050, large_rock), block(4050, 4060, 16)}, 4060);
  REQUIRE(pieces.large == std::vector<Index>{1});
  CHECK(cover(pieces.large_rows, 50, 4050));
  for (const Piece& p : pieces.large_rows) CHECK(p.block == none);
  REQUIRE(pieces.together.size() == 2);
  CHECK(pieces.together[0].block == 0);
  CHECK(pieces.together[1].block == 2);
}

TEST_CASE("Pieces: all particles of a piece have the same sub-steps", "[state]") {
  // A rock, two rocks that have lost their bonds, a loose particle, a rock.
  const Pieces pieces =
      make_pieces({block(0, 10, 8, 3), block(10, 14, 0, 2), block(14, 16, 0, 2), block(17, 20, 16, 2)}, 22);
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
  CHECK(make_pieces({}, 0).together.empty());
  CHECK(cover(make_pieces({}, 300).together, 0, 300));
}

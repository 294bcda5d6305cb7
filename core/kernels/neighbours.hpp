// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/kernels/bounds.hpp"
#include "core/kernels/grid.hpp"
#include "core/kernels/row_filler.hpp"
#include "core/state/bonds.hpp"
#include "core/state/contacts.hpp"

namespace gyro {

/// Table of the partners that a particle may touch while both stay in their wide bounds: a row a particle. Rows of
/// equal length hold most of them; what is longer lies elsewhere.
struct CandidateTable {
  Index room;         ///< length of rows
  Index* count;       ///< partners of each particle
  Index* partner;     ///< row by row
  Index* long_begin;  ///< of particles with more partners than a row has room for, into long_partner
  Index* long_partner;

  GYRO_HD bool is_long(Index n) const { return count[n] > room; }
  GYRO_HD Index* row(Index n) const { return partner + static_cast<std::int64_t>(n) * room; }
  GYRO_HD Index* partners(Index n) const { return is_long(n) ? long_partner + long_begin[n] : row(n); }
};

/// Finds the candidates of a particle among those of its own level that have a higher id and among all of
/// coarser levels: every pair of the scene once. The first run counts all and fills rows, the second what is long.
struct FindCandidates {
  ConstParticleView p;
  Grid grid;
  BondIndex bonds;
  const Sphere* bounds;
  CandidateTable table;
  bool fills_long;

  GYRO_HD void operator()(Index n) const {
    if (fills_long && !table.is_long(n)) return;
    const Sphere sphere = bounds[n];
    const int own = grid.level_of(sphere.radius);
    Index found = 0;
    for (int l = 0; l <= own; ++l) {
      const GridLevel& g = grid.level[l];
      if (g.radius == 0) continue;
      // At most three cells in each direction: the reach is no larger than a cell.
      const double reach = sphere.radius + g.radius;
      const Vec3d corner{reach, reach, reach};
      const CellCoordinate low = Grid::coordinate(g, sphere.x - corner), high = Grid::coordinate(g, sphere.x + corner);
      const int nx = span(low.x, high.x), ny = span(low.y, high.y), nz = span(low.z, high.z);
      for (int z = 0; z <= nz; ++z)
        for (int y = 0; y <= ny; ++y)
          for (int x = 0; x <= nx; ++x) {
            const Index cell = Grid::place(g, low.x + x, low.y + y, low.z + z);
            for (Index s = grid.cell_begin[cell]; s < grid.cell_begin[cell + 1]; ++s)
              if (reach_each_other(sphere, grid.sphere[s])) consider(n, grid.sorted[s], l == own, found);
          }
    }
    table.count[n] = found;
  }

 private:
  /// Cells beyond the first one; 2 at most also for what is not finite.
  GYRO_HD static int span(std::int64_t low, std::int64_t high) {
    const std::int64_t more = high - low;
    return more > 2 ? 2 : more < 0 ? 0 : static_cast<int>(more);
  }
  GYRO_HD void consider(Index n, Index other, bool same_level, Index& found) const {
    if (other == n || (same_level && p.id[other] < p.id[n])) return;
    if (bonds.in_one_rock(p.block[n], p.block[other]) && !bonds.blocks[p.block[n]].listed &&
        bonds.between(n, other) != none)
      return;  // they cannot come apart yet
    if (fills_long)
      table.long_partner[table.long_begin[n] + found] = other;
    else if (found < table.room)
      table.row(n)[found] = other;
    ++found;
  }
};

/// Which bonded pairs are listed: those of rocks that have cracked, and where rocks may be rigid of those that are not.
/// The others would fill the lists, and cannot come apart before a first bond fails, after which lists are made again.
struct ListBonded {
  Block* blocks;
  GYRO_HD void operator()(Index k) const {
    const Block& b = blocks[k];
    blocks[k].listed = b.state == block_broken || (b.free_of_load && !b.rigid) ? 1 : 0;
  }
};

/// Numbers of candidates.
struct CandidateCount {
  std::int64_t total = 0, in_long = 0;
  GYRO_HD friend CandidateCount operator+(const CandidateCount& a, const CandidateCount& b) {
    return {a.total + b.total, a.in_long + b.in_long};
  }
};
struct CandidateCountOf {
  CandidateTable table;
  GYRO_HD CandidateCount operator()(Index n) const { return {table.count[n], table.is_long(n) ? table.count[n] : 0}; }
};

/// Length of each row that is long, 0 for the others.
struct LongLength {
  CandidateTable table;
  GYRO_HD void operator()(Index n) const { table.long_begin[n] = table.is_long(n) ? table.count[n] : 0; }
};

/// Finds the pairs among the candidates that may touch while both stay in their close bounds.
struct FindPairs {
  ConstParticleView p;
  BondIndex bonds;
  const Sphere* bounds;
  CandidateTable candidates;
  RowFiller<Pair> rows;

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = bounds[n];
    const Index* partner = candidates.partners(n);
    Index found = 0;
    for (Index k = 0; k < candidates.count[n] && !rows.is_full(n, found); ++k)
      if (reach_each_other(sphere, bounds[partner[k]])) rows.add(n, found, pair_of(n, partner[k]));
    rows.end_row(n, found);
  }

 private:
  GYRO_HD Pair pair_of(Index n, Index other) const {
    const bool lower = p.id[n] < p.id[other];
    const Index bond = bonds.in_one_rock(p.block[n], p.block[other]) ? bonds.between(n, other) : none;
    return {lower ? n : other, lower ? other : n, bond};
  }
};

/// Counts or enters the two ends of each pair in the rows of its particles.
struct EnterEnds {
  const Pair* pairs;
  std::int32_t* counts;    ///< counting run: ends of each particle; filling run: ends entered so far
  const Index* row_begin;  ///< null in the counting run
  PairEnd* ends;

  GYRO_HD void operator()(Index n) const {
    enter(pairs[n].i, n, 0);
    enter(pairs[n].j, n, 1);
  }

 private:
  GYRO_HD void enter(Index particle, Index pair, std::int32_t side) const {
    const std::int32_t place = take_number(&counts[particle]);
    if (row_begin != nullptr) ends[row_begin[particle] + place] = {pair, side};
  }
};

/// Puts the ends of a particle in order of the partner's id: the order of its sum.
struct SortRow {
  ConstParticleView p;
  const Pair* pairs;
  const Index* row_begin;
  PairEnd* ends;

  GYRO_HD void operator()(Index n) const {
    for (Index a = row_begin[n] + 1; a < row_begin[n + 1]; ++a) {
      const PairEnd moved = ends[a];
      const ParticleId id = partner(moved);
      Index b = a;
      for (; b > row_begin[n] && partner(ends[b - 1]) > id; --b) ends[b] = ends[b - 1];
      ends[b] = moved;
    }
  }

 private:
  GYRO_HD ParticleId partner(const PairEnd& e) const { return p.id[e.side == 0 ? pairs[e.pair].j : pairs[e.pair].i]; }
};

/// Notes at each pair where its ends stand.
struct LocateEnds {
  const PairEnd* ends;
  PairEnds* at;

  GYRO_HD void operator()(Index e) const {
    PairEnds& pair = at[ends[e].pair];
    (ends[e].side == 0 ? pair.i : pair.j) = e;
  }
};

/// Carries the history of touching contacts over from the old list.
template <class Real>
struct CarryHistory {
  PairView<Real> now;
  ConstPairView<Real> old;
  bool with_extra;  ///< the contact law keeps ExtraHistory

  GYRO_HD void operator()(Index n) const {
    if (with_extra) now.extra[n] = {};
    now.history[n] = {};
    now.touching[n] = 0;
    find_old(n);
    now.loaded[now.at[n].i] = now.loaded[now.at[n].j] = now.touching[n];
  }

 private:
  GYRO_HD void find_old(Index n) const {
    const Pair pair = now.pair[n];
    for (Index e = old.row_begin[pair.i]; e < old.row_begin[pair.i + 1]; ++e) {
      const Index m = old.ends[e].pair;
      if (old.pair[m].i != pair.i || old.pair[m].j != pair.j) continue;
      now.history[n] = old.history[m];
      if (with_extra) now.extra[n] = old.extra[m];
      now.touching[n] = old.touching[m];
      return;
    }
  }
};

}  // namespace gyro

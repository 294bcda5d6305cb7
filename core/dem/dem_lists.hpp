// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem_solver.hpp"

// Neighbour lists. They only say who may touch: when they are rebuilt, and with which margin, changes
// no bit of a result.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::rebuild_lists() {
  book_walls();
  std::swap(pairs_, old_pairs_);
  std::swap(walls_, old_walls_);
  Grid grid = make_grid();
  sort_into_cells(grid);
  list_pairs(grid);
  list_ends();
  const PairView<Real> pairs = pair_view(pairs_);
  exec_.for_each("carry memory", pairs.count, CarryMemory<Real>{pairs, pair_view(old_pairs_)});
  list_walls();
  exec_.for_each("note places", particle_count(), NotePlaces{view()});
  poses_listed_ = poses_now_;
  auto flags = Exec::host(flags_);
  flags[0] = flags[1] = 0;
  Exec::upload(flags_, flags);
  listed_ = true;
  ++counts_total_.rebuilds;
}

/// Radii and extent of the particles, for the levels of the grid.
struct Extent {
  double smallest = 1e300, largest = 0;
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  GYRO_HD friend Extent operator+(const Extent& a, const Extent& b) {
    return {smaller(a.smallest, b.smallest),
            larger(a.largest, b.largest),
            {smaller(a.low.x, b.low.x), smaller(a.low.y, b.low.y), smaller(a.low.z, b.low.z)},
            {larger(a.high.x, b.high.x), larger(a.high.y, b.high.y), larger(a.high.z, b.high.z)}};
  }
};
struct ExtentOf {
  ParticleView p;
  GYRO_HD Extent operator()(Index n) const {
    const Sphere q = p.place[n];
    return {q.radius, q.radius, q.x, q.x};
  }
};

template <class Exec, class Real>
Grid DemSolver<Exec, Real>::make_grid() {
  const Extent extent = exec_.template reduce<Extent>("extent", particle_count(), ExtentOf{view()});
  margin_ = scene_.neighbour_margin > 0 ? scene_.neighbour_margin : 0.8 * extent.smallest;
  Grid grid{};
  const Index most = 2 * particle_count() + 64;
  for (double radius = extent.largest; grid.levels < Grid::most_levels && radius * 1.0000001 >= extent.smallest;
       radius *= 0.5) {
    GridLevel& g = grid.level[grid.levels++];
    g = {radius, 2 * radius + margin_, 3, 3, 3, grid.cells};
    const auto wanted = [&](double low, double high) { return (high - low) / g.cell + 2; };
    const double x = wanted(extent.low.x, extent.high.x), y = wanted(extent.low.y, extent.high.y),
                 z = wanted(extent.low.z, extent.high.z);
    const auto size = [&] { return std::int64_t{g.mask_x + 1} * (g.mask_y + 1) * (g.mask_z + 1); };
    for (bool grown = true; grown && size() < most;) {
      grown = false;
      if (g.mask_x + 1 < x && size() < most) g.mask_x = 2 * g.mask_x + 1, grown = true;
      if (g.mask_y + 1 < y && size() < most) g.mask_y = 2 * g.mask_y + 1, grown = true;
      if (g.mask_z + 1 < z && size() < most) g.mask_z = 2 * g.mask_z + 1, grown = true;
    }
    grid.cells += static_cast<Index>(size());
  }
  return grid;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::sort_into_cells(Grid& grid) {
  const Index n = particle_count();
  cell_keys_.resize(static_cast<std::size_t>(n));
  cell_sorted_.resize(static_cast<std::size_t>(n));
  cell_begin_.resize(static_cast<std::size_t>(grid.cells) + 1);
  exec_.for_each("cell keys", n, CellKeys{view(), grid, cell_keys_.data(), cell_sorted_.data()});
  exec_.sort_by_key(cell_keys_, cell_sorted_);
  exec_.for_each("cell begins", n + 1, CellBegins{cell_keys_.data(), n, grid.cells, cell_begin_.data()});
  grid.cell_begin = cell_begin_.data();
  grid.sorted = cell_sorted_.data();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::list_pairs(const Grid& grid) {
  const Index n = particle_count();
  counts_.resize(static_cast<std::size_t>(n) + 1);
  FindPairs find{view(),
                 grid,
                 blocks_.data(),
                 bonds_.state.data(),
                 bonds_.i.data(),
                 bonds_.j.data(),
                 {has_bonds() ? bond_row_begin_.data() : nullptr, bond_row_.data()},
                 margin_,
                 counts_.data(),
                 nullptr};
  exec_.for_each("count pairs", n, find);
  const auto total = static_cast<std::size_t>(exec_.exclusive_scan(n, counts_.data()));
  pairs_.pairs.resize(total);
  pairs_.memory.resize(total);
  pairs_.result.resize(total);
  pairs_.touching.resize(total);
  pairs_.ends.resize(2 * total);
  find.pairs = pairs_.pairs.data();
  if (total > 0) exec_.for_each("find pairs", n, find);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::list_ends() {
  const Index n = particle_count(), count = static_cast<Index>(pairs_.pairs.size());
  const auto rows = static_cast<std::size_t>(n) + 1;
  const auto clear = [rows](auto& counts) {  // what a buffer gains is zero
    counts.resize(0);
    counts.resize(rows);
  };
  clear(pairs_.row_begin);
  exec_.for_each("count ends", count, EnterEnds{pairs_.pairs.data(), pairs_.row_begin.data(), nullptr, nullptr});
  exec_.exclusive_scan(n, pairs_.row_begin.data());
  clear(end_counts_);
  exec_.for_each("enter ends", count,
                 EnterEnds{pairs_.pairs.data(), end_counts_.data(), pairs_.row_begin.data(), pairs_.ends.data()});
  exec_.for_each("sort rows", n, SortRow{view(), pairs_.pairs.data(), pairs_.row_begin.data(), pairs_.ends.data()});
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::list_walls() {
  const Index n = particle_count();
  walls_.row_begin.resize(static_cast<std::size_t>(n) + 1);
  FindWalls<Real> find{view(), surfaces_.data(), poses_, surfaces_.count(), margin_, walls_.row_begin.data(), nullptr};
  exec_.for_each("count walls", n, find);
  const auto total = static_cast<std::size_t>(exec_.exclusive_scan(n, walls_.row_begin.data()));
  walls_.entries.resize(total);
  walls_.memory.resize(total);
  walls_.result.resize(total);
  walls_.touching.resize(total);
  walls_.sums.resize(total);
  walls_.later.resize(total);
  find.entries = walls_.entries.data();
  if (total > 0) exec_.for_each("find walls", n, find);
  const WallView<Real> now = wall_view(walls_);
  exec_.for_each("carry walls", now.count, CarryWallMemory<Real>{now, wall_view(old_walls_)});
}

/// Takes what the entries have booked into the sums of the walls.
template <class Exec, class Real>
void DemSolver<Exec, Real>::book_walls() {
  const WallView<Real> walls = wall_view(walls_);
  if (walls.count == 0) return;
  for (Index w = 0; w < surfaces_.count(); ++w) {
    WallSum& sum = wall_sums_[static_cast<std::size_t>(w)];
    sum = sum + exec_.template reduce<WallSum>("book walls", walls.count, SumWall{walls.entries, walls.sums, w});
  }
  exec_.for_each("clear walls", walls.count, ClearWallSums<Real>{walls});
}

/// The sums of the next window begin with what the last step's loads will do in its first half kick.
template <class Exec, class Real>
void DemSolver<Exec, Real>::book_later() {
  const WallView<Real> walls = wall_view(walls_);
  for (Index w = 0; w < surfaces_.count(); ++w)
    wall_sums_[static_cast<std::size_t>(w)] =
        exec_.template reduce<WallSum>("book walls", walls.count, SumWall{walls.entries, walls.later, w});
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/dem_solver.hpp"

#include <algorithm>
#include <string>
#include <utility>

// Neighbour lists. They only say who may touch: when they are rebuilt, and with which margin, changes
// no bit of a result.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::rebuild_lists() {
  Grid grid = make_grid();
  sort_into_cells(grid);
  expect_no_crowd(grid);
  const Index pair_count = count_pairs(grid);
  book_walls();
  std::swap(pairs_, old_pairs_);
  std::swap(walls_, old_walls_);
  list_pairs(grid, pair_count);
  list_ends();
  const PairView<Real> pairs = pair_view(pairs_);
  exec_.for_each("carry memory", pairs.count, CarryHistory<Real>{pairs, pair_view(old_pairs_)});
  list_walls();
  exec_.for_each("note places", particle_count(), StorePositions{view()});
  listed_poses_ = poses_now_;
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
    const Sphere q = p.position[n];
    Extent e;
    e.smallest = e.largest = q.radius;
    if (norm2(q.x) < 1e300) e.low = e.high = q.x;  // what is nowhere must not shrink the table for all others
    return e;
  }
};

template <class Exec, class Real>
Grid DemSolver<Exec, Real>::make_grid() {
  const Extent extent = exec_.template reduce<Extent>("extent", particle_count(), ExtentOf{view()});
  smallest_radius_ = particle_count() > 0 ? extent.smallest : 0;
  skin_ = scene_.neighbour_skin > 0 ? scene_.neighbour_skin : 0.8 * extent.smallest;
  Grid grid{};
  const Index maximum = 2 * particle_count() + 64;
  for (double bound = extent.largest; grid.levels < Grid::max_levels && bound * 1.0000001 >= extent.smallest;
       bound *= 0.5)
    grid.level[grid.levels++].bound = bound;
  const LevelRadii radii = exec_.template reduce<LevelRadii>("levels", particle_count(), LevelRadiiOf{view(), grid});
  for (int l = 0; l < grid.levels; ++l) {
    GridLevel& g = grid.level[l];
    const double radius = radii.largest[l];
    g = {g.bound, radius, 2 * radius + skin_, 3, 3, 3, grid.cells};
    const auto wanted = [&](double low, double high) { return (high - low) / g.cell + 2; };
    const double x = wanted(extent.low.x, extent.high.x), y = wanted(extent.low.y, extent.high.y),
                 z = wanted(extent.low.z, extent.high.z);
    const auto size = [&] { return std::int64_t{g.mask_x + 1} * (g.mask_y + 1) * (g.mask_z + 1); };
    for (bool grown = radius > 0; grown && size() < maximum;) {
      grown = false;
      if (g.mask_x + 1 < x && size() < maximum) g.mask_x = 2 * g.mask_x + 1, grown = true;
      if (g.mask_y + 1 < y && size() < maximum) g.mask_y = 2 * g.mask_y + 1, grown = true;
      if (g.mask_z + 1 < z && size() < maximum) g.mask_z = 2 * g.mask_z + 1, grown = true;
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

/// A search costs about 27 times the sum of the squares of the cells' particles. Rock fills a cell with some
/// tens of its size; thousands on average only when particles lie in each other or the margin is absurd.
/// @throws StoppedByGuard  rather than hang
template <class Exec, class Real>
void DemSolver<Exec, Real>::expect_no_crowd(const Grid& grid) const {
  constexpr double max_in_cell = 2000, little_work = 1e4;
  const Crowd crowd = exec_.template reduce<Crowd>("crowd", grid.cells, CrowdOf{cell_begin_.data()});
  if (crowd.squares <= max_in_cell * larger(static_cast<double>(particle_count()), little_work)) return;
  const auto sorted = Exec::host(cell_sorted_);
  const auto begin = Exec::host(cell_begin_);
  const auto id = Exec::host(particles_.id);
  const Index one = sorted[static_cast<std::size_t>(begin[static_cast<std::size_t>(crowd.cell)])];
  throw StoppedByGuard(std::to_string(crowd.maximum) + " particles, particle " +
                       std::to_string(id[static_cast<std::size_t>(one)]) +
                       " among them, crowd in one cell of the neighbour search; at most some tens find room in it");
}

template <class Exec, class Real>
FindPairs DemSolver<Exec, Real>::pair_finder(const Grid& grid) const {
  return {view(),
          grid,
          blocks_.data(),
          bonds_.state.data(),
          bonds_.i.data(),
          bonds_.j.data(),
          {has_bonds() ? bond_row_begin_.data() : nullptr, bond_row_.data()},
          skin_,
          const_cast<Index*>(counts_.data()),
          nullptr};
}

/// Number of pairs; leaves the first pair of each particle in counts_.
/// @throws StoppedByGuard  for more than the lists can number
template <class Exec, class Real>
Index DemSolver<Exec, Real>::count_pairs(const Grid& grid) {
  constexpr std::int64_t maximum = 1'000'000'000;  // each has two ends, which are numbered too
  const Index n = particle_count();
  counts_.resize(static_cast<std::size_t>(n) + 1);
  exec_.for_each("count pairs", n, pair_finder(grid));
  const auto total = exec_.template reduce<std::int64_t>("total pairs", n, PairTotal{counts_.data()});
  if (total > maximum)
    throw StoppedByGuard(std::to_string(total) + " pairs of particles are near each other; at most " +
                         std::to_string(maximum) + " can be listed");
  return exec_.exclusive_scan(n, counts_.data());
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::list_pairs(const Grid& grid, Index count) {
  const Index n = particle_count();
  const auto total = static_cast<std::size_t>(count);
  FindPairs find = pair_finder(grid);
  pairs_.pairs.resize(total);
  pairs_.history.resize(total);
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
  FindWalls<Real> find{view(), surfaces_.data(), poses_, surfaces_.count(), skin_, walls_.row_begin.data(), nullptr};
  exec_.for_each("count walls", n, find);
  const auto total = static_cast<std::size_t>(exec_.exclusive_scan(n, walls_.row_begin.data()));
  walls_.entries.resize(total);
  walls_.history.resize(total);
  walls_.result.resize(total);
  walls_.touching.resize(total);
  walls_.sums.resize(total);
  walls_.carried_over.resize(total);
  find.entries = walls_.entries.data();
  if (total > 0) exec_.for_each("find walls", n, find);
  const WallView<Real> now = wall_view(walls_);
  exec_.for_each("carry walls", now.count, CarryWallHistory<Real>{now, wall_view(old_walls_)});
}

/// Takes what the entries have booked into the sums of the walls.
template <class Exec, class Real>
void DemSolver<Exec, Real>::book_walls() {
  const WallView<Real> walls = wall_view(walls_);
  if (walls.count == 0) return;
  if (scene_.wall_impulses) keep_impulses(walls_.sums);
  for (Index w = 0; w < surfaces_.count(); ++w) {
    WallSum& sum = wall_sums_[static_cast<std::size_t>(w)];
    sum = sum + exec_.template reduce<WallSum>("book walls", walls.count, SumWall{walls.entries, walls.sums, w});
  }
  exec_.for_each("clear walls", walls.count, ClearWallSums<Real>{walls});
}

/// The sums of the next window begin with what the last step's loads will do in its first half kick.
template <class Exec, class Real>
void DemSolver<Exec, Real>::carry_over_walls() {
  const WallView<Real> walls = wall_view(walls_);
  if (scene_.wall_impulses) keep_impulses(walls_.carried_over);
  note_impulses();
  for (Index w = 0; w < surfaces_.count(); ++w)
    wall_sums_[static_cast<std::size_t>(w)] =
        exec_.template reduce<WallSum>("book walls", walls.count, SumWall{walls.entries, walls.carried_over, w});
}

/// Keeps what each entry has booked.
template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_impulses(const Buffer<WallSum>& booked) {
  const auto& entries = Exec::host(walls_.entries);
  const auto& sums = Exec::host(booked);
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const WallSum& s = sums[n];
    if (s.force[0] != 0 || s.force[1] != 0 || s.force[2] != 0 || s.slip != 0)
      kept_impulses_.push_back({entries[n].particle, entries[n].wall, s});
  }
}

/// Gives what was kept since the window began to the places where its particles are now, in the frames of the walls:
/// when the lists were rebuilt in between changes nothing. Ordered by the particles' ids, as sums of them must be.
template <class Exec, class Real>
void DemSolver<Exec, Real>::note_impulses() {
  if (kept_impulses_.empty()) return;
  const auto& place = Exec::host(particles_.position);
  const auto& ids = Exec::host(particles_.id);
  const auto key = [&](const KeptImpulse& k) { return std::pair{ids[static_cast<std::size_t>(k.particle)], k.wall}; };
  std::sort(kept_impulses_.begin(), kept_impulses_.end(),
            [&](const KeptImpulse& a, const KeptImpulse& b) { return key(a) < key(b); });
  for (auto k = kept_impulses_.begin(); k != kept_impulses_.end();) {
    const KeptImpulse first = *k;
    WallSum sum;
    for (; k != kept_impulses_.end() && key(*k) == key(first); ++k) sum = sum + k->sum;
    const WallPose& pose = poses_now_[static_cast<std::size_t>(first.wall)];
    const Sphere& sphere = place[static_cast<std::size_t>(first.particle)];
    const Vec3d impulse = wall_quantum * Vec3d{double(sum.force[0]), double(sum.force[1]), double(sum.force[2])};
    impulses_.push_back({first.wall, to_body(pose, sphere.x), sphere.radius, rotate_back(pose.orientation, impulse),
                         wall_quantum * static_cast<double>(sum.slip)});
  }
  kept_impulses_.clear();
}

}  // namespace gyro

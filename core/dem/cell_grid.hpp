// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/particle_store.hpp"
#include "core/kernels/grid.hpp"

#include <string>

namespace gyro {

/// Owns the search grid: the bounds of particles by the cells in which their centres lie, on a level for each factor 2
/// of radius.
template <class Exec>
class CellGrid {
 public:
  /// Sorts bounds into cells.
  /// @param bounds  of all particles
  /// @throws StoppedByGuard when thousands of particles share a cell
  template <class Real>
  void build(Exec& exec, const ParticleStore<Exec, Real>& rock, const Sphere* bounds) {
    grid_ = layout(exec, bounds, rock.count());
    sort_into_cells(exec, bounds, rock.count());
    expect_no_crowd(exec, rock);
  }

  const Grid& grid() const { return grid_; }

  /// It is not needed until it is built again.
  void release() {
    Exec::release(sorted_);
    Exec::release(begin_);
    Exec::release(sphere_);
    grid_ = {};
  }

 private:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  static Grid layout(Exec& exec, const Sphere* bounds, Index count) {
    Grid grid{};
    const Extent extent = exec.template reduce<Extent>("extent", count, ExtentOf{bounds});
    const Index maximum = 2 * count + 64;
    for (double bound = extent.largest; grid.levels < Grid::max_levels && bound * 1.0000001 >= extent.smallest;
         bound *= 0.5)
      grid.level[grid.levels++].bound = bound;
    const LevelRadii radii = exec.template reduce<LevelRadii>("levels", count, LevelRadiiOf{bounds, grid});
    for (int l = 0; l < grid.levels; ++l) {
      GridLevel& g = grid.level[l];
      g = {g.bound, radii.largest[l], 2 * radii.largest[l], 3, 3, 3, grid.cells};
      if (g.radius > 0) enlarge(g, extent, maximum);
      grid.cells += static_cast<Index>(cells_of(g));
    }
    return grid;
  }

  static std::int64_t cells_of(const GridLevel& g) {
    return std::int64_t{g.mask_x + 1} * (g.mask_y + 1) * (g.mask_z + 1);
  }
  /// Doubles the table in each direction until it covers the particles or holds `maximum` cells.
  static void enlarge(GridLevel& g, const Extent& extent, Index maximum) {
    const auto wanted = [&](double low, double high) { return (high - low) / g.cell + 2; };
    const double x = wanted(extent.low.x, extent.high.x), y = wanted(extent.low.y, extent.high.y),
                 z = wanted(extent.low.z, extent.high.z);
    for (bool grown = true; grown && cells_of(g) < maximum;) {
      grown = false;
      if (g.mask_x + 1 < x && cells_of(g) < maximum) g.mask_x = 2 * g.mask_x + 1, grown = true;
      if (g.mask_y + 1 < y && cells_of(g) < maximum) g.mask_y = 2 * g.mask_y + 1, grown = true;
      if (g.mask_z + 1 < z && cells_of(g) < maximum) g.mask_z = 2 * g.mask_z + 1, grown = true;
    }
  }

  void sort_into_cells(Exec& exec, const Sphere* bounds, Index count) {
    Exec::renew(keys_, static_cast<std::size_t>(count));
    Exec::renew(sorted_, static_cast<std::size_t>(count));
    Exec::renew(begin_, static_cast<std::size_t>(grid_.cells) + 1);
    exec.for_each("cell keys", count, CellKeys{bounds, grid_, keys_.data(), sorted_.data()});
    exec.sort_by_key(keys_, sorted_);
    exec.for_each("cell begins", count + 1, CellBegins{keys_.data(), count, grid_.cells, begin_.data()});
    grid_.cell_begin = begin_.data();
    grid_.sorted = sorted_.data();
    Exec::release(keys_);
    Exec::renew(sphere_, static_cast<std::size_t>(count));
    grid_.sphere = sphere_.data();
    exec.for_each("sort bounds", count, SortBounds{bounds, grid_});
  }

  /// A search costs about 27 times the sum of the squares of the cells' particles. Rock fills a cell with some
  /// tens of its size, with hundreds if it is fast; thousands on average only when particles lie in each other or their
  /// bounds are absurd.
  template <class Real>
  void expect_no_crowd(Exec& exec, const ParticleStore<Exec, Real>& rock) const {
    constexpr double max_in_cell = 4000, little_work = 1e4;
    const Crowd crowd = exec.template reduce<Crowd>("crowd", grid_.cells, CrowdOf{begin_.data()});
    if (crowd.squares <= max_in_cell * larger(static_cast<double>(rock.count()), little_work)) return;
    const auto sorted = Exec::host(sorted_);
    const auto begin = Exec::host(begin_);
    const auto id = Exec::host(rock.particles().id);
    const Index one = sorted[static_cast<std::size_t>(begin[static_cast<std::size_t>(crowd.cell)])];
    throw StoppedByGuard(
        std::to_string(crowd.maximum) + " particles, particle " + std::to_string(id[static_cast<std::size_t>(one)]) +
        " among them, crowd in one cell of the neighbour search; at most some hundreds find room in it");
  }

  Grid grid_{};
  Buffer<std::uint64_t> keys_;
  Buffer<Index> sorted_, begin_;
  Buffer<Sphere> sphere_;
};

}  // namespace gyro

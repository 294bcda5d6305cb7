// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/select.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// One level of the search grid: cells for the spheres whose radius lies between half `bound` and
/// `bound`; the spheres are the bounds of particles (bounds.hpp). The table of cells is a torus: a cell's place is its
/// coordinate modulo a power of two, so that one sphere a kilometre away neither makes the table large nor the search
/// slow. Cells that are far apart may share a place in the table; a search compares the distances of their spheres.
struct GridLevel {
  double bound;                  ///< largest radius that belongs to the level [m]
  double radius;                 ///< largest radius that is there, 0 if none [m]
  double cell;                   ///< edge of a cell, at least 2 radius [m]
  Index mask_x, mask_y, mask_z;  ///< cells in each direction - 1; at least 3, so that neighbours differ
  Index first_cell;              ///< of the level in the table
};

struct CellCoordinate {
  std::int64_t x, y, z;
};

/// All levels, coarse to fine; level l holds the radii (largest 2^-(l+1), largest 2^-l].
struct Grid {
  static constexpr int max_levels = 12;
  GridLevel level[max_levels];
  int levels;
  Index cells;        ///< of all levels
  Index* cell_begin;  ///< into `sorted`, cells + 1 numbers
  Index* sorted;      ///< particles by cell, then in their order
  Sphere* sphere;     ///< their bounds, in the same order

  GYRO_HD int level_of(double radius) const {
    int l = 0;
    while (l + 1 < levels && radius <= level[l + 1].bound) ++l;
    return l;
  }
  GYRO_HD static CellCoordinate coordinate(const GridLevel& g, const Vec3d& x) {
    return {static_cast<std::int64_t>(::floor(x.x / g.cell)), static_cast<std::int64_t>(::floor(x.y / g.cell)),
            static_cast<std::int64_t>(::floor(x.z / g.cell))};
  }
  GYRO_HD static Index place(const GridLevel& g, std::int64_t x, std::int64_t y, std::int64_t z) {
    const Index ix = static_cast<Index>(x & g.mask_x), iy = static_cast<Index>(y & g.mask_y),
                iz = static_cast<Index>(z & g.mask_z);
    return g.first_cell + (iz * (g.mask_y + 1) + iy) * (g.mask_x + 1) + ix;
  }
};

/// Cell of each particle, as a key to sort by.
struct CellKeys {
  const Sphere* bounds;
  Grid grid;
  std::uint64_t* keys;
  Index* values;

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = bounds[n];
    const GridLevel& g = grid.level[grid.level_of(sphere.radius)];
    const CellCoordinate c = Grid::coordinate(g, sphere.x);
    keys[n] = static_cast<std::uint64_t>(Grid::place(g, c.x, c.y, c.z));
    values[n] = n;
  }
};

/// Radii and extent of the bounds, for the levels of the grid.
struct Extent {
  double smallest = 1e300, largest = 0;  ///< radius [m]
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  GYRO_HD friend Extent operator+(const Extent& a, const Extent& b) {
    return {smaller(a.smallest, b.smallest),
            larger(a.largest, b.largest),
            {smaller(a.low.x, b.low.x), smaller(a.low.y, b.low.y), smaller(a.low.z, b.low.z)},
            {larger(a.high.x, b.high.x), larger(a.high.y, b.high.y), larger(a.high.z, b.high.z)}};
  }
};
struct ExtentOf {
  const Sphere* bounds;
  GYRO_HD Extent operator()(Index n) const {
    const Sphere q = bounds[n];
    Extent e;
    e.smallest = e.largest = q.radius;
    if (norm2(q.x) < 1e300) e.low = e.high = q.x;  // a position that is not finite must not shrink the table
    return e;
  }
};

/// Largest radius in each level.
struct LevelRadii {
  double largest[Grid::max_levels] = {};
  GYRO_HD friend LevelRadii operator+(const LevelRadii& a, const LevelRadii& b) {
    LevelRadii r;
    for (int l = 0; l < Grid::max_levels; ++l) r.largest[l] = a.largest[l] > b.largest[l] ? a.largest[l] : b.largest[l];
    return r;
  }
};
struct LevelRadiiOf {
  const Sphere* bounds;
  Grid grid;
  GYRO_HD LevelRadii operator()(Index n) const {
    const double radius = bounds[n].radius;
    LevelRadii r;
    r.largest[grid.level_of(radius)] = radius;
    return r;
  }
};

/// Bounds in the order of cells.
struct SortBounds {
  const Sphere* bounds;
  Grid grid;

  GYRO_HD void operator()(Index s) const { grid.sphere[s] = bounds[grid.sorted[s]]; }
};

/// How particles crowd in cells: what a search would cost.
struct Crowd {
  double squares = 0;  ///< sum over cells of the square of their particles
  Index maximum = 0;   ///< particles in the fullest cell
  Index cell = 0;      ///< the fullest cell
  GYRO_HD friend Crowd operator+(const Crowd& a, const Crowd& b) {
    return {a.squares + b.squares, a.maximum >= b.maximum ? a.maximum : b.maximum,
            a.maximum >= b.maximum ? a.cell : b.cell};
  }
};
struct CrowdOf {
  const Index* cell_begin;
  GYRO_HD Crowd operator()(Index c) const {
    const Index count = cell_begin[c + 1] - cell_begin[c];
    return {static_cast<double>(count) * count, count, c};
  }
};

/// First particle of every cell, from the sorted keys.
struct CellBegins {
  const std::uint64_t* keys;
  Index count, cells;
  Index* cell_begin;

  GYRO_HD void operator()(Index n) const {  // n in [0, count]
    const Index here = n < count ? static_cast<Index>(keys[n]) : cells;
    const Index before = n > 0 ? static_cast<Index>(keys[n - 1]) : -1;
    for (Index c = before + 1; c <= here; ++c) cell_begin[c] = n;
  }
};

}  // namespace gyro

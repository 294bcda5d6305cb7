// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surfaces/triangle.hpp"

namespace gyro {

/// Triangles of a wall in a uniform grid, as kernels see them. The arrays belong to a MeshGrid or
/// its copy on a device.
struct MeshView {
  const WallTriangle* triangles;
  const Index* cell_begin;  ///< first item of each cell, cells in order x fastest, one past the end
  const Index* items;       ///< triangles of all cells, ascending within a cell
  const Index* large;       ///< triangles that span too many cells to be listed there, ascending
  Index large_count;
  Vec3d origin;      ///< lower corner of the grid, body frame [m]
  double cell;       ///< edge of a cell [m]
  Index nx, ny, nz;  ///< cells in each direction
};

/// Cells [first, last] in one direction; none when first > last.
struct CellRange {
  Index first, last;
};

GYRO_HD inline CellRange cells_between(double low, double high, double origin, double cell, Index count) {
  const double first = ::floor((low - origin) / cell), last = ::floor((high - origin) / cell);
  if (!(first < count && last >= 0)) return {0, -1};
  return {first > 0 ? static_cast<Index>(first) : 0, last < count - 1 ? static_cast<Index>(last) : count - 1};
}

/// Calls visit(id) for every triangle that may be within `reach` of the centre; some come more than once.
template <class Visit>
GYRO_HD void visit_near(const MeshView& mesh, const Vec3d& centre, double reach, Visit& visit) {
  for (Index i = 0; i < mesh.large_count; ++i) visit(mesh.large[i]);
  const CellRange x = cells_between(centre.x - reach, centre.x + reach, mesh.origin.x, mesh.cell, mesh.nx);
  const CellRange y = cells_between(centre.y - reach, centre.y + reach, mesh.origin.y, mesh.cell, mesh.ny);
  const CellRange z = cells_between(centre.z - reach, centre.z + reach, mesh.origin.z, mesh.cell, mesh.nz);
  if (x.first > x.last) return;
  for (Index k = z.first; k <= z.last; ++k)
    for (Index j = y.first; j <= y.last; ++j) {
      const Index row = (k * mesh.ny + j) * mesh.nx;  // cells of a row follow one another
      const Index end = mesh.cell_begin[row + x.last + 1];
      for (Index n = mesh.cell_begin[row + x.first]; n < end; ++n) visit(mesh.items[n]);
    }
}

/// Visitor that looks whether a triangle is within reach.
struct AnyNear {
  const WallTriangle* triangles;
  Vec3d centre;
  double reach;
  bool found = false;

  GYRO_HD void operator()(Index id) {
    NearPoint unused;
    if (!found) found = near_triangle(triangles[id], centre, reach, unused) != Place::out_of_reach;
  }
};

/// Visitor that lists the triangles within reach: ascending, each once.
struct ListNear {
  const WallTriangle* triangles;
  Vec3d centre;
  double reach;
  Index* ids;
  Index capacity;
  Index count = 0;
  bool full = false;

  GYRO_HD void operator()(Index id) {
    Index place = count;
    while (place > 0 && ids[place - 1] > id) --place;
    if (place > 0 && ids[place - 1] == id) return;
    NearPoint unused;
    if (near_triangle(triangles[id], centre, reach, unused) == Place::out_of_reach) return;
    if (count == capacity) {
      full = true;
      return;
    }
    for (Index i = count; i > place; --i) ids[i] = ids[i - 1];
    ids[place] = id;
    ++count;
  }
};

/// Lists the triangles nearer than `reach` to the centre, ascending, for use until the next rebuild.
/// @param ids  room for `capacity` numbers
/// @return how many, or capacity + 1 when there is no room for all
GYRO_HD inline Index triangles_near(const MeshView& mesh, const Vec3d& centre, double reach, Index* ids,
                                    Index capacity) {
  ListNear list{mesh.triangles, centre, reach, ids, capacity};
  visit_near(mesh, centre, reach, list);
  return list.full ? capacity + 1 : list.count;
}

/// Visitor that looks whether some triangle surpasses a point.
struct FindSurpassing {
  const WallTriangle* triangles;
  const NearPoint& point;
  Vec3d centre;
  bool found = false;

  GYRO_HD void operator()(Index id) { found = found || surpasses(triangles[id], point, centre); }
};

/// Visitor that offers the points of triangles to a finder.
struct OfferPoint {
  const MeshView& mesh;
  Vec3d centre;
  double radius;
  FindDeepest& finder;

  GYRO_HD void operator()(Index id) {
    NearPoint p;
    const Place place = near_triangle(mesh.triangles[id], centre, radius, p);
    if (place == Place::out_of_reach || !finder.wants(p, place)) return;
    if (place == Place::rim && finder.before.count > 0) {
      FindSurpassing surpassing{mesh.triangles, p, centre};
      visit_near(mesh, centre, radius, surpassing);
      if (surpassing.found) return;
    }
    finder.take(p, place);
  }
};

/// The points of a mesh that a sphere overlaps, as PointsOfTriangles.
struct PointsOfMesh {
  const MeshView& mesh;
  Vec3d centre;
  double radius;

  GYRO_HD void operator()(FindDeepest& finder) const {
    OfferPoint offer{mesh, centre, radius, finder};
    visit_near(mesh, centre, radius, offer);
  }
};

/// Touches of a sphere with a mesh, straight from the grid, in the body frame.
GYRO_HD inline WallTouches touch_mesh(const MeshView& mesh, const Vec3d& centre, double radius) {
  return merged_touches(visible_points(PointsOfMesh{mesh, centre, radius}), radius);
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/surface_map.hpp"

#include "core/walls/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

double area_of(const WallTriangle& t) {
  return 0.5 * norm(cross(t.b - t.a, t.c - t.a));
}

UnrolledGrid grid_over(const std::vector<WallTriangle>& triangles, int rows, int sectors) {
  UnrolledGrid grid{rows, sectors, triangles.front().a.z, triangles.front().a.z};
  for (const WallTriangle& t : triangles)
    for (const Vec3d& corner : {t.a, t.b, t.c}) {
      grid.low = std::min(grid.low, corner.z);
      grid.high = std::max(grid.high, corner.z);
    }
  return grid;
}

}  // namespace

int UnrolledGrid::cell_of(const Vec3d& point) const {
  const double revolution = std::atan2(point.y, point.x) / (2 * std::numbers::pi);
  const int sector = static_cast<int>(std::floor((revolution < 0 ? revolution + 1 : revolution) * sectors));
  const int row = high > low ? static_cast<int>(std::floor((point.z - low) / row_height())) : 0;
  return std::clamp(row, 0, rows - 1) * sectors + std::clamp(sector, 0, sectors - 1);
}

SurfaceMap::SurfaceMap(const TriangleMesh& mesh, int rows, int sectors)
    : mesh_(mesh),
      grid_(grid_over(mesh_.triangles(), rows, sectors)),
      by_triangle_(mesh_.triangles().size()),
      cells_(static_cast<std::size_t>(grid_.cells())) {
  for (const WallTriangle& t : mesh_.triangles()) triangle_area_.push_back(area_of(t));
  measure_cells();
}

/// Cuts each triangle into small ones of equal area and adds each to the cell of its centre.
void SurfaceMap::measure_cells() {
  cell_area_.assign(static_cast<std::size_t>(grid_.cells()), 0.0);
  for (const WallTriangle& t : mesh_.triangles()) {
    const double longest = std::max({norm(t.b - t.a), norm(t.c - t.b), norm(t.a - t.c)});
    const double farthest = std::max({std::hypot(t.a.x, t.a.y), std::hypot(t.b.x, t.b.y), std::hypot(t.c.x, t.c.y)});
    const double fine = 0.1 * std::min(grid_.row_height(), 2 * std::numbers::pi * farthest / grid_.sectors);
    const int cuts = fine > 0 ? std::clamp(static_cast<int>(std::ceil(longest / fine)), 1, 200) : 1;
    const double share = area_of(t) / (double(cuts) * cuts);
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; i + j < cuts; ++j)
        for (const double third : {1.0 / 3, 2.0 / 3}) {  // the upright piece and the one upside down
          if (third > 0.5 && i + j + 1 >= cuts) continue;
          const double u = (i + third) / cuts, v = (j + third) / cuts;
          const auto cell = static_cast<std::size_t>(grid_.cell_of(t.a + u * (t.b - t.a) + v * (t.c - t.a)));
          cell_area_[cell] += share;
        }
  }
}

void SurfaceMap::add(const WallImpulse& given) {
  const Nearest nearest = nearest_triangle(mesh_, given.centre, 2 * given.radius);
  if (nearest.triangle == none) return;
  const double push = -dot(given.impulse, nearest.point.normal);
  by_triangle_.add(static_cast<std::size_t>(nearest.triangle), push, given.slip);
  const Vec3d point = given.centre - nearest.point.height * nearest.point.normal;
  cells_.add(static_cast<std::size_t>(grid_.cell_of(point)), push, given.slip);
}

SurfaceSums SurfaceMap::take_cells() {
  return std::exchange(cells_, SurfaceSums(static_cast<std::size_t>(grid_.cells())));
}

void SurfaceMap::restore(SurfaceSums by_triangle, SurfaceSums cells) {
  by_triangle_ = std::move(by_triangle);
  cells_ = std::move(cells);
}

}  // namespace gyro

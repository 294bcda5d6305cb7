// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surfaces/mesh_grid.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace gyro {
namespace {

/// A triangle counts as without area when rounding of its corners may turn its normal by more than
/// 1e-7 rad: its height is below 2^-52 / 1e-7 of its largest coordinate (2 nm at 1 m).
constexpr double min_height = 2.2e-9;

double largest_coordinate(const Vec3d& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}
constexpr Index cells_per_triangle = 16, largest_span = 512;

bool less(const Vec3d& a, const Vec3d& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

Vec3d low(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3d high(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

struct CornerKey {
  std::array<Vec3d, 3> corners;
  Index triangle;
};

CornerKey key_of(const WallTriangle& t, Index triangle) {
  CornerKey key{{t.a, t.b, t.c}, triangle};
  std::sort(key.corners.begin(), key.corners.end(), less);
  return key;
}

int compare(const CornerKey& a, const CornerKey& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (less(a.corners[i], b.corners[i])) return -1;
    if (less(b.corners[i], a.corners[i])) return 1;
  }
  return 0;
}

/// The cells that a triangle's box covers.
struct Span {
  CellRange x, y, z;
  double count() const { return (x.last - x.first + 1.0) * (y.last - y.first + 1.0) * (z.last - z.first + 1.0); }
};

Span span_of(const MeshView& grid, const WallTriangle& t) {
  const Vec3d l = low(low(t.a, t.b), t.c), h = high(high(t.a, t.b), t.c);
  return {cells_between(l.x, h.x, grid.origin.x, grid.cell, grid.nx),
          cells_between(l.y, h.y, grid.origin.y, grid.cell, grid.ny),
          cells_between(l.z, h.z, grid.origin.z, grid.cell, grid.nz)};
}

/// Calls visit(cell) for the cells of a span that the triangle's plane cuts.
template <class Visit>
void visit_cut(const MeshView& grid, const WallTriangle& t, const Span& span, const Visit& visit) {
  constexpr double slack = 1 + 1e-9;
  const Vec3d n = t.normal;
  const double reach = slack * grid.cell / 2 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  for (Index k = span.z.first; k <= span.z.last; ++k)
    for (Index j = span.y.first; j <= span.y.last; ++j)
      for (Index i = span.x.first; i <= span.x.last; ++i) {
        const Vec3d centre = grid.origin + grid.cell * Vec3d{i + 0.5, j + 0.5, k + 0.5};
        if (std::abs(dot(centre - t.a, n)) <= reach) visit((k * grid.ny + j) * grid.nx + i);
      }
}

}  // namespace

MeshGrid::MeshGrid(const TriangleMesh& shape) {
  take(shape);
  drop_duplicates();
  if (triangles_.empty()) throw BadInput("the mesh has no triangle with an area; at least one is needed");
  choose_cells();
  fill_cells();
}

void MeshGrid::take(const TriangleMesh& shape) {
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Vec3d& v = shape.vertices[i];
    if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
      throw BadInput("vertex " + std::to_string(i) + " of the mesh is not finite; give finite coordinates");
  }
  const auto count = static_cast<Index>(shape.vertices.size());
  triangles_.reserve(shape.triangles.size());
  for (const Vec3<Index>& t : shape.triangles) {
    if (std::min({t.x, t.y, t.z}) < 0 || std::max({t.x, t.y, t.z}) >= count)
      throw BadInput("a triangle of the mesh names a vertex that does not exist; use 0 to " +
                     std::to_string(count - 1));
    const auto corner = [&](Index i) { return shape.vertices[static_cast<std::size_t>(i)]; };
    const Vec3d a = corner(t.x), b = corner(t.y), c = corner(t.z);
    const Vec3d area = cross(b - a, c - a);
    const double longest = std::sqrt(std::max({norm2(b - a), norm2(c - b), norm2(a - c)}));
    const double reach = std::max({largest_coordinate(a), largest_coordinate(b), largest_coordinate(c)});
    if (norm(area) > min_height * reach * longest)
      triangles_.push_back({a, b, c, 1 / norm(area) * area});
    else
      ++degenerate_;
  }
}

void MeshGrid::drop_duplicates() {
  std::vector<CornerKey> keys;
  keys.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) keys.push_back(key_of(triangles_[i], static_cast<Index>(i)));
  std::sort(keys.begin(), keys.end(), [](const CornerKey& a, const CornerKey& b) {
    const int order = compare(a, b);
    return order != 0 ? order < 0 : a.triangle < b.triangle;
  });
  std::vector<bool> dropped(triangles_.size(), false);
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (compare(keys[i - 1], keys[i]) == 0) dropped[static_cast<std::size_t>(keys[i].triangle)] = true;
  std::vector<WallTriangle> kept;
  kept.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (!dropped[i]) kept.push_back(triangles_[i]);
  duplicates_ = static_cast<Index>(triangles_.size() - kept.size());
  triangles_ = std::move(kept);
}

void MeshGrid::choose_cells() {
  Vec3d l = triangles_.front().a, h = l;
  double area = 0;
  for (const WallTriangle& t : triangles_) {
    l = low(l, low(low(t.a, t.b), t.c));
    h = high(h, high(high(t.a, t.b), t.c));
    area += norm(cross(t.b - t.a, t.c - t.a)) / 2;
  }
  const Vec3d size = h - l;
  const double maximum = cells_per_triangle * static_cast<double>(triangles_.size()) + 64;
  const auto cells = [](double extent, double cell) { return std::floor(extent / cell) + 1; };
  cell_ =
      std::max(2 * std::sqrt(area / static_cast<double>(triangles_.size())), 1e-6 * std::max({size.x, size.y, size.z}));
  while (cells(size.x, cell_) * cells(size.y, cell_) * cells(size.z, cell_) > maximum) cell_ *= 1.25;
  origin_ = l;
  nx_ = static_cast<Index>(cells(size.x, cell_));
  ny_ = static_cast<Index>(cells(size.y, cell_));
  nz_ = static_cast<Index>(cells(size.z, cell_));
}

void MeshGrid::fill_cells() {
  const auto cells = static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_);
  cell_begin_.assign(cells + 1, 0);
  const MeshView grid = view();
  std::vector<Index> listed;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Span span = span_of(grid, triangles_[i]);
    if (span.count() > largest_span) {
      large_.push_back(static_cast<Index>(i));
      continue;
    }
    listed.push_back(static_cast<Index>(i));
    visit_cut(grid, triangles_[i], span, [&](Index c) { ++cell_begin_[static_cast<std::size_t>(c) + 1]; });
  }
  for (std::size_t c = 0; c < cells; ++c) cell_begin_[c + 1] += cell_begin_[c];
  items_.resize(static_cast<std::size_t>(cell_begin_[cells]));
  std::vector<Index> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (const Index i : listed) {
    const WallTriangle& t = triangles_[static_cast<std::size_t>(i)];
    visit_cut(grid, t, span_of(grid, t),
              [&](Index c) { items_[static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++)] = i; });
  }
}

MeshView MeshGrid::view() const {
  return {triangles_.data(),
          cell_begin_.data(),
          items_.data(),
          large_.data(),
          static_cast<Index>(large_.size()),
          origin_,
          cell_,
          nx_,
          ny_,
          nz_};
}

std::vector<Index> MeshGrid::candidates(const Vec3d& centre, double reach) const {
  std::vector<Index> found;
  auto collect = [&](Index id) { found.push_back(id); };
  visit_near(view(), centre, reach, collect);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace gyro

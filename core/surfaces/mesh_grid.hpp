// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/scene/scene.hpp"
#include "core/surfaces/mesh.hpp"

#include <vector>

namespace gyro {

/// Triangles of a mesh wall, sorted once into a uniform grid of its body frame.
///
/// The cells follow the triangles' size, at most 16 per triangle, so that neither a needle nor an
/// outlier makes the grid large. A triangle that would enter more than 512 cells is kept apart and
/// always looked at.
class MeshGrid {
 public:
  /// Drops triangles without area and repeated ones, and counts them.
  /// @throws BadInput if a vertex is not finite, an index is out of range or nothing is left
  explicit MeshGrid(const TriangleMesh& shape);

  MeshView view() const;
  /// Triangles that may be nearer than `reach` to a point of the body frame, ascending.
  std::vector<Index> candidates(const Vec3d& centre, double reach) const;

  Index degenerate() const { return degenerate_; }  ///< dropped: no area
  Index duplicates() const { return duplicates_; }  ///< dropped: same corners as another one

  // The arrays behind view(), for a copy on a device.
  const std::vector<WallTriangle>& triangles() const { return triangles_; }
  const std::vector<Index>& cell_begin() const { return cell_begin_; }
  const std::vector<Index>& items() const { return items_; }
  const std::vector<Index>& large() const { return large_; }

 private:
  void take(const TriangleMesh& shape);
  void drop_duplicates();
  void choose_cells();
  void fill_cells();

  std::vector<WallTriangle> triangles_;
  std::vector<Index> cell_begin_, items_, large_;
  Vec3d origin_{0, 0, 0};
  double cell_ = 1;
  Index nx_ = 1, ny_ = 1, nz_ = 1;
  Index degenerate_ = 0, duplicates_ = 0;
};

}  // namespace gyro

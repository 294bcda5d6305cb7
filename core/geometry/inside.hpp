// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <memory>

namespace gyro {

/// Tests whether points lie inside a solid mesh. Safe to call from several threads at the same time.
class InsideTest {
 public:
  /// @param solid closed, normals outwards
  explicit InsideTest(const TriangleMesh& solid);
  ~InsideTest();
  InsideTest(InsideTest&&) noexcept;
  InsideTest& operator=(InsideTest&&) noexcept;

  /// Points on the surface count as inside.
  bool contains(const Vec3d& point) const;
  bool convex() const { return !planes_.empty(); }

  /// The solid lies where dot(normal, x) <= offset.
  struct Plane {
    Vec3d normal;
    double offset;
  };
  /// Planes of the triangles of a convex mesh with few faces; empty for other meshes.
  const std::vector<Plane>& planes() const { return planes_; }

 private:
  struct Tree;
  std::vector<Plane> planes_;   ///< of a convex mesh with few faces: 50 times faster than the tree
  std::unique_ptr<Tree> tree_;  ///< of any other mesh
};

}  // namespace gyro

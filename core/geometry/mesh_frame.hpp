// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <string>

namespace gyro {

/// Transforms a mesh as drawn into the machine's frame: scales, then rotates, then shifts it.
struct MeshFrame {
  double scale = 1;       ///< metres per unit of the drawing
  Vec3d rotate{0, 0, 0};  ///< angles about the fixed axes x, then y, then z, right-handed [rad]
  Vec3d shift{0, 0, 0};   ///< [m]
};

/// x -> shift + Rz Ry Rx (scale x). A frame of defaults changes no bit.
TriangleMesh framed(TriangleMesh mesh, const MeshFrame& frame);

/// Box around a mesh, along the axes [m].
struct Extents {
  Vec3d low, high;
  Vec3d size() const { return high - low; }
  Vec3d middle() const { return 0.5 * (low + high); }
  double largest() const;  ///< longest side
};

/// @param mesh  with at least one vertex
Extents extents_of(const TriangleMesh& mesh);

/// `x -300..300, y -300..300, z 0..400 mm`; in m if an extent is 1 m or more.
std::string to_string(const Extents& extents);

}  // namespace gyro

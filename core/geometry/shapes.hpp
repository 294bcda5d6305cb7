// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <cstdint>

namespace gyro {

/// A rock's shape: a solid of unit volume with its centroid at the origin and its principal axes along x (long), y, z.
struct RockShape {
  TriangleMesh surface;
  Vec3d inertia{0, 0, 0};  ///< principal moments at unit density about the centroid, ascending [m5]
  TriangleMesh preview;    ///< the surface; its convex hull if the surface has more than 2000 triangles
  double sieve_size = 0;   ///< side of the smallest square opening that lets the shape through [m]
};

/// Makes a RockShape of a solid mesh. @param solid closed, normals outwards, of positive volume
RockShape make_shape(const TriangleMesh& solid);

/// Style of procedural rocks. The defaults are those of crushed aggregate.
struct ShapeStyle {
  struct Interval {
    double low, high;
  };
  Interval elongation{0.65, 0.95};  ///< intermediate / long axis b/a of the rock's ellipsoid, uniformly distributed [-]
  Interval flatness{0.65, 0.95};    ///< short / intermediate axis c/b, uniformly distributed [-]
  /// Number of points of the hull [-]. 0: 40 to 80, rounded; 0.5: 16 to 32; 1: 6 to 13, sharp.
  double angularity = 0.5;
  double roughness = 0;  ///< deviation of the surface from the polyhedron / radius; 0: flat faces [-]
};

/// @throws BadInput unless 0 < low <= high <= 1 for both intervals, angularity is in [0, 1] and roughness in [0, 0.3]
void check_style(const ShapeStyle& style);

/// A random polyhedron like crushed rock: the hull of points that are evenly spread on an ellipsoid and
/// jittered along it and across it, and roughened if the style says so.
/// @param number  of the shape; with the seed, the key of the random draws
RockShape procedural_shape(std::uint64_t seed, std::uint64_t number, const ShapeStyle& style = {});

/// A cylinder, as a laboratory specimen: a prism of 64 sides with the section of the circle. Its axis is x if it is
/// longer than 0.87 diameters, else z, because the long principal axis is x.
/// @param slenderness length / diameter, above 0
/// @param loading_angle between the lines from the axis to the edges of each of two flats along the side, which face y;
/// 0 to 1 rad
RockShape cylinder_shape(double slenderness, double loading_angle = 0);

/// A convex polyhedron of at most `corners` corners (but at least 4) around a scan: the hull of the points that are
/// outermost in evenly spread directions. With many corners it is the hull of all points, which is the boundary of
/// their Delaunay triangulation.
TriangleMesh coarse_polyhedron(const TriangleMesh& scan, int corners);

}  // namespace gyro

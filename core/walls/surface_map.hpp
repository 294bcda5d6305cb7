// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"
#include "core/surfaces/mesh_grid.hpp"

#include <vector>

namespace gyro {

/// A surface unrolled about its z axis: rows of equal height from the lowest point to the highest, sectors of
/// equal azimuth from 0 on. Cell = row x sectors + sector.
struct UnrolledGrid {
  int rows = 32, sectors = 72;
  double low = 0, high = 0;  ///< of the surface [m]

  int cells() const { return rows * sectors; }
  int cell_of(const Vec3d& point) const;
  double row_height() const { return (high - low) / rows; }
};

/// Sums of the rock's action on the pieces of a surface.
struct SurfaceSums {
  std::vector<double> impulse;  ///< normal, into the wall [N s]
  std::vector<double> work;     ///< of sliding friction [J]

  explicit SurfaceSums(std::size_t pieces) : impulse(pieces, 0.0), work(pieces, 0.0) {}
  /// @param push  normal impulse [N s]  @param slip  work of sliding friction [J]
  void add(std::size_t piece, double push, double slip) {
    impulse[piece] += push;
    work[piece] += slip;
  }
};

/// Maps of the pressure and of the sliding work of rock on a liner, per triangle and unrolled. They use the wall's
/// frame, so that the map of a mantle rotates with it. The impulse of a sphere is added to the triangle nearest to its
/// centre; only the component along the line from the nearest point to the centre counts.
class SurfaceMap {
 public:
  /// @param mesh  the surface; for a profile, the mesh of its picture
  SurfaceMap(const TriangleMesh& mesh, int rows, int sectors);

  void add(const WallImpulse& impulse);
  /// Returns the sums since the last call, by cell, and clears them.
  SurfaceSums take_cells();

  const UnrolledGrid& grid() const { return grid_; }
  const std::vector<double>& cell_area() const { return cell_area_; }          ///< [m2]
  const std::vector<double>& triangle_area() const { return triangle_area_; }  ///< [m2]
  /// The triangles of the mesh that have an area, in their order.
  const std::vector<WallTriangle>& triangles() const { return mesh_.triangles(); }
  const SurfaceSums& by_triangle() const { return by_triangle_; }  ///< since the start
  void restore(SurfaceSums by_triangle, SurfaceSums cells);
  const SurfaceSums& cells() const { return cells_; }

 private:
  void measure_cells();

  MeshGrid mesh_;
  UnrolledGrid grid_;
  std::vector<double> cell_area_, triangle_area_;
  SurfaceSums by_triangle_, cells_;
};

/// Wear depth by Archard's law [m]: coefficient x normal force x sliding distance / area = coefficient x work /
/// (friction x area); 0 without friction or area.
/// @param coefficient  volume worn / (normal force x distance) [1/Pa]
/// @param work         of sliding friction [J]
/// @param friction     coefficient of sliding friction [-]
/// @param area         [m2]
inline double wear_depth(double coefficient, double work, double friction, double area) {
  return friction > 0 && area > 0 ? coefficient * work / (friction * area) : 0;
}

}  // namespace gyro

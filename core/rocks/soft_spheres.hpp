// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <vector>

namespace gyro {

/// Shortest difference between images in a periodic cube.
Vec3d nearest_image(const Vec3d& d, double side);

/// A convex container of spheres around the origin.
struct Vessel {
  struct Face {
    Vec3d normal;   ///< outwards
    double offset;  ///< of the face along the normal
  };
  std::vector<Face> faces;
  double volume = 0;
  double reach = 0;  ///< distance of the farthest corner from the origin
};

/// Scales a vessel about the origin.
void scale(Vessel& vessel, double factor);

/// Soft spheres in a periodic cube, or in a vessel, that relax to rest. The unit of length is the smallest radius.
///
/// Two spheres repel each other with the force 2 R* overlap, R* = Ri Rj/(Ri + Rj), and a sphere has the mass Ri. So all
/// overlaps under one pressure are similar relative to the radii, and all contacts have similar frequencies. With
/// cohesion, spheres closer than `reach` attract each other with 2 R* cohesion (1 - gap/reach). A face of a vessel
/// repels with 2 Ri overlap. Neighbour lists contain pairs whose gap is below `list_skin`; it affects the speed and the
/// last bits of the result.
class SoftSpheres {
 public:
  /// @param side       period of the cube [smallest radius]
  /// @param list_skin  skin of the neighbour lists [smallest radius]
  SoftSpheres(std::vector<Vec3d> centres, std::vector<double> radii, double side, double list_skin);
  /// @param centres inside the vessel
  SoftSpheres(std::vector<Vec3d> centres, std::vector<double> radii, Vessel vessel, double list_skin);

  /// Relaxes (FIRE: Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201, with its parameters) until no force exceeds the
  /// tolerance or no overlap exceeds the limit. @return false if max_steps were not enough
  bool settle(double force_tolerance, int max_steps, double overlap_limit = 0);

  /// Scales all positions, the cube and the vessel, but not the radii.
  void scale(double factor);
  /// @param cohesion  force of spheres in contact / (2 R*)  @param reach  gap at which the attraction ends
  void set_cohesion(double cohesion, double reach) { cohesion_ = cohesion, reach_ = reach; }

  /// Largest (overlap/smaller radius) of all pairs, and of spheres and faces.
  double largest_overlap() const;
  /// Factor on all distances, at least 1, that reduces every overlap to the limit [smaller radius].
  double growth_to(double overlap) const;
  /// Volume of the spheres / volume of the cube or vessel.
  double fraction() const;
  /// Side of the cube, or of a cube with the volume of the vessel.
  double side() const;
  const std::vector<Vec3d>& centres() const { return x_; }
  const std::vector<double>& radii() const { return radii_; }

 private:
  struct Pair {
    Index i, j;
  };
  struct Touch {
    Index i;
    std::size_t face;
  };
  void find_pairs();
  void add_if_close(Index j, Index i);
  void find_touches();
  double depth(const Touch& touch) const;
  void move();
  bool moved_too_far() const;
  void update_forces();
  double largest_force() const;

  double side_;  ///< period; with a vessel it is so long that images do not interact
  Vessel vessel_;
  double skin_, largest_radius_ = 1, cohesion_ = 0, reach_ = 0;
  std::vector<double> radii_;
  std::vector<Vec3d> x_, v_, force_, x_listed_;  ///< x_listed_: positions when the lists were made
  std::vector<Pair> pairs_;
  std::vector<Touch> touches_;
  double dt_ = 0.1, mixing_ = 0.1;  ///< of FIRE
  int downhill_ = 0;
};

}  // namespace gyro

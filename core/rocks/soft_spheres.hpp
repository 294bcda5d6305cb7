// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <vector>

namespace gyro {

/// Shortest difference between images in a periodic cube.
Vec3d nearest_image(const Vec3d& d, double side);

/// A convex room that spheres are held in, around the origin.
struct Vessel {
  struct Face {
    Vec3d normal;   ///< outwards
    double offset;  ///< of the face along the normal
  };
  std::vector<Face> faces;
  double volume = 0;
  double reach = 0;  ///< of the furthest corner
};

/// Makes a vessel larger about the origin.
void scale(Vessel& vessel, double factor);

/// Soft spheres in a periodic cube, or in a vessel, on their way to rest. The unit of length is the smallest radius.
///
/// Two spheres push with 2 R* overlap, R* = Ri Rj/(Ri + Rj), and a sphere has the mass Ri: under one pressure all
/// overlaps are then alike relative to the radii, and all contacts vibrate alike. Closer than `reach` they pull with
/// 2 R* cohesion (1 - gap/reach), if they are told to. A face of a vessel pushes with 2 Ri overlap. Pair lists hold
/// what is closer than `list_margin`, which changes speed and the last bits.
class SoftSpheres {
 public:
  SoftSpheres(std::vector<Vec3d> centres, std::vector<double> radii, double side, double list_skin);
  /// @param centres inside the vessel
  SoftSpheres(std::vector<Vec3d> centres, std::vector<double> radii, Vessel vessel, double list_skin);

  /// Goes downhill (FIRE: Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201, its parameters) until no force exceeds the
  /// tolerance or no overlap the limit. @return whether it got there in so many steps
  bool settle(double force_tolerance, int max_steps, double overlap_limit = 0);

  /// Brings everything closer or further apart.
  void scale(double factor);
  void set_cohesion(double cohesion, double reach) { cohesion_ = cohesion, reach_ = reach; }

  /// Largest (overlap/smaller radius) of all pairs, and of spheres and faces.
  double largest_overlap() const;
  /// Factor on all distances, at least 1, that leaves no overlap above the limit [smaller radius].
  double growth_to(double overlap) const;
  /// Volume of the spheres / volume of the cube or vessel.
  double fraction() const;
  /// Of the cube, or of one as large as the vessel.
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

  double side_;  ///< of the period; with a vessel so long that no images meet
  Vessel vessel_;
  double margin_, largest_radius_ = 1, cohesion_ = 0, reach_ = 0;
  std::vector<double> radii_;
  std::vector<Vec3d> x_, v_, force_, listed_;
  std::vector<Pair> pairs_;
  std::vector<Touch> touches_;
  double dt_ = 0.1, mixing_ = 0.1;  ///< of FIRE
  int downhill_ = 0;
};

}  // namespace gyro

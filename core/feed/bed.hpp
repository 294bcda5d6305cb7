// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <cstdint>
#include <vector>

namespace gyro {

/// The spheres of a scene, for searches by position. Sizes may differ widely, because there is a hashed grid for each
/// power of two of the radius.
class Bed {
 public:
  /// @param centre, radius  [m]
  void add(const Vec3d& centre, double radius);
  std::size_t size() const { return spheres_.size(); }

  /// The height to which a sphere at this position must be raised so that it no longer overlaps one sphere of the bed
  /// [m]; its own height if it overlaps none. Repeated until it no longer changes, this gives the lowest free height,
  /// in any order of the spheres.
  /// @param gap  minimum distance between the surfaces [m]
  double raised(const Vec3d& centre, double radius, double gap) const;

  /// Numbers of the spheres that a sphere at this position overlaps; the first sphere added has the number 0.
  std::vector<Index> overlapped(const Vec3d& centre, double radius) const;

 private:
  struct Sphere {
    Vec3d centre;
    double radius;
  };
  struct Level {
    int number;      ///< its spheres have radii of up to 2^number [m]
    double cell;     ///< edge, twice the largest radius of the level [m]
    double largest;  ///< radius so far [m]
  };

  /// Calls visit(number, distance at which the surfaces are `gap` apart) for the spheres nearer than that, until
  /// it returns true; in any order.
  template <class Visit>
  void visit_near(const Vec3d& centre, double radius, double gap, const Visit& visit) const;
  /// Number of cells that a search covers.
  double cells_near(double radius, double gap) const;
  const Level& level_of(double radius) const;
  std::size_t bucket(std::uint32_t hash) const { return (hash ^ (hash >> 15)) & (first_.size() - 1); }
  void link(Index sphere);

  std::vector<Sphere> spheres_;
  std::vector<Index> first_ = std::vector<Index>(1024, none);  ///< by bucket; a power of two of them
  std::vector<Index> next_;                                    ///< by sphere: the next one in its bucket
  std::vector<Level> levels_;                                  ///< from the largest to the smallest
};

}  // namespace gyro

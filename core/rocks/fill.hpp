// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/inside.hpp"
#include "core/geometry/shapes.hpp"
#include "core/rocks/bonds.hpp"
#include "core/rocks/packing.hpp"

#include <array>
#include <cstdint>
#include <variant>

namespace gyro {

/// A shape of unit volume with its inside test, for any number of fillings.
struct Mould {
  explicit Mould(RockShape s) : shape(std::move(s)), inside(shape.surface) {}
  RockShape shape;
  InsideTest inside;
};

/// Spheres that fill a unit-volume shape, in the shape's frame and unit, in the order of a Morton curve.
struct Filling {
  std::vector<Vec3d> centres;
  std::vector<double> radii;
};

/// Equal spheres. Their diameter is the equal-volume diameter of the rock / ratio, or more with a floor: see
/// particle_diameter().
struct MonoFill {
  /// cut: from a packing, with a rough surface like that of broken rock. smooth: jammed inside the shape, which must be
  /// convex, so that spheres support the whole of a face, as in a ground specimen; the particle diameter is within 1 %
  /// of the given one, or within 2 % if there are fewer than 50 particles.
  enum class Surface { cut, smooth };
  double ratio = 6;  ///< [-]
  Surface surface = Surface::cut;
  double floor = 0;  ///< diameter that particles have at least, as far as the rock is coarse enough [m]; 0: none
};

/// A floor leaves a rock at least this ratio, a choice: a rock of ratio 3 has some 16 particles, one of ratio 2 five.
inline constexpr double min_graded_ratio = 3;

/// Diameter of the particles of a rock of diameter d [m]: max(d / ratio, min(floor, d / 3)). Rocks of up to 3 floors
/// have the ratio 3, those from ratio x floor on the given ratio, and those between particles of the floor's size.
double particle_diameter(const MonoFill& mono, double diameter);

/// Spheres of a range of sizes, the same for all rocks: the share of their volume that is finer than the diameter x
/// grows as x^exponent. The largest sphere of a rock is at most a third of the rock's diameter.
struct RangeFill {
  double smallest = 0, largest = 0;  ///< diameters [m]
  double exponent = 0.8;             ///< [-]; 0.8 puts 20,000 particles of 8 to 45 mm into a rock of 500 mm
};

using FillRule = std::variant<MonoFill, RangeFill>;

/// Limits of the fill ratio: about 5 and 80,000 particles.
inline constexpr double min_fill_ratio = 2, max_fill_ratio = 50;
/// Limit of largest/smallest diameter of a range; the number of particles in a packing grows with its third power.
inline constexpr double max_size_ratio = 8;
/// Largest number of particles in one rock.
inline constexpr double max_particles = 100000;

/// @throws BadInput if a number is out of range
void check_rule(const FillRule& rule);

/// The rock that is filled.
struct FillJob {
  double diameter = 1;  ///< of the sphere of its solid volume [m]; a fill by ratio alone does not use it
  std::uint64_t seed = 0;
  std::uint64_t rock = 0;  ///< number of the rock; with the seed, the key of the random draws
};

/// Puts the shape into a jammed packing, at a random position and orientation, and takes the spheres whose centre is
/// inside. On average the rock has the packing fraction of the packing, up to its surface. Of
/// sixteen cuts (four if there are thousands of spheres) it uses the one whose mass and inertia are nearest to those of
/// the shape filled evenly; spheres not bonded to the largest piece are dropped. A smooth fill is not cut.
/// @throws BadInput if the rule is out of range, a smooth shape is not convex, the rock is too small or too large for
/// the range, or the bonded spheres are not in one piece because the shape is too thin or the gap too small
Filling fill(const Mould& mould, const FillRule& rule, const BondRule& bonds, const FillJob& job);

/// The grading [smallest radius] of the packing from which a rock of this diameter [m] is cut. Its largest radius is
/// rounded down to a class, so that rocks of similar size share a packing.
/// @throws BadInput if the rock is too small or too large for the range
Grading grading_of(const RangeFill& range, double diameter);

/// Inertia tensor {xx, yy, zz, xy, yz, zx} of spheres of one density about their centre of mass [kg m2].
std::array<double, 6> sphere_inertia(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     double density);

/// Centre of mass of spheres of one density, in the unit of the centres.
Vec3d centre_of_mass(const std::vector<Vec3d>& centres, const std::vector<double>& radii);

/// Sum of the volumes of the spheres; overlaps count twice [cube of the unit of the radii].
double sphere_volume(const std::vector<double>& radii);

}  // namespace gyro

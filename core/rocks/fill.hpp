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

/// A shape of unit volume, ready to be filled any number of times.
struct Mould {
  explicit Mould(RockShape s) : shape(std::move(s)), inside(shape.surface) {}
  RockShape shape;
  InsideTest inside;
};

/// Spheres that fill a unit-volume shape, in the shape's frame, along a Morton curve.
struct Filling {
  std::vector<Vec3d> centres;
  std::vector<double> radii;
};

/// Equal spheres: diameter = equal-volume diameter of the rock / ratio.
struct MonoFill {
  /// cut: from a packing, as rock breaks. smooth: jammed inside the shape, which must be convex, so that all of its
  /// faces bear, as those of ground specimens do; the diameter comes out within 1 %, below 50 particles within 2 %.
  enum class Surface { cut, smooth };
  double ratio = 6;
  Surface surface = Surface::cut;
};

/// Spheres of many sizes, the same for all rocks: of their volume, the share that is finer than the diameter x grows as
/// x^exponent. A rock's own largest sphere is at most a third of its diameter.
struct RangeFill {
  double smallest = 0, largest = 0;  ///< diameters [m]
  double exponent = 0.8;             ///< [-]; 0.8 puts 20,000 particles of 8 to 45 mm into a rock of 500 mm
};

using FillRule = std::variant<MonoFill, RangeFill>;

/// Smallest and largest fill ratio on offer: about 5 and 80,000 particles.
inline constexpr double min_fill_ratio = 2, greatest_fill_ratio = 50;
/// Largest (largest/smallest diameter) of a range: packings grow with its third power.
inline constexpr double greatest_size_ratio = 8;
/// More particles than this are no rock.
inline constexpr double max_particles = 100000;

/// @throws BadInput numbers out of range
void check_rule(const FillRule& rule);

/// Which rock is filled.
struct FillJob {
  double diameter = 1;  ///< of the sphere of its solid volume [m]; of no effect on a mono-sized fill
  std::uint64_t seed = 0;
  std::uint64_t rock = 0;  ///< its number under this seed
};

/// Fills the shape with those spheres of a jammed packing, laid at a random place and turn, whose centre lies inside.
/// So there is no thin layer at the surface, and on average as large a share of the volume as in the packing. Of
/// sixteen cuts (four where there are thousands of spheres) the one is kept whose mass and inertia are nearest to that
/// of the full packing in the shape; spheres not bonded to the largest piece are left out. A smooth fill is not cut.
/// @throws BadInput rule out of range; smooth shape not convex; rock too small or too large for the range; shape so
/// thin or gap so small that the spheres do not hold together
Filling fill(const Mould& mould, const FillRule& rule, const BondRule& bonds, const FillJob& job);

/// The grading of the packing that a rock of this diameter is cut from [smallest radius], its largest radius rounded
/// down to a class, so that rocks of like size share a packing. @throws BadInput rock too small or too large for the
/// range
Grading grading_of(const RangeFill& range, double diameter);

/// Inertia tensor {xx, yy, zz, xy, yz, zx} of spheres of one density about their centre of mass [kg m2].
std::array<double, 6> sphere_inertia(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     double density);

/// Centre of mass of spheres of one density.
Vec3d centre_of_mass(const std::vector<Vec3d>& centres, const std::vector<double>& radii);

/// Sum of the volumes of the spheres; overlaps count twice.
double sphere_volume(const std::vector<double>& radii);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/inside.hpp"
#include "core/geometry/shapes.hpp"
#include "core/rocks/bonds.hpp"

#include <array>
#include <cstdint>

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

/// Smallest and largest fill ratio on offer: about 5 and 80,000 particles.
inline constexpr double least_fill_ratio = 2, greatest_fill_ratio = 50;

/// Fills the shape with equal spheres of diameter (equal-volume diameter of the shape)/ratio: those spheres
/// of the jammed packing, at a random place and turn, whose centre lies inside. So there is no thin
/// layer at the surface, and on average fraction x ratio^3 spheres. Of sixteen cuts the one is kept whose mass and
/// inertia are nearest to that of the full packing in the shape; spheres not bonded to the largest
/// piece are left out.
/// @param rock number of the rock under this seed
/// @throws BadInput ratio out of range; shape so thin or gap so small that the spheres do not hold together
Filling fill_mono(const Mould& mould, double ratio, const BondRule& rule, std::uint64_t seed, std::uint64_t rock);

/// Inertia tensor {xx, yy, zz, xy, yz, zx} of spheres of one density about their centre of mass [kg m2].
std::array<double, 6> sphere_inertia(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     double density);

/// Centre of mass of spheres of one density.
Vec3d centre_of_mass(const std::vector<Vec3d>& centres, const std::vector<double>& radii);

/// Sum of the volumes of the spheres; overlaps count twice.
double sphere_volume(const std::vector<double>& radii);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <string>
#include <vector>

namespace gyro {

/// A bond of a rock template, between two of its particles.
struct TemplateBond {
  Index i, j;     ///< particles, i < j
  double length;  ///< distance of the centres in the unloaded rock, L0 [m]
  double radius;  ///< radius of the bond's circular section, Rb [m]
};

/// A meta-particle: a rock as a bonded packing of spheres at rest. Its own frame has its origin in the centre
/// of mass. The feed makes any number of rocks from one template.
struct RockTemplate {
  std::string name;
  double diameter = 0;               ///< of the sphere of equal solid volume [m]
  double solid_volume = 0;           ///< of the shape [m3]
  double sieve_size = 0;             ///< smallest square mesh that lets the shape through [m]
  std::vector<Vec3d> centres;        ///< of the particles [m]
  std::vector<double> radii;         ///< [m]
  double particle_density = 0;       ///< [kg/m3], the same for all particles of the template
  std::vector<TemplateBond> bonds;   ///< grouped by colour: two of one colour share no particle
  std::vector<Index> colour_begin;   ///< first bond of each colour; the last entry is the number of bonds
  double bounding_radius = 0;        ///< of the sphere about the centre of mass that contains all particles [m]
  double packing_fraction = 0;       ///< volume of the particles / solid volume [-]
  double coordination = 0;           ///< mean number of bonds of a particle [-]
  double mass_error = 0;             ///< (mass of particles - mass of solid rock) / mass of solid rock [-]
  double inertia_error = 0;          ///< largest relative error of a principal moment of inertia [-]
  double centre_error = 0;           ///< distance of the particles' centre of mass from the solid's / diameter [-]
  double critical_step = 0;          ///< stability limit of the damped step map, with bonds and bed contacts [s]
  double bond_step = 0;              ///< the same of bonds alone [s]
  int substeps = 0;                  ///< of rocks made from it, as NewRock::substeps; not part of a library file
  Index load_table = none;           ///< likewise, as NewRock::load_table
  std::vector<Vec3d> hull_vertices;  ///< surface of the shape (of a fine scan: its convex hull), for pictures [m]
  std::vector<Vec3<Index>> hull_faces;
};

/// The library of a case. Sorted by diameter.
struct RockLibrary {
  std::vector<RockTemplate> rocks;
  double seconds = 0;  ///< wall time of making or reading [s]
  bool from_cache = false;
  std::vector<std::string> notes;  ///< repairs of given shapes, for the log
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/bonds.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/stability.hpp"

#include <vector>

namespace gyro::small_rocks {

inline constexpr double kn = 1.67e12, ks = 6.67e11, rho = 2600;
inline const BedContacts no_bed{};

inline BondParameters bonds_with(double damping) {
  return {kn, ks, 36e6, 24e6, damping};
}

inline RockTemplate spheres(std::vector<Vec3d> centres, std::vector<double> radii, const BondRule& rule) {
  RockTemplate rock;
  rock.centres = std::move(centres);
  rock.radii = std::move(radii);
  rock.particle_density = rho;
  rock.bonds = make_bonds(rock.centres, rock.radii, rule);
  return rock;
}

inline RockTemplate pair(double radius, double bond) {
  return spheres({{0, 0, 0}, {2 * radius, 0, 0}}, {radius, radius}, {0.05, AbsoluteBondRadius{bond}});
}

/// A procedural rock of particles of one diameter.
inline RockTemplate cluster(double ratio, double particle, const BondRule& rule, int number = 0) {
  const Filling f =
      fill(Mould(procedural_shape(1, number)), MonoFill{ratio}, rule, {1, 42, static_cast<std::uint64_t>(number)});
  const double scale = particle / (2 * f.radii[0]);
  std::vector<Vec3d> centres;
  for (const Vec3d& c : f.centres) centres.push_back(scale * c);
  return spheres(centres, std::vector<double>(centres.size(), particle / 2), rule);
}

}  // namespace gyro::small_rocks

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <algorithm>

namespace gyro {

/// A recipe of five small rocks of three shapes.
inline LibraryRecipe small_recipe() {
  LibraryRecipe recipe;
  recipe.shapes = ProceduralShapes{3};
  recipe.sizes = PassingTable{{{0.05, 0}, {0.5, 1}}};
  recipe.samples = 5;
  recipe.fill = MonoFill{4};
  recipe.rock_density = 2600;
  recipe.bond_parameters = {1.67e12, 6.67e11, 36e6, 24e6, 0.05};
  recipe.bed = {6, 5e8, 4e8, 0.3, 0.3};
  recipe.seed = 42;
  return recipe;
}

template <class T>
bool same_vectors(const std::vector<Vec3<T>>& a, const std::vector<Vec3<T>>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec3<T>& p, const Vec3<T>& q) { return p.x == q.x && p.y == q.y && p.z == q.z; });
}

inline bool same_bond(const TemplateBond& a, const TemplateBond& b) {
  return a.i == b.i && a.j == b.j && a.length == b.length && a.radius == b.radius;
}

/// Whether two rocks are equal in every member, to the last bit.
inline bool same_rock(const RockTemplate& a, const RockTemplate& b) {
  return a.name == b.name && a.diameter == b.diameter && a.solid_volume == b.solid_volume &&
         a.sieve_size == b.sieve_size && same_vectors(a.centres, b.centres) && a.radii == b.radii &&
         a.particle_density == b.particle_density &&
         std::equal(a.bonds.begin(), a.bonds.end(), b.bonds.begin(), b.bonds.end(), same_bond) &&
         a.colour_begin == b.colour_begin && a.bounding_radius == b.bounding_radius &&
         a.packing_fraction == b.packing_fraction && a.coordination == b.coordination && a.mass_error == b.mass_error &&
         a.inertia_error == b.inertia_error && a.centre_error == b.centre_error && a.critical_step == b.critical_step &&
         a.bond_step == b.bond_step && same_vectors(a.hull_vertices, b.hull_vertices) &&
         same_vectors(a.hull_faces, b.hull_faces);
}

/// Whether two libraries have the same rocks and notes.
inline bool same_library(const RockLibrary& a, const RockLibrary& b) {
  return a.notes == b.notes && std::equal(a.rocks.begin(), a.rocks.end(), b.rocks.begin(), b.rocks.end(), same_rock);
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only: which contact laws and constants a scene asks for.
#include "core/base/errors.hpp"
#include "core/laws/contact/constants.hpp"
#include "core/scene/scene.hpp"

namespace gyro {

inline const PairProperties& pair_of(const Scene& scene, Index a, Index b) {
  return scene.pairs[static_cast<std::size_t>(a) * scene.materials.size() + static_cast<std::size_t>(b)];
}

/// Constants of the contact of two materials of a scene.
template <class Real>
ContactConstants<Real> contact_constants(const Scene& scene, Index a, Index b) {
  return contact_constants<Real>(scene.materials[static_cast<std::size_t>(a)],
                                 scene.materials[static_cast<std::size_t>(b)], pair_of(scene, a, b), scene.dt,
                                 scene.damping_cap);
}

/// The contact law of rock on rock. Without rolling friction no rolling law is compiled in.
inline ContactModel rock_model(const Scene& scene) {
  const PairProperties& pair = pair_of(scene, scene.rock_material, scene.rock_material);
  return {pair.model.normal, pair.rolling_friction > 0 ? pair.model.rolling : RollingModel::off};
}

/// The contact law of rock on the walls, which is the same for all of them: one kernel serves all walls.
/// @throws BadInput when two walls have different laws
inline ContactModel wall_model(const Scene& scene) {
  ContactModel all{NormalModel::hertz, RollingModel::off};
  const Wall* first = nullptr;
  for (const Wall& wall : scene.walls) {
    const PairProperties& pair = pair_of(scene, scene.rock_material, wall.material);
    if (first == nullptr) all.normal = pair.model.normal;
    const bool rolls = pair.rolling_friction > 0, rolled = all.rolling != RollingModel::off;
    if (pair.model.normal != all.normal || (rolls && rolled && pair.model.rolling != all.rolling))
      throw BadInput("walls " + first->name + " and " + wall.name + " have different contact laws with rock; " +
                     "give all rock/wall pairs the same normal and rolling law");
    if (rolls) all.rolling = pair.model.rolling;
    if (first == nullptr) first = &wall;
  }
  return all;
}

}  // namespace gyro

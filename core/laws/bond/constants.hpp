// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/laws/bond/bond.hpp"
#include "core/laws/contact/scene_contacts.hpp"

namespace gyro {

/// Constants of the bonds of a scene that has them. The friction of a pressed bond is that of rock on rock.
inline BondConstants<double> bond_constants(const Scene& scene) {
  return {*scene.bonds, pair_of(scene, scene.rock_material, scene.rock_material).friction, scene.dt};
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/fragment_table.hpp"

#include <cstdint>

namespace gyro {

/// What a run says of a fragment: of one that leaves, at that moment, or of one that is there at the end.
struct FragmentRecord {
  enum Place : std::uint8_t { in_chamber = 0, discharged = 1, escaped = 2 };

  double time = 0;           ///< [s]
  ParticleId id = 0;         ///< number of the fragment: the lowest id in it
  RockId rock = 0;           ///< of which it is a part
  Index particles = 0;       ///< number of particles
  double mass = 0;           ///< [kg]
  double size = 0;           ///< sieve size [m]
  Vec3d position{0, 0, 0};   ///< centre of mass [m]
  Vec3d velocity{0, 0, 0};   ///< of the centre of mass [m/s]
  double fed = 0;            ///< time at which its rock came into the scene [s]
  Place place = in_chamber;  ///< where it is
};

/// The record of a row of the table, without time, place and `fed`. @param rock_density  of solid rock [kg/m3]
FragmentRecord record_of(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles,
                         double rock_density);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/snapshots.hpp"

#include <cmath>

namespace gyro {

/// Particles whose numbers follow from their index and a time.
inline ParticleSnapshot particles_at(double time, std::size_t count) {
  ParticleSnapshot s;
  for (std::size_t p = 0; p < count; ++p) {
    const auto number = static_cast<double>(p);
    s.id.push_back(static_cast<std::uint32_t>(10 + p));
    s.rock.push_back(static_cast<Index>(p / 4));
    s.fragment.push_back(static_cast<Index>(p / 2 * 2));
    s.position.push_back({number, time, number * time});
    s.velocity.push_back({0, std::sin(number + time), 1});
    s.angular_velocity.push_back({0, 0, 0});
    s.force.push_back({time, 0, number});
    s.radius.push_back(0.25);
    s.mass.push_back(2);
  }
  return s;
}

/// Bonds between neighbours in the sequence of particles.
inline BondSnapshot bonds_at(double time, std::size_t count) {
  BondSnapshot s;
  for (std::size_t b = 0; b < count; ++b) {
    s.i.push_back(static_cast<Index>(b));
    s.j.push_back(static_cast<Index>(b + 1));
    s.normal_force.push_back(time * static_cast<double>(b));
    s.stress_ratio.push_back(0.5);
    s.radius.push_back(0.125);
  }
  return s;
}

inline PosedWall wall_at(double height, Index number) {
  return {{{{0, 0, height}, {1, 0, height}, {0, 1, height}, {1, 1, height}}, {{0, 1, 2}, {1, 3, 2}}}, number, {}};
}

}  // namespace gyro

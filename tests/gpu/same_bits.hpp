// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/catch.hpp"
#include "tests/gpu/breaking_scene.hpp"

#include <cstring>

namespace gyro::test {

/// Bytes of numbers without gaps between them: tells -0 from 0, and holds for NaN.
template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool same_breakages(const std::vector<Breakage>& a, const std::vector<Breakage>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Breakage& x, const Breakage& y) {
    return x.time == y.time && x.mode == y.mode && norm2(x.position - y.position) == 0 && x.rock == y.rock &&
           x.i == y.i && x.j == y.j && x.energy == y.energy;
  });
}

inline bool same_extremes(const std::vector<Extremes>& a, const std::vector<Extremes>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Extremes& x, const Extremes& y) {
    return x.finite == y.finite && x.culprit == y.culprit && x.overlap_ratio == y.overlap_ratio &&
           x.speed_ratio == y.speed_ratio && x.rotation == y.rotation && x.partner == y.partner && x.wall == y.wall &&
           x.fastest == y.fastest && x.fastest_rotating == y.fastest_rotating && x.bond_rotation == y.bond_rotation &&
           x.twisted == y.twisted && x.wall_step == y.wall_step && x.fast_wall == y.fast_wall;
  });
}

inline void check_same(const Outcome& a, const Outcome& b) {
  CHECK(same_bytes(a.particles.id, b.particles.id));
  CHECK(same_bytes(a.particles.rock, b.particles.rock));
  CHECK(same_bytes(a.particles.fragment, b.particles.fragment));
  CHECK(same_bytes(a.particles.position, b.particles.position));
  CHECK(same_bytes(a.particles.velocity, b.particles.velocity));
  CHECK(same_bytes(a.particles.angular_velocity, b.particles.angular_velocity));
  CHECK(same_bytes(a.particles.force, b.particles.force));
  CHECK(same_bytes(a.particles.radius, b.particles.radius));
  CHECK(same_bytes(a.particles.mass, b.particles.mass));
  CHECK(same_bytes(a.bonds.i, b.bonds.i));
  CHECK(same_bytes(a.bonds.j, b.bonds.j));
  CHECK(same_bytes(a.bonds.normal_force, b.bonds.normal_force));
  CHECK(same_bytes(a.bonds.stress_ratio, b.bonds.stress_ratio));
  CHECK(same_bytes(a.bonds.radius, b.bonds.radius));
  CHECK(same_breakages(a.breakages, b.breakages));
  CHECK(same_bytes(a.loads, b.loads));
  CHECK(same_bytes(a.energies, b.energies));
  CHECK(same_extremes(a.extremes, b.extremes));
  CHECK(a.counts.bonds_intact == b.counts.bonds_intact);
  CHECK(a.counts.rebuilds == b.counts.rebuilds);
  CHECK(norm2(a.momentum - b.momentum) == 0);
}

/// The scene must reach what the comparison is about.
inline void require_busy(const Outcome& out) {
  REQUIRE(out.breakages.size() > 20);
  REQUIRE(out.bonds.size() > 20);
  REQUIRE(out.particles.size() < 2 * (2 * 64 + 9));  // some were taken out
  REQUIRE(out.counts.rebuilds > 10);
  for (std::size_t wall = 0; wall < 3; ++wall) {
    double largest = 0;
    for (std::size_t k = wall; k < out.loads.size(); k += 3) largest = std::max(largest, norm(out.loads[k].force));
    INFO("wall " << wall);
    REQUIRE(largest > 1);
  }
}

}  // namespace gyro::test

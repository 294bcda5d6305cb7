// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/bond_forces.hpp"
#include "core/kernels/wall_forces.hpp"
#include "core/laws/bond/models.hpp"
#include "core/laws/contact/models.hpp"

// What the ledger adds up: maps for Exec::reduce. No kernel of the step depends on them.

namespace gyro {

/// Sums over particles.
struct ParticleSums {
  double kinetic = 0, potential = 0;
  Vec3d momentum{0, 0, 0};
  LostWork lost;
  double overspeed = 0;  ///< largest v dt / R
  double rotation = 0;   ///< largest w dt
  ParticleId fastest = 0, fastest_rotating = 0;
  std::int64_t not_finite = 0;
  ParticleId culprit = 0;  ///< lowest id that is not finite

  GYRO_HD friend ParticleSums operator+(const ParticleSums& a, const ParticleSums& b) {
    ParticleSums s;
    s.kinetic = a.kinetic + b.kinetic;
    s.potential = a.potential + b.potential;
    s.momentum = a.momentum + b.momentum;
    s.lost = {a.lost.bond_damping + b.lost.bond_damping, a.lost.bond_slip + b.lost.bond_slip,
              a.lost.contact_damping + b.lost.contact_damping, a.lost.contact_slip + b.lost.contact_slip};
    s.overspeed = larger(a.overspeed, b.overspeed);
    s.fastest = a.overspeed >= b.overspeed ? a.fastest : b.fastest;
    s.rotation = larger(a.rotation, b.rotation);
    s.fastest_rotating = a.rotation >= b.rotation ? a.fastest_rotating : b.fastest_rotating;
    s.not_finite = a.not_finite + b.not_finite;
    s.culprit = !b.not_finite || (a.not_finite && a.culprit < b.culprit) ? a.culprit : b.culprit;
    return s;
  }
};

struct SumParticles {
  ConstParticleView p;
  Vec3d gravity;
  double dt;

  GYRO_HD ParticleSums operator()(Index n) const {
    const Sphere sphere = p.position[n];
    const Motion motion = p.motion[n];
    const AngularMotion angular = p.angular_motion[n];
    ParticleSums s;
    s.kinetic = 0.5 * (motion.mass * norm2(motion.v) + angular.inertia * norm2(angular.w));
    s.potential = -motion.mass * dot(gravity, sphere.x);
    s.momentum = motion.mass * motion.v;
    s.lost = p.losses[n];
    s.overspeed = norm(motion.v) * dt / sphere.radius;
    s.rotation = norm(angular.w) * dt;
    s.fastest = s.fastest_rotating = p.id[n];
    const double all = norm2(sphere.x) + norm2(motion.v) + norm2(angular.w);
    if (!(all < 1e300)) {
      s.not_finite = 1;
      s.culprit = p.id[n];
    }
    return s;
  }
};

/// Elastic energy and the largest overlap of contacts.
struct ContactSums {
  double elastic = 0, overlap_ratio = 0;
  ParticleId culprit = 0, partner = 0;  ///< the two of the largest overlap
  Index wall = none;                    ///< the second of them, if it is a wall

  GYRO_HD friend ContactSums operator+(const ContactSums& a, const ContactSums& b) {
    ContactSums s = a.overlap_ratio >= b.overlap_ratio ? a : b;
    s.elastic = a.elastic + b.elastic;
    return s;
  }
};

/// Contacts of a particle: with those of higher id and with walls. Summed by particle in the order of its rows,
/// so that the sum does not depend on what else the lists hold.
///
/// Contacts whose forces are held were evaluated up to half a step of the scene ago. Their overlap is that of now, so
/// that their energy belongs to the same time as all others.
template <class Real>
struct SumContacts {
  ConstParticleView p;
  ConstPairView<Real> pairs;
  ConstWallPairView<Real> near;
  WallsNow walls;
  ContactConstants<Real> rock;            ///< of rock against rock
  const ContactConstants<Real>* on_wall;  ///< of rock against each wall
  ContactModel rock_model, wall_model;
  double dt;  ///< step of the scene [s]

  GYRO_HD ContactSums operator()(Index n) const {
    const Sphere sphere = p.position[n];
    ContactSums s;
    for (Index e = pairs.row_begin[n]; e < pairs.row_begin[n + 1]; ++e)
      if (pairs.ends[e].side == 0 && pairs.touching[pairs.ends[e].pair]) s = s + of_pair(pairs.ends[e].pair);
    if (walls.poses == nullptr) return s;  // no window yet
    for (Index e = near.row_begin[n]; e < near.row_begin[n + 1]; ++e)
      if (near.touching[e]) s = s + of_wall(e, sphere);
    return s;
  }

 private:
  GYRO_HD ContactSums of_pair(Index n) const {
    const Pair pair = pairs.pair[n];
    const double a = p.position[pair.i].radius, b = p.position[pair.j].radius;
    const ContactHistory<Real> m = pairs.history[n];
    Real overlap = m.overlap;
    if (p.step[pair.i] < dt || p.step[pair.j] < dt)
      overlap = static_cast<Real>(larger(a + b - norm(p.position[pair.j].x - p.position[pair.i].x), 0.0));
    const double ratio = static_cast<double>(m.overlap) / smaller(a, b);
    const ExtraHistory<Real>* extra = pairs.extra == nullptr ? nullptr : pairs.extra + n;
    const Real energy = contact_energy(rock_model, rock, static_cast<Real>(a * b / (a + b)), overlap, m, extra);
    return {static_cast<double>(energy), ratio, p.id[pair.i], p.id[pair.j], none};
  }
  GYRO_HD ContactSums of_wall(Index n, const Sphere& sphere) const {
    const WallEntry entry = near.entry[n];
    const Vec3d centre = to_body(walls.poses[entry.wall], sphere.x);
    const WallTouches touches = touch_wall(walls.surfaces[entry.wall], entry.range, centre, sphere.radius);
    ContactSums s;
    for (int k = 0; k < near.history[n].count; ++k) {
      const ContactHistory<Real> m = near.history[n].contact[k].history;
      Real overlap = m.overlap;
      const double weight = k < touches.count ? touches.touch[k].weight : 0;
      if (k < touches.count && p.step[entry.particle] < dt) overlap = static_cast<Real>(-touches.touch[k].gap);
      const ExtraHistory<Real>* extra = near.extra == nullptr ? nullptr : near.extra[n].contact + k;
      const Real energy =
          contact_energy(wall_model, on_wall[entry.wall], static_cast<Real>(sphere.radius), overlap, m, extra);
      s = s + ContactSums{weight * static_cast<double>(energy), static_cast<double>(m.overlap) / sphere.radius,
                          p.id[entry.particle], 0, entry.wall};
    }
    return s;
  }
};

/// Elastic energy and count of the bonds, and the largest rotation of the ends of an intact one.
struct BondSums {
  double elastic = 0;
  std::int64_t intact = 0, in_step = 0;  ///< in_step counts each as often as its rock has sub-steps
  double rotation = 0;
  ParticleId twisted = 0;
  GYRO_HD friend BondSums operator+(const BondSums& a, const BondSums& b) {
    return {a.elastic + b.elastic, a.intact + b.intact, a.in_step + b.in_step, larger(a.rotation, b.rotation),
            a.rotation >= b.rotation ? a.twisted : b.twisted};
  }
};

template <class Real>
struct SumBonds {
  ConstParticleView p;
  ConstBondView<Real> b;
  BondConstants<Real> law;
  BondModel model;
  const Block* blocks;

  GYRO_HD BondSums operator()(Index n) const {
    if (b.state[n] == bond_broken) return {};
    if (blocks[p.block[b.i[n]]].rigid) return {0, 1, blocks[p.block[b.i[n]]].substeps, 0, p.id[b.i[n]]};
    BondLanes<Real, OneLane> bond(OneLane{n}, p, b);
    if (b.state[n] != bond_intact) bond.carry_axes(OneLane{n}, p, b, b.state[n], 0);
    const double elastic = static_cast<double>(bond_load(model, law, bond, b.state[n] != bond_intact).elastic);
    if (b.state[n] != bond_intact) return {elastic, 0, 0, 0, 0};
    return {elastic, 1, blocks[p.block[b.i[n]]].substeps,
            ::sqrt(bond.strain.twist * bond.strain.twist + norm2(bond.strain.bend)), p.id[b.i[n]]};
  }
};

/// What a snapshot says of an intact bond.
struct BondReading {
  double normal_force;  ///< tension positive [N]
  double stress_ratio;  ///< larger of tension/strength and shear/strength [-]
};

template <class Real>
struct ReadBonds {
  ConstParticleView p;
  ConstBondView<Real> b;
  BondConstants<Real> law;
  BondModel model;
  BondReading* now;

  GYRO_HD void operator()(Index n) const {
    if (b.state[n] != bond_intact) return;
    const BondLoad<Real> load = bond_load(model, law, BondLanes<Real, OneLane>(OneLane{n}, p, b), false);
    const Vec3d span = p.position[b.j[n]].x - p.position[b.i[n]].x;
    now[n] = {-dot(cast<double>(load.force), span) / norm(span),
              static_cast<double>(larger(load.tension_ratio, load.shear_ratio))};
  }
};

/// Adds up what the entries of one wall have booked.
struct SumWall {
  const WallEntry* entries;
  const WallSum* booked;  ///< sums or carried_over of WallBooking
  Index wall;

  GYRO_HD WallSum operator()(Index n) const { return entries[n].wall == wall ? booked[n] : WallSum{}; }
};

/// Clears what the entries have booked.
struct ClearWallSums {
  WallSum* sums;
  GYRO_HD void operator()(Index n) const { sums[n] = WallSum{}; }
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/bond_forces.hpp"
#include "core/kernels/rigid_rocks.hpp"
#include "core/laws/bond/models.hpp"

// Rocks that change between particles with bonds and a rigid body. Both only where all particles have met at one time.

namespace gyro {

/// Makes overloaded rigid rocks particles with bonds again, from the undeformed shape.
///
/// The contact forces F of the last evaluation have dt/2 left, with h the sub-step of the rock: h/2 is the first half
/// kick of its particles, the rest moves the body before it comes apart. So F keeps its impulse, as the other ends and
/// the walls have it. The next evaluation acts from h/2 on, so that for (dt - h)/2 both act; where a rock becomes
/// rigid, none does for that time.
struct FreeRocks {
  ParticleView p;
  Block* blocks;
  Body* bodies;
  Vec3d gravity;
  double dt;  ///< step of the scene [s]

  GYRO_HD void operator()(Index k) const {
    Block& block = blocks[k];
    if (!block.rigid || !block.overloaded) return;
    const IndexRange particles{block.first_particle, block.end_particle};
    const double step = dt / block.substeps;
    kick(bodies[k], load_of(p, particles, bodies[k], gravity), Vec3d{0, 0, 0}, 0.5 * (dt - step));
    spread_velocity(p, particles, bodies[k], angular_velocity(bodies[k], bodies[k].orientation));
    for (Index n = particles.begin; n < particles.end; ++n) {
      p.step[n] = step;
      p.bond_load[n] = Load{};
    }
    block.rigid = block.overloaded = 0;
    block.calm = 0;
  }
};

/// For how long the bonds of each rock or piece have been loaded less than a share of their strength, as seen at the
/// ends of windows.
template <class Real>
struct LookWhetherCalm {
  ConstParticleView p;
  ConstBondView<Real> b;
  BondConstants<Real> law;
  BondModel model;
  Block* blocks;
  double allowed;  ///< largest ratio of stress and strength [-]
  double time;     ///< of the window that ends [s]

  GYRO_HD void operator()(Index k) const {
    Block& block = blocks[k];
    if (block.rigid || !may_be_rigid(block)) return;
    block.calm = is_calm(block) ? block.calm + time : 0;
  }

 private:
  GYRO_HD bool is_calm(const Block& block) const {
    for (Index n = block.first_bond; n < block.first_bond + block.table_bonds; ++n) {
      if (b.state[n] != bond_intact) return false;
      const BondLoad<Real> load = bond_load(model, law, BondLanes<Real, OneLane>(OneLane{n}, p, b), false);
      if (static_cast<double>(larger(load.tension_ratio, load.shear_ratio)) > allowed) return false;
    }
    return true;
  }
};

/// 1 for each rock that has been calm for long enough; the map of a sum over rocks.
struct CalmRocks {
  const Block* blocks;
  double enough;     ///< [s]
  bool with_pieces;  ///< also those without a load table of their own

  GYRO_HD Index operator()(Index k) const {
    const Block& b = blocks[k];
    return !b.rigid && may_be_rigid(b) && (b.table != none || with_pieces) && b.calm >= enough ? 1 : 0;
  }
};

/// What moves as rigid bodies.
struct RigidCount {
  std::int64_t particles = 0, bonds_in_step = 0;  ///< bonds, each as often as its rock has sub-steps

  GYRO_HD friend RigidCount operator+(const RigidCount& a, const RigidCount& b) {
    return {a.particles + b.particles, a.bonds_in_step + b.bonds_in_step};
  }
};

/// The map of a sum over rocks.
struct CountRigid {
  const Block* blocks;

  GYRO_HD RigidCount operator()(Index k) const {
    const Block& b = blocks[k];
    if (!b.rigid) return {};
    return {b.end_particle - b.first_particle, std::int64_t{b.table_bonds} * b.substeps};
  }
};

/// Makes calm rocks and pieces rigid. Linear and angular momentum stay, and so does the centre of mass; the shape
/// becomes the undeformed one in the orientation that fits the particles best:
///
///   Q = mean of the orientations of the particles, by mass, turned by phi that minimises, with delta the rotations of
///       the particles from their mean, sum m |x - X - Q a - phi x Q a|^2 + sum I |phi - delta|^2
///
/// What that costs or brings of energy is the caller's to book. The contact forces of the last evaluation, of which
/// each particle has had all but h/2, keep their impulse: F h/dt acts over dt/2 (as in LoosenSpent).
struct StiffenCalm {
  ParticleView p;
  Block* blocks;
  Body* bodies;
  Arm* arms;
  CalmRocks calm;
  Vec3d gravity;
  double dt;  ///< step of the scene [s]

  GYRO_HD void operator()(Index k) const {
    if (calm(k) == 0) return;
    const IndexRange particles{blocks[k].first_particle, blocks[k].end_particle};
    Body body = bodies[k];
    if (blocks[k].table == none) take_shape(body, particles);
    take_motion(body, particles);
    take_orientation(body, particles);
    const Vec3d w = angular_velocity(body, body.orientation);
    for (Index n = particles.begin; n < particles.end; ++n) place(n, body, w);
    bodies[k] = body;
    blocks[k].rigid = 1;
    blocks[k].overloaded = 0;
    blocks[k].calm = 0;
  }

 private:
  /// Of a rock that may be a part of what came into the scene: mass and inertia, and arms from its own centre of mass.
  GYRO_HD void take_shape(Body& body, const IndexRange& particles) const {
    Vec3d middle{0, 0, 0};
    body.mass = 0;
    for (Index n = particles.begin; n < particles.end; ++n) {
      body.mass += p.motion[n].mass;
      middle += p.motion[n].mass * arms[n].arm;
    }
    middle = (1 / body.mass) * middle;
    Symmetric inertia{{0, 0, 0}, {0, 0, 0}};
    for (Index n = particles.begin; n < particles.end; ++n) {
      arms[n].arm -= middle;
      inertia.add_point(p.motion[n].mass, arms[n].arm);
      inertia.diagonal += p.angular_motion[n].inertia * Vec3d{1, 1, 1};
    }
    const Symmetric inverted = inverse(inertia);
    body.diagonal = inverted.diagonal;
    body.rest = inverted.rest;
    body.frame = {1, 0, 0, 0};  // rows are made in the frame of the arms
  }

  GYRO_HD void take_motion(Body& body, const IndexRange& particles) const {
    Vec3d middle{0, 0, 0}, momentum{0, 0, 0}, spin{0, 0, 0};
    for (Index n = particles.begin; n < particles.end; ++n) {
      middle += p.motion[n].mass * p.position[n].x;
      momentum += p.motion[n].mass * p.motion[n].v;
    }
    body.centre = (1 / body.mass) * middle;
    body.velocity = (1 / body.mass) * momentum;
    for (Index n = particles.begin; n < particles.end; ++n)
      spin += p.motion[n].mass * cross(p.position[n].x - body.centre, p.motion[n].v - body.velocity) +
              p.angular_motion[n].inertia * p.angular_motion[n].w;
    body.spin = spin;
  }

  GYRO_HD void take_orientation(Body& body, const IndexRange& particles) const {
    const Quatd first = p.orientation[particles.begin];
    Quatd sum{0, 0, 0, 0};
    for (Index n = particles.begin; n < particles.end; ++n) {
      const Quatd& q = p.orientation[n];
      const double same = first.w * q.w + first.x * q.x + first.y * q.y + first.z * q.z;
      const double share = same < 0 ? -p.motion[n].mass : p.motion[n].mass;
      sum = {sum.w + share * q.w, sum.x + share * q.x, sum.y + share * q.y, sum.z + share * q.z};
    }
    body.orientation = normalised(sum);
    Vec3d moment{0, 0, 0};
    for (Index n = particles.begin; n < particles.end; ++n)
      moment += p.motion[n].mass * cross(rotate(body.orientation, arms[n].arm), p.position[n].x - body.centre);
    const Symmetric inverse_inertia{body.diagonal, body.rest};
    const Vec3d phi = rotate(body.orientation, inverse_inertia * rotate_back(body.orientation, moment));
    body.orientation = rotated(body.orientation, phi, 1.0);
  }

  /// What is left of a total without bonds and weight: zero if it is their rounding.
  GYRO_HD static Vec3d from_contacts(const Vec3d& total, const Vec3d& bonds, const Vec3d& weight) {
    constexpr double rounding2 = 1e-26;
    const Vec3d contacts = total - bonds - weight;
    return norm2(contacts) <= rounding2 * (norm2(bonds) + norm2(weight)) ? Vec3d{0, 0, 0} : contacts;
  }

  GYRO_HD void place(Index n, const Body& body, const Vec3d& w) const {
    const Vec3d arm = rotate(body.orientation, arms[n].arm), weight = p.motion[n].mass * gravity;
    p.position[n].x = body.centre + arm;
    p.motion[n].v = body.velocity + cross(w, arm);
    p.angular_motion[n].w = w;
    p.orientation[n] = body.orientation;
    const Load total = p.load[n], bonds = p.bond_load[n];
    const double share = p.step[n] / dt;
    p.load[n].force = weight + share * from_contacts(total.force, bonds.force, weight);
    p.load[n].torque = share * from_contacts(total.torque, bonds.torque, {0, 0, 0});
    p.bond_load[n] = Load{};
    p.step[n] = dt;
  }
};

}  // namespace gyro

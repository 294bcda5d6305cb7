// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/index_range.hpp"
#include "core/kernels/gather.hpp"
#include "core/kernels/move.hpp"
#include "core/kernels/stress_bound.hpp"
#include "core/state/bodies.hpp"

// Rocks that move as rigid bodies (Block::rigid): their particles have the step of the scene, are seen by contacts and
// walls as any others, and move with the pose of the rock. Bonds are not evaluated: their strain is zero.

namespace gyro {

GYRO_HD inline ParticleRow<double> row_of(const Arm& a) {
  return {a.arm, a.radius};
}

/// What acts on a rock as a whole.
struct BodyLoad {
  Vec3d force{0, 0, 0}, torque{0, 0, 0};  ///< torque about the centre of mass
};

/// Adds up the loads of a rock's particles, in their order.
/// @param gravity  is left out of the sum [m/s2]
GYRO_HD inline BodyLoad load_of(const ParticleView& p, const IndexRange& particles, const Body& body,
                                const Vec3d& gravity) {
  BodyLoad sum;
  for (Index n = particles.begin; n < particles.end; ++n) {
    const Vec3d force = p.load[n].force - p.motion[n].mass * gravity;
    sum.force += force;
    sum.torque += p.load[n].torque + cross(p.position[n].x - body.centre, force);
  }
  return sum;
}

/// v += time F/m, L += time T.
GYRO_HD inline void kick(Body& body, const BodyLoad& load, const Vec3d& gravity, double time) {
  body.velocity += (time / body.mass) * load.force + time * gravity;
  body.spin += time * load.torque;
}

/// The particles' velocities are those of the body.
GYRO_HD inline void spread_velocity(const ParticleView& p, const IndexRange& particles, const Body& body,
                                    const Vec3d& w) {
  for (Index n = particles.begin; n < particles.end; ++n) {
    p.motion[n].v = body.velocity + cross(w, p.position[n].x - body.centre);
    p.angular_motion[n].w = w;
  }
}

/// The loads of rigid rocks, before they are looked at, and whether rows of load tables are lacking for that.
///
/// A kernel for Exec::for_each_block: a block is a rock, its rows are particles, its one item the rock.
template <class Real>
struct LoadRigid {
  using Lane = OneLane;
  using Pack = OneLane;
  using RowPack = PackOfParticles<native_lanes>;

  Block* blocks;
  Gather<Real> gather;       ///< without bonds, nothing held
  bool new_forces;           ///< as in AdvanceRigid
  const float* const* made;  ///< rows, as in StressBound
  std::int32_t* lacking;     ///< set to 1 by any rock that lacks rows

  GYRO_HD IndexRange rows(Index k) const { return {blocks[k].first_particle, blocks[k].end_particle}; }
  GYRO_HD IndexRange share(Index k) const { return rows(k); }
  GYRO_HD IndexRange items(Index k) const { return {k, k + 1}; }
  GYRO_HD IndexRange colours(Index k) const { return {k, k + 1}; }
  GYRO_HD IndexRange items_of_colour(Index colour) const { return {colour, colour + 1}; }
  GYRO_HD int passes(Index k) const { return blocks[k].rigid ? 1 : 0; }

  GYRO_HD void prepare(Index particle, Index k, int pass) const { prepare(OneParticle{particle}, k, pass); }
  template <class Lanes>
  GYRO_FLATTEN GYRO_HD void prepare(const Lanes& particles, Index, int) const {
    if (new_forces) particles.store(gather.p.load, gather.sum(particles, particles.load(gather.p.motion).number, true));
  }

  GYRO_HD void operator()(const OneLane&, Index k, int) const {
    for (Index n = blocks[k].first_particle; n < blocks[k].end_particle; ++n) {
      if (made[n] != nullptr || !is_loaded(gather.p, gather.gravity, n)) continue;
      blocks[k].lacks_rows = 1;
      if (!is_raised(lacking)) raise_flag(lacking);
      return;
    }
  }
};

/// A step of all rigid rocks, from the contact forces at one time to the positions of the next. Velocity Verlet for the
/// body: v(n+1/2) = v(n-1/2) + dt F(n)/m, L(n+1/2) = L(n-1/2) + dt T(n), then x(n+1), Q(n+1) from these.
///
/// A kernel for Exec::for_each_block: a block is a rock, its rows are particles, its one item the rock. In the first
/// pass the loads of each particle are added up and the body moves; in the second the particles follow.
template <class Real>
struct AdvanceRigid {
  using Lane = OneLane;
  using Pack = OneLane;
  using RowPack = PackOfParticles<native_lanes>;

  const Block* blocks;
  Body* bodies;
  Vec3d* turning;  ///< angular velocity of each body between two passes
  const Arm* arms;
  Gather<Real> gather;  ///< without bonds, nothing held
  Move move;
  bool new_forces;   ///< the last step has new contact forces; otherwise a window begins, and it is complete
  bool loads_known;  ///< LoadRigid has added them up
  StressBound<Real> bound;
  bool look;  ///< compares the loads with what the rock bears

  GYRO_HD IndexRange rows(Index k) const { return {blocks[k].first_particle, blocks[k].end_particle}; }
  GYRO_HD IndexRange share(Index k) const { return rows(k); }
  GYRO_HD IndexRange items(Index k) const { return {k, k + 1}; }
  GYRO_HD IndexRange colours(Index k) const { return {k, k + 1}; }
  GYRO_HD IndexRange items_of_colour(Index colour) const { return {colour, colour + 1}; }
  GYRO_HD int passes(Index k) const { return blocks[k].rigid ? 2 : 0; }

  GYRO_HD void prepare(Index particle, Index k, int pass) const { prepare(OneParticle{particle}, k, pass); }
  template <class Lanes>
  GYRO_FLATTEN GYRO_HD void prepare(const Lanes& particles, Index k, int pass) const {
    if (pass == 1)
      follow(particles, k);
    else if (new_forces && !loads_known)
      particles.store(gather.p.load, gather.sum(particles, particles.load(gather.p.motion).number, true));
  }

  GYRO_HD void operator()(const OneLane&, Index k, int pass) const {
    if (pass == 1) return;
    Body body = bodies[k];
    const BodyLoad load = load_of(gather.p, rows(k), body, gather.gravity);
    kick(body, load, gather.gravity, new_forces ? move.dt : 0.5 * move.dt);
    body.centre += move.dt * body.velocity;
    turning[k] = turn(body, move.dt);
    bodies[k] = body;
    if (look) bound.look(gather.p, gather.gravity, k);
  }

 private:
  template <class Lanes>
  GYRO_HD void follow(const Lanes& lanes, Index k) const {
    using D = typename Lanes::template Number<double>;
    const auto spread = [](const Vec3d& v) { return Vec3<D>{D(v.x), D(v.y), D(v.z)}; };
    const ParticleView& p = gather.p;
    const Quatd& q = bodies[k].orientation;
    const Quat<D> orientation{D(q.w), D(q.x), D(q.y), D(q.z)};
    const ParticleRow<D> arm = lanes.load(arms);
    const Vec3<D> from_centre = rotate(orientation, arm.vector), w = spread(turning[k]);
    ParticleRow<D> motion = lanes.load(p.motion), angular = lanes.load(p.angular_motion);
    motion.vector = spread(bodies[k].velocity) + cross(w, from_centre);
    angular.vector = w;
    const ParticleRow<D> sphere{spread(bodies[k].centre) + from_centre, arm.number};
    lanes.store(p.orientation, orientation);
    lanes.store(p.motion, motion);
    lanes.store(p.angular_motion, angular);
    lanes.store(p.position, sphere);
    move.watch(lanes, sphere, motion, angular, sphere.vector);
  }
};

/// The second half of a step of rigid rocks, after FinishStep has added up the loads of their particles.
struct FinishRigid {
  ParticleView p;
  const Block* blocks;
  Body* bodies;
  Vec3d gravity;
  double dt;  ///< step of the scene [s]

  GYRO_HD void operator()(Index k) const {
    if (!blocks[k].rigid) return;
    const IndexRange particles{blocks[k].first_particle, blocks[k].end_particle};
    kick(bodies[k], load_of(p, particles, bodies[k], gravity), gravity, 0.5 * dt);
    spread_velocity(p, particles, bodies[k], angular_velocity(bodies[k], bodies[k].orientation));
  }
};

}  // namespace gyro

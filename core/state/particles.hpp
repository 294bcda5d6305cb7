// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/math/quat.hpp"
#include "core/state/columns.hpp"

#include <cstddef>

namespace gyro {

// The state of a particle, in rows that are read together: a row is one or two aligned loads on a
// CPU and on a GPU. All of it is double in both precisions: single positions and orientations heat a
// free rock (core/README.md).

/// Where a sphere is.
struct alignas(32) Sphere {
  Vec3d x;        ///< centre [m]
  double radius;  ///< [m]

  template <class F, class... S>
  static constexpr void for_each_field(F&& f, S&... s) {
    f("centre", s.x...);
    f("radius", s.radius...);
  }
};
static_assert(declares_every_field<Sphere>);

/// How it moves.
struct alignas(32) Motion {
  Vec3d v;      ///< [m/s]
  double mass;  ///< [kg]

  template <class F, class... M>
  static constexpr void for_each_field(F&& f, M&... m) {
    f("velocity", m.v...);
    f("mass", m.mass...);
  }
};
static_assert(declares_every_field<Motion>);

/// How it rotates.
struct alignas(32) AngularMotion {
  Vec3d w;         ///< [rad/s]
  double inertia;  ///< 2/5 m R^2 [kg m2]

  template <class F, class... M>
  static constexpr void for_each_field(F&& f, M&... m) {
    f("velocity", m.w...);
    f("inertia", m.inertia...);
  }
};
static_assert(declares_every_field<AngularMotion>);

/// Force and torque on a particle, each with the work that its sources lost in this step: the sum
/// travels with the loads through one gather.
struct alignas(64) Load {
  Vec3d force{0, 0, 0};   ///< [N]
  double damped = 0;      ///< [J]
  Vec3d torque{0, 0, 0};  ///< [N m]
  double slipped = 0;     ///< [J]

  template <class F, class... L>
  static constexpr void for_each_field(F&& f, L&... l) {
    f("force", l.force...);
    f("damped", l.damped...);
    f("torque", l.torque...);
    f("slipped", l.slipped...);
  }
};
static_assert(declares_every_field<Load>);

/// Work lost at a particle since it came into the scene [J]. A pair's share is booked at its
/// lower id, so that it does not depend on when lists are rebuilt.
struct LostWork {
  double bond_damping = 0, bond_slip = 0, contact_damping = 0, contact_slip = 0;

  template <class F, class... L>
  static constexpr void for_each_field(F&& f, L&... l) {
    f("bond_damping", l.bond_damping...);
    f("bond_slip", l.bond_slip...);
    f("contact_damping", l.contact_damping...);
    f("contact_slip", l.contact_slip...);
  }
};
static_assert(declares_every_field<LostWork>);

/// Columns of the particles. Column<T> is a buffer, a pointer or a vector of T.
template <template <class> class Column>
struct Particles {
  Column<Sphere> position;
  Column<Motion> motion;
  Column<AngularMotion> angular_motion;
  Column<Quatd> orientation;  ///< since the particle came into the scene; empty without bonds
  Column<Load> load;          ///< total at the present position, gravity included
  Column<Load> bond_load;     ///< from bonds alone; empty without bonds
  Column<double> step;        ///< of its rock: the scene's over its sub-steps [s]
  Column<LostWork> losses;
  Column<double> damping_rate;  ///< of its contacts in their last evaluation: sum of ContactLoad::dashpot / mass [1/s]
  Column<ParticleId> id;
  Column<Index> block;  ///< of its rock; none for a sphere that belongs to no rock

  template <class F, class... P>
  static constexpr void for_each_column(F&& f, P&... p) {
    for_each_common_column(f, p...);
    for_each_bonded_column(f, p...);
  }
  /// Columns of every scene.
  template <class F, class... P>
  static constexpr void for_each_common_column(F&& f, P&... p) {
    f("position", p.position...);
    f("motion", p.motion...);
    f("angular_motion", p.angular_motion...);
    f("load", p.load...);
    f("step", p.step...);
    f("losses", p.losses...);
    f("damping_rate", p.damping_rate...);
    f("id", p.id...);
    f("block", p.block...);
  }
  /// Columns that are empty without bonds.
  template <class F, class... P>
  static constexpr void for_each_bonded_column(F&& f, P&... p) {
    f("orientation", p.orientation...);
    f("bond_load", p.bond_load...);
  }
};

/// What kernels take by value: to change particles, or only to read them.
using ParticleView = Particles<Pointer>;
using ConstParticleView = Particles<ConstPointer>;
static_assert(declares_every_column<ParticleView>());

/// How far ahead of its position contacts see a particle, at its present velocity: to the middle of the time for which
/// they hold. So held forces are those of a leapfrog with the longer step; forces at the begin of the hold would heat
/// an elastic impact. Zero for a particle without sub-steps.
/// @param dt    step of the scene, for which contact forces are held [s]
/// @param step  of the particle [s]
/// @tparam D    double, or a pack of them
template <class D>
GYRO_HD D time_to_middle(const D& dt, const D& step) {
  return D(0.5) * (dt - step);
}
/// The centre of a particle as contacts see it.
template <class D>
GYRO_HD Vec3<D> seen_centre(const Vec3<D>& centre, const Vec3<D>& velocity, const D& dt, const D& step) {
  return centre + time_to_middle(dt, step) * velocity;
}

}  // namespace gyro

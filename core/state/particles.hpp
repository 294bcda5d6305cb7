// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/quat.hpp"

#include <cstddef>

namespace gyro {

// The state of a particle, in rows that are read together: a row is one or two aligned loads on a
// CPU and on a GPU. All of it is double in both precisions: single positions and turns heat a
// free rock (core/README.md).

/// Where a sphere is.
struct alignas(32) Sphere {
  Vec3d x;        ///< centre [m]
  double radius;  ///< [m]
};

/// How it moves.
struct alignas(32) Motion {
  Vec3d v;      ///< [m/s]
  double mass;  ///< [kg]
};

/// How it spins.
struct alignas(32) AngularMotion {
  Vec3d w;         ///< [rad/s]
  double inertia;  ///< 2/5 m R^2 [kg m2]
};

/// Force and moment on a particle, each with the work that its sources lost in this step: the sum
/// travels with the loads through one gather.
struct alignas(64) Load {
  Vec3d force{0, 0, 0};   ///< [N]
  double damped = 0;      ///< [J]
  Vec3d torque{0, 0, 0};  ///< [N m]
  double slipped = 0;     ///< [J]
};

/// Work lost at a particle since it came into the scene [J]. A pair's share is booked at its
/// lower id, so that it does not depend on when lists are rebuilt.
struct LostWork {
  double bond_damping = 0, bond_slip = 0, contact_damping = 0, contact_slip = 0;
};

/// Columns of the particles. Column<T> is a buffer, a pointer or a vector of T.
template <template <class> class Column>
struct Particles {
  Column<Sphere> position;
  Column<Motion> motion;
  Column<AngularMotion> angular_motion;
  Column<Quatd> orientation;      ///< since the particle came into the scene; empty without bonds
  Column<Load> load;              ///< total at the present place, gravity included
  Column<Load> bond_load;         ///< from bonds alone; empty without bonds
  Column<Vec3d> listed_position;  ///< place when the neighbour lists were built
  Column<LostWork> losses;
  Column<ParticleId> id;
  Column<Index> block;  ///< of rock
};

/// Calls f(name, whether the column exists only with bonds, column...) for every column of the particles
/// given, in step: the one list of columns.
template <class F, class... P>
void for_each_particle_column(F&& f, P&... p) {
  f("position", false, p.position...);
  f("motion", false, p.motion...);
  f("angular_motion", false, p.angular_motion...);
  f("orientation", true, p.orientation...);
  f("load", false, p.load...);
  f("bond_load", true, p.bond_load...);
  f("listed_position", false, p.listed_position...);
  f("losses", false, p.losses...);
  f("id", false, p.id...);
  f("block", false, p.block...);
}

template <class T>
using Pointer = T*;

/// What kernels take by value.
using ParticleView = Particles<Pointer>;
static_assert(sizeof(ParticleView) == 10 * sizeof(void*), "a new column needs a line in for_each_particle_column");

/// A sphere as contacts see it: where it is or, with forces that are `held` over several steps, where
/// it will be in their middle if it flies on. So held forces are those of a leapfrog with the longer step;
/// forces of the hold's begin would heat an elastic impact.
/// @param ahead  time to the middle of the hold [s]
template <bool held>
GYRO_HD Sphere contact_position(const ParticleView& p, Index n, double half_hold_offset) {
  Sphere s = p.position[n];
  if constexpr (held) s.x += half_hold_offset * p.motion[n].v;
  return s;
}

}  // namespace gyro

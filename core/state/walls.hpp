// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/scene/scene.hpp"
#include "core/state/columns.hpp"
#include "core/state/contacts.hpp"
#include "core/surfaces/touch_wall.hpp"

namespace gyro {

enum class WallKind : std::int32_t { plane, profile, mesh };

/// Extent of a surface that has no end: more than any distance of particles [m].
inline constexpr double endless = 1e12;

/// The shape of a wall as kernels see it.
struct WallSurface {
  WallKind kind;
  PlaneShape plane;
  ProfileView profile;
  MeshView mesh;
  double extent;  ///< largest distance of the surface from the body's origin; `endless` for a plane [m]
};

/// How far the points of a wall move in a step.
struct WallStep {
  double way;    ///< at most [m]
  bool bounded;  ///< false: a wall without an end that rotates; the further away, the further its points move
};

/// The walls of a scene as they stand in this step.
struct WallsNow {
  const WallSurface* surfaces;
  const WallPose* poses;  ///< null before the first window
  Index count;
};

/// A particle near a wall.
struct WallEntry {
  Index particle;
  Index wall;
  SegmentRange range;  ///< of a profile; of a mesh: numbers into WallPairs::triangle

  template <class F, class... E>
  static constexpr void for_each_field(F&& f, E&... e) {
    f("particle", e.particle...);
    f("wall", e.wall...);
    f("range", e.range...);
  }
};
static_assert(declares_every_field<WallEntry>);

/// What was free between a sphere and a wall when the list was built. A sphere whose centre has come less far than that
/// does not touch, whatever the shape of the wall.
struct alignas(32) WallClearance {
  Vec3d centre;  ///< of the sphere then, in the wall's frame [m]
  double gap;    ///< at most what was free; 0 for planes, whose exact test is as short [m]
};

/// One contact of a sphere and a wall, as the next step finds it again.
template <class Real>
struct WallContact {
  ContactHistory<Real> history;  ///< of the force on the particle
  Vec3<Real> normal;             ///< unit vector from wall to sphere, world frame

  template <class F, class... C>
  static constexpr void for_each_field(F&& f, C&... c) {
    f("history", c.history...);
    f("normal", c.normal...);
  }
};
static_assert(declares_every_field<WallContact<float>>);

/// Contacts of one entry: as many as a sphere can have with one wall.
template <class Real>
struct WallHistory {
  WallContact<Real> contact[WallTouches::capacity];
  std::int32_t count;
};

/// History that only some contact laws keep, of the contacts of one entry.
template <class Real>
struct WallExtraHistory {
  ExtraHistory<Real> contact[WallTouches::capacity];
};

/// The only touch of an entry in this step, on its way from the query to the contact law.
struct alignas(32) WallTouchNow {
  Vec3d outward;   ///< unit, from the wall to the sphere, world frame
  double overlap;  ///< [m]
};

/// Result of an entry for this step.
template <class Real>
struct WallResult {
  Vec3<Real> force, torque;  ///< on the particle [N], [N m]
  Real damped, slipped;      ///< [J]
  Real dashpot;              ///< sum of ContactLoad::dashpot [N s/m]
};

/// Columns of the wall list: particles that may touch a wall while they stay in their wide bounds. Rows are ordered by
/// wall.
template <template <class> class Column, class Real>
struct WallPairs {
  Column<WallEntry> entry;
  Column<WallClearance> clearance;
  Column<Index> triangle;       ///< of meshes, those that an entry may touch side by side, the nearest first
  Column<double> triangle_gap;  ///< of each, as WallClearance::gap [m]
  Column<WallTouchNow> touch;
  Column<WallHistory<Real>> history;
  Column<WallExtraHistory<Real>> extra;  ///< empty unless the contact law keeps it
  Column<WallResult<Real>> result;
  Column<std::int8_t> touching;  ///< 1: in contact in this step
  Column<Index> row_begin;       ///< per particle; one past the end at the last

  template <class F, class... W>
  static constexpr void for_each_column(F&& f, W&... w) {
    f("entry", w.entry...);
    f("clearance", w.clearance...);
    f("triangle", w.triangle...);
    f("triangle_gap", w.triangle_gap...);
    f("touch", w.touch...);
    f("history", w.history...);
    f("extra", w.extra...);
    f("result", w.result...);
    f("touching", w.touching...);
    f("row_begin", w.row_begin...);
  }
};

template <class Real>
using WallPairView = WallPairs<Pointer, Real>;
template <class Real>
using ConstWallPairView = WallPairs<ConstPointer, Real>;
static_assert(declares_every_column<WallPairView<float>>());

/// What rock did to a wall: whole numbers of a quantum, so that the sum is exact and the same
/// whatever the order, the threads and the times at which lists are rebuilt.
struct WallSum {
  Vec3<std::int64_t> force{0, 0, 0};   ///< sum over steps [quantum of N s]
  Vec3<std::int64_t> torque{0, 0, 0};  ///< about the world's origin [quantum of N m s]
  std::int64_t work = 0;               ///< of the wall on the rock [quantum of J]
  std::int64_t slip = 0;               ///< lost in sliding friction [quantum of J]

  GYRO_HD friend WallSum operator+(const WallSum& a, const WallSum& b) {
    return {a.force + b.force, a.torque + b.torque, a.work + b.work, a.slip + b.slip};
  }

  template <class F, class... S>
  static constexpr void for_each_field(F&& f, S&... s) {
    f("force", s.force...);
    f("torque", s.torque...);
    f("work", s.work...);
    f("slip", s.slip...);
  }
};
static_assert(declares_every_field<WallSum>);
inline constexpr double wall_quantum = 1.0 / (1LL << 44);  ///< [N s], [N m s], [J]

/// Where the wall forces of a step book what they did, one sum a row of the wall list.
struct WallBooking {
  WallSum* sums;          ///< of the window so far
  WallSum* carried_over;  ///< what of the last step's loads acts in the next window
};

}  // namespace gyro

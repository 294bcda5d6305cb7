// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/state/contacts.hpp"
#include "core/surfaces/touch_wall.hpp"

namespace gyro {

enum class WallKind : std::int32_t { plane, profile, mesh };

/// The shape of a wall as kernels see it.
struct WallSurface {
  WallKind kind;
  PlaneShape plane;
  ProfileView profile;
  MeshView mesh;
  double extent;  ///< largest distance of the surface from the body's origin, 0 for a plane [m]
};

/// A particle near a wall.
struct WallEntry {
  Index particle;
  Index wall;
  SegmentRange range;  ///< of a profile
};

/// Contacts of one entry: as many as a sphere can have with one wall.
template <class Real>
struct WallHistory {
  ContactHistory<Real> contact[WallTouches::capacity];  ///< force on the particle
  Vec3<Real> normal[WallTouches::capacity];             ///< wall to sphere; finds the contact again
  std::int32_t count;
};

/// History that only some contact laws keep, of the contacts of one entry.
template <class Real>
struct WallExtraHistory {
  ExtraHistory<Real> contact[WallTouches::capacity];
};

/// Result of an entry for this step.
template <class Real>
struct WallResult {
  Vec3<Real> force, torque;  ///< on the particle
  Real damped, slipped;      ///< [J]
};

/// What rock did to a wall: whole numbers of a quantum, so that the sum is exact and the same
/// whatever the order, the threads and the times at which lists are rebuilt.
struct WallSum {
  std::int64_t force[3] = {0, 0, 0};   ///< sum over steps [quantum of N s]
  std::int64_t torque[3] = {0, 0, 0};  ///< about the world's origin
  std::int64_t work = 0;               ///< of the wall on the rock
  std::int64_t slip = 0;               ///< lost in sliding friction
};
inline constexpr double wall_quantum = 1.0 / (1LL << 44);  ///< [N s], [N m s], [J]

template <class Real>
struct WallView {
  const WallSurface* surfaces;
  const WallPose* poses;  ///< of this step
  WallEntry* entries;
  WallHistory<Real>* history;
  WallExtraHistory<Real>* extra;  ///< null unless the contact law keeps it
  WallResult<Real>* result;
  std::int8_t* touching;
  WallSum* sums;          ///< one an entry: of the window so far
  WallSum* carried_over;  ///< one an entry: what of the last step's loads acts in the next window
  Index* row_begin;       ///< per particle; rows are ordered by wall
  Index count;
};

}  // namespace gyro

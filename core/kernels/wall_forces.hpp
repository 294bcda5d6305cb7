// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/wall_contact.hpp"
#include "core/kernels/wall_touch.hpp"
#include "core/scene/wall_motion.hpp"

#include <type_traits>

namespace gyro {

/// Contact of a particle with a rigid wall: force into the entry's own slot, load of the wall into
/// the entry's exact sums. Half of the last sub-step's load of a window acts in the next one's first half kick:
/// work, impulse and angular impulse of a window are those that the rock has felt in it. (Angular impulse of a particle
/// with sub-steps: but for the wall's motion in half a step, 5e-6 of it in a crusher.)
///
/// A kernel for Exec::for_each_picked: entries are looked at one by one, and those that touch in one place, which
/// nearly all do, are evaluated several at a time. Several touches, and laws that keep ExtraHistory, are evaluated as
/// they are found.
/// @tparam Law   a ContactLaw
/// @tparam held  some particles have sub-steps, over which forces are held
template <class Real, class Law, bool held>
struct WallForces {
  using Lane = OneEntry;  ///< of a GPU thread
  /// Of a CPU core.
  using Pack = std::conditional_t<Law::keeps_extra_history, OneEntry, PackOfEntries<native_lanes>>;
  static constexpr int blocks_at_once = 2;

  ConstParticleView p;
  WallsNow walls;
  WallPairView<Real> near;
  WallBooking booking;
  const ContactConstants<Real>* constants;  ///< of rock against each wall
  double dt;                                ///< step of the scene, for which the forces act [s]
  bool last_of_window;                      ///< half of a particle's last sub-step is beyond the window's end
  OverlapCheck deep;

  /// Whether the entry touches in one place. If it does in none, its history is forgotten.
  GYRO_HD bool pick(Index n) const {
    const WallEntry entry = near.entry[n];
    const WallPose& pose = walls.poses[entry.wall];
    const Vec3d centre = seen(OneEntry{n}, entry.particle, entry.wall).sphere.vector;
    const ListedTouches listed{near.clearance, near.triangle, near.triangle_gap};
    const WallTouches touches =
        listed(n, entry, walls.surfaces[entry.wall], to_body(pose, centre), p.position[entry.particle].radius);
    if (last_of_window) booking.carried_over[n] = WallSum{};
    if (touches.count == 0) {
      if (near.touching[n]) {
        near.touching[n] = 0;
        near.history[n].count = 0;
      }
      return false;
    }
    near.touching[n] = 1;
    if (Law::keeps_extra_history || touches.count > 1) {
      evaluate(n, touches);
      return false;
    }
    const WallTouch& touch = touches.touch[0];
    near.touch[n] = {rotate(pose.orientation, touch.normal), -touch.gap};
    if (near.history[n].count != 1) keep_one(near.history[n], cast<Real>(near.touch[n].outward));
    return true;
  }

  /// The only contact of each entry: its weight is 1.
  template <class Lanes>
  GYRO_FLATTEN GYRO_HD void operator()(const Lanes& lanes) const {
    if constexpr (!Law::keeps_extra_history) {
      using D = typename Lanes::template Number<double>;
      using R = typename Lanes::template Number<Real>;
      const auto particle = lanes.index(near.entry, &WallEntry::particle);
      const auto wall = lanes.index(near.entry, &WallEntry::wall);
      const ParticleRow<D> touch = lanes.own_row(near.touch);
      SphereOnWall<D> at = seen(lanes, particle, wall);
      at.outward = touch.vector;
      at.overlap = touch.number;
      if (lanes.any(at.overlap > D(deep.limit) * at.sphere.number)) raise_flag(deep.limit_exceeded);

      const Vec3<D> wall_velocity = at.wall.at(at.point());
      const ContactMotion<R> c = at.template contact<Real>(wall_velocity);
      ExtraHistory<R> unused{};
      const ContactLoad<R> load =
          Law::load(lanes.of_wall(constants, wall), c, remembered(lanes.first(near.history), -c.normal), unused);
      lanes.store_first(near.history, WallContact<R>{load.history, -c.normal});
      WallLoads<D, R> loads;
      loads.add(load, R(1), c, at, wall_velocity);
      store(lanes, loads, particle);
    }
  }

 private:
  /// A particle as a wall sees it that stands where it is at the end of the step: one with sub-steps is seen earlier.
  /// Where it touches is not set.
  template <class Lanes, class Number>
  GYRO_HD auto seen(const Lanes& lanes, const Number& particle, const Number& wall) const {
    using D = typename Lanes::template Number<double>;
    SphereOnWall<D> at{};
    at.sphere = lanes.row(p.position, particle);
    at.motion = lanes.row(p.motion, particle);
    at.angular = lanes.row(p.angular_motion, particle);
    at.wall = lanes.velocity(walls.poses, wall);
    at.damping_rate = lanes.at(p.damping_rate, particle);
    if constexpr (held) {
      const D ahead = time_to_middle(D(dt), lanes.at(p.step, particle));
      at.sphere.vector = at.sphere.vector + ahead * at.motion.vector;
      at.sphere.vector = at.sphere.vector + ahead * at.wall.at(at.sphere.vector);
    }
    return at;
  }

  static constexpr double same_contact = 0.70710678;  ///< cosine of 45 degrees: normals of one contact in two steps

  /// The history of an entry's contact if it is still the same.
  template <class R>
  GYRO_HD static ContactHistory<R> remembered(const WallContact<R>& old, const Vec3<R>& outward) {
    const auto same = dot(old.normal, outward) > R(static_cast<Real>(same_contact));
    const R zero(0);
    const Vec3<R> nothing{zero, zero, zero};
    return {select(same, old.history.elastic, nothing), select(same, old.history.overlap, zero),
            select(same, old.history.drag, nothing)};
  }
  /// Reduces the history to one contact: the one that continues; if none does, an empty one.
  GYRO_HD static void keep_one(WallHistory<Real>& history, const Vec3<Real>& outward) {
    bool taken[WallTouches::capacity] = {};
    const int found = matching_contact(history, outward, taken);
    history.contact[0] = found >= 0 ? history.contact[found] : WallContact<Real>{};
    history.count = 1;
  }

  /// Half of a particle's last sub-step is beyond the window's end.
  template <class Lanes, class D, class R, class Number>
  GYRO_HD void store(const Lanes& lanes, WallLoads<D, R>& loads, const Number& particle) const {
    loads.total.slip_power = lane_cast<double>(loads.result.slipped) / D(dt);
    lanes.store(near.result, loads.result);
    if (!last_of_window) return lanes.add(booking.sums, loads.total.over(D(dt)));
    const D later = D(0.5) * lanes.at(p.step, particle);
    lanes.add(booking.sums, loads.total.over(D(dt) - later));
    lanes.add(booking.carried_over, loads.total.over(later));
  }

  /// All contacts of one entry.
  GYRO_APART GYRO_HD void evaluate(Index n, const WallTouches& touches) const {
    const OneEntry lane{n};
    const WallEntry entry = near.entry[n];
    const WallPose& pose = walls.poses[entry.wall];
    SphereOnWall<double> at = seen(lane, entry.particle, entry.wall);
    const WallHistory<Real> old = near.history[n];
    WallExtraHistory<Real> old_extra;
    if constexpr (Law::keeps_extra_history) old_extra = near.extra[n];
    WallLoads<double, Real> loads;
    bool taken[WallTouches::capacity] = {};
    for (int k = 0; k < touches.count; ++k) {
      const WallTouch& touch = touches.touch[k];
      at.outward = rotate(pose.orientation, touch.normal);
      at.overlap = -touch.gap;
      deep.check_overlap(at.overlap, at.sphere.number);
      const Vec3d wall_velocity = at.wall.at(at.point());
      const ContactMotion<Real> c = at.template contact<Real>(wall_velocity);

      const int found = matching_contact(old, cast<Real>(at.outward), taken);
      ExtraHistory<Real> extra{};
      if constexpr (Law::keeps_extra_history)
        if (found >= 0) extra = old_extra.contact[found];
      const ContactLoad<Real> load =
          Law::load(constants[entry.wall], c, found >= 0 ? old.contact[found].history : ContactHistory<Real>{}, extra);
      near.history[n].contact[k] = {load.history, cast<Real>(at.outward)};
      if constexpr (Law::keeps_extra_history) near.extra[n].contact[k] = extra;
      loads.add(load, static_cast<Real>(touch.weight), c, at, wall_velocity);
    }
    near.history[n].count = touches.count;
    store(lane, loads, entry.particle);
  }

  /// The contact of the last step with the nearest normal (within 45 degrees), each used once if there are enough; -1:
  /// none. A contact that appears beside another takes the history of that one: when the sphere rolls on to the next
  /// facet of a concave wall, both share the load, and friction must not restart from zero.
  GYRO_HD static int matching_contact(const WallHistory<Real>& old, const Vec3<Real>& normal, bool* taken) {
    int own = -1, beside = -1;
    Real nearest = static_cast<Real>(same_contact), nearest_of_all = nearest;
    for (int k = 0; k < old.count; ++k) {
      const Real cosine = dot(old.contact[k].normal, normal);
      if (cosine > nearest_of_all) {
        nearest_of_all = cosine;
        beside = k;
      }
      if (!taken[k] && cosine > nearest) {
        nearest = cosine;
        own = k;
      }
    }
    if (own >= 0) taken[own] = true;
    return own >= 0 ? own : beside;
  }
};

}  // namespace gyro

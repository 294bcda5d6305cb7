// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/wall_touch.hpp"
#include "core/laws/contact/contact.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// What the contacts of one entry do to the wall.
struct WallTotal {
  Vec3d force{0, 0, 0}, torque{0, 0, 0};  ///< on the particle, torque about the world's origin [N], [N m]
  double power = 0;                       ///< of the wall on the particle [W]
  double slip_power = 0;                  ///< lost in sliding friction [W]

  GYRO_HD void add(const Vec3d& on_particle, const Vec3d& point, const Vec3d& wall_velocity) {
    force += on_particle;
    torque += cross(point, on_particle);
    power += dot(on_particle, wall_velocity);
  }
  GYRO_HD void add_couple(const Vec3d& on_particle, const Vec3d& wall_spin) {
    torque += on_particle;
    power += dot(on_particle, wall_spin);
  }
  /// Adds what acts over a time to an exact sum.
  GYRO_HD void book(double time, WallSum& sum) const {
    const double scale = time / wall_quantum;
    sum.force -= quanta(scale * force);
    sum.torque -= quanta(scale * torque);
    sum.work += quanta(scale * power);
    sum.slip += quanta(scale * slip_power);
  }

 private:
  /// Numbers that are not finite count as zero here: the guard reports the particle.
  GYRO_HD static std::int64_t quanta(double x) {
    constexpr double maximum = 9e18;
    return x > -maximum && x < maximum ? static_cast<std::int64_t>(::floor(x + 0.5)) : 0;
  }
  GYRO_HD static Vec3<std::int64_t> quanta(const Vec3d& v) { return {quanta(v.x), quanta(v.y), quanta(v.z)}; }
};

/// Contact of a particle with a rigid wall: force into the entry's own slot, load of the wall into
/// the entry's exact sums. Half of the last step's load of a window acts in the next one's first half kick:
/// work, impulse and angular impulse of a window are those that the rock has felt in it.
/// @tparam Law   a ContactLaw
/// @tparam held  forces are held over several sub-steps
template <class Real, class Law, bool held>
struct WallForces {
  static constexpr int blocks_at_once = 2;

  ConstParticleView p;
  WallsNow walls;
  WallPairView<Real> near;
  WallBooking booking;
  const ContactConstants<Real>* constants;  ///< of rock against each wall
  double dt;                                ///< time for which the forces act [s]
  double half_hold_offset;                  ///< as in contact_centre() [s]
  double carry_over;                        ///< share of that time beyond the window's end; 0 but for its last hold
  OverlapCheck deep;

  GYRO_HD void operator()(Index n) const {
    const WallEntry entry = near.entry[n];
    const Sphere sphere{contact_centre<held>(p, entry.particle, half_hold_offset), p.position[entry.particle].radius};
    const WallPose pose = walls.poses[entry.wall];
    const ListedTouches listed{near.clearance, near.triangle, near.triangle_gap};
    const WallTouches touches = listed(n, entry, walls.surfaces[entry.wall], to_body(pose, sphere.x), sphere.radius);
    if (carry_over > 0) booking.carried_over[n] = WallSum{};
    if (touches.count == 0) {
      if (near.touching[n]) {
        near.touching[n] = 0;
        near.history[n].count = 0;
      }
      return;
    }
    near.touching[n] = 1;
    evaluate(n, entry, sphere, pose, touches);
  }

 private:
  GYRO_HD void evaluate(Index n, const WallEntry& entry, const Sphere& sphere, const WallPose& pose,
                        const WallTouches& touches) const {
    const Motion motion = p.motion[entry.particle];
    const AngularMotion angular = p.angular_motion[entry.particle];
    const WallHistory<Real> old = near.history[n];
    WallHistory<Real> now;
    WallExtraHistory<Real> old_extra, now_extra{};
    if constexpr (Law::keeps_extra_history) old_extra = near.extra[n];
    WallResult<Real> result{};
    WallTotal total;
    bool taken[WallTouches::capacity] = {};
    for (int k = 0; k < touches.count; ++k) {
      const WallTouch& touch = touches.touch[k];
      const Vec3d outward = rotate(pose.orientation, touch.normal);
      const double overlap = -touch.gap, arm = sphere.radius - overlap;
      deep.check_overlap(overlap, sphere.radius);
      const Vec3d point = sphere.x - arm * outward;
      const Vec3d wall_velocity = velocity_at(pose, point);

      ContactMotion<Real> c;
      c.normal = cast<Real>(-outward);
      c.overlap = static_cast<Real>(overlap);
      c.velocity = cast<Real>(motion.v - wall_velocity - arm * cross(angular.w, outward));
      c.angular_velocity = cast<Real>(angular.w - pose.angular_velocity);
      c.radius = static_cast<Real>(sphere.radius);
      c.mass = static_cast<Real>(motion.mass);
      c.inertia = static_cast<Real>(angular.inertia);
      c.lever = static_cast<Real>(arm);

      const int found = matching_contact(old, cast<Real>(outward), taken);
      ExtraHistory<Real> extra{};
      if constexpr (Law::keeps_extra_history)
        if (found >= 0) extra = old_extra.contact[found];
      const ContactLoad<Real> load =
          Law::load(constants[entry.wall], c, found >= 0 ? old.contact[found].history : ContactHistory<Real>{}, extra);
      const Real weight = static_cast<Real>(touch.weight);
      const Vec3<Real> force = weight * load.force;
      const Vec3<Real> couple = weight * load.couple;
      result.force += force;
      result.torque += static_cast<Real>(arm) * cross(c.normal, force) + couple;
      result.damped += weight * load.damped;
      result.slipped += weight * load.slipped;
      now.contact[k] = {load.history, cast<Real>(outward)};
      if constexpr (Law::keeps_extra_history) now_extra.contact[k] = extra;
      total.add(cast<double>(force), point, wall_velocity);
      total.add_couple(cast<double>(couple), pose.angular_velocity);
    }
    total.slip_power = static_cast<double>(result.slipped) / dt;
    now.count = touches.count;
    near.history[n] = now;
    if constexpr (Law::keeps_extra_history) near.extra[n] = now_extra;
    near.result[n] = result;
    total.book((1 - carry_over) * dt, booking.sums[n]);
    if (carry_over > 0) total.book(carry_over * dt, booking.carried_over[n]);
  }

  /// The contact of the last step with the nearest normal (within 45 degrees), each used once if there are enough; -1:
  /// none. A contact that appears beside another takes the history of that one: when the sphere rolls on to the next
  /// facet of a concave wall, both share the load, and friction must not restart from zero.
  GYRO_HD static int matching_contact(const WallHistory<Real>& old, const Vec3<Real>& normal, bool* taken) {
    int own = -1, beside = -1;
    Real nearest = Real(0.70710678), nearest_of_all = nearest;
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

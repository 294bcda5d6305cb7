// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Touches of a sphere with a wall of any kind. Body frame in, body frame out.
GYRO_HD inline WallTouches touch_wall(const WallSurface& surface, const SegmentRange& range, const Vec3d& centre,
                                      double radius) {
  if (surface.kind == WallKind::plane) return touch_plane(surface.plane.point, surface.plane.normal, centre, radius);
  if (surface.kind == WallKind::profile) return touch_profile(surface.profile, range, centre, radius);
  return touch_mesh(surface.mesh, centre, radius);
}

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
/// @tparam held  some particles have sub-steps, over which forces are held
template <class Real, class Law, bool held>
struct WallForces {
  static constexpr int blocks_at_once = 2;

  ConstParticleView p;
  WallsNow walls;
  WallPairView<Real> near;
  WallBooking booking;
  const ContactConstants<Real>* constants;  ///< of rock against each wall
  double dt;                                ///< step of the scene, for which the forces act [s]
  bool last_of_window;                      ///< half of a particle's last sub-step is beyond the window's end
  OverlapCheck deep;

  GYRO_HD void operator()(Index n) const {
    const WallEntry entry = near.entry[n];
    const WallPose pose = walls.poses[entry.wall];
    const Sphere sphere{centre(entry.particle, pose), p.position[entry.particle].radius};
    const WallTouches touches =
        touch_wall(walls.surfaces[entry.wall], entry.range, to_body(pose, sphere.x), sphere.radius);
    if (last_of_window) booking.carried_over[n] = WallSum{};
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
  /// As the wall sees it, which stands where it is at the end of the step: a particle with sub-steps is seen earlier.
  GYRO_HD Vec3d centre(Index particle, const WallPose& pose) const {
    const Vec3d x = contact_centre<held>(p, particle, dt);
    if constexpr (held) return x + time_to_middle(dt, p.step[particle]) * velocity_at(pose, x);
    return x;
  }

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
      c.damping_rate = static_cast<Real>(p.damping_rate[entry.particle]);

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
      result.dashpot += weight * load.dashpot;
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
    const double later = last_of_window ? 0.5 * p.step[entry.particle] : 0;
    total.book(dt - later, booking.sums[n]);
    if (last_of_window) total.book(later, booking.carried_over[n]);
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

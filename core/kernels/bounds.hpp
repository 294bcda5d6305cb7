// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/select.hpp"
#include "core/state/particles.hpp"

// Bounds: a particle has a sphere around it that it does not leave until its neighbours are sought again. Particles
// whose bounds are apart cannot touch until then. Fast particles have large bounds, slow ones small bounds, so that all
// of them leave theirs after about the same time.

namespace gyro {

/// The centre of a particle as contacts see it, as contact_centre().
/// @param dt    step of the scene [s]
/// @param step  of the particle [s]
/// @tparam D    double, or a pack of them
template <class D>
GYRO_HD Vec3<D> seen_centre(const Vec3<D>& centre, const Vec3<D>& velocity, const D& dt, const D& step) {
  return centre + D(0.5) * (dt - step) * velocity;
}

/// Whether a particle has left its bound, or nearly. Nothing that is not finite has.
/// @param centre, bound  of the bound: centre and radius [m]
/// @param seen, radius   of the particle [m]
template <class D>
GYRO_HD auto has_left(const Vec3<D>& centre, const D& bound, const Vec3<D>& seen, const D& radius) {
  const D way = bound - radius;
  return norm2(seen - centre) > D(1 - 1e-9) * way * way;
}

/// Whether two bounds touch or overlap.
GYRO_HD inline bool reach_each_other(const Sphere& a, const Sphere& b) {
  const double reach = a.radius + b.radius;
  return norm2(b.x - a.x) < reach * reach;  // not if one is not finite
}

/// How far particles may go, by their speed: in any direction, until neighbours are sought again.
struct Ways {
  double time;   ///< for which bounds are to hold [s]
  double speed;  ///< of any particle, at least: others push it [m/s]
  double min;    ///< smallest way over radius [-]
  double max;    ///< largest way over radius [-]
  double given;  ///< way of all particles, 0: by their speed [m]

  GYRO_HD double of(const Sphere& sphere, const Vec3d& velocity) const {
    if (given > 0) return given;
    const double way = time * (norm(velocity) + speed), largest = max * sphere.radius;
    return way < largest ? larger(way, min * sphere.radius) : largest;  // also if it is not finite
  }
};

/// Gives all particles their wide bounds, inside which candidates for contacts are sought.
struct SetWideBounds {
  ConstParticleView p;
  double dt;  ///< step of the scene [s]
  Ways ways;
  Sphere* wide;

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = p.position[n];
    const Vec3d v = p.motion[n].v;
    wide[n] = {seen_centre(sphere.x, v, dt, p.step[n]), sphere.radius + ways.of(sphere, v)};
  }
};

/// Gives all particles their close bounds, inside which pairs are sought among the candidates. They end where the wide
/// bounds end.
struct SetCloseBounds {
  ConstParticleView p;
  double dt;  ///< step of the scene [s]
  Ways ways;
  const Sphere* wide;
  Sphere* close;

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = p.position[n];
    const Vec3d v = p.motion[n].v, seen = seen_centre(sphere.x, v, dt, p.step[n]);
    close[n] = {seen, sphere.radius + smaller(ways.of(sphere, v), left(sphere, seen, n))};
  }
  /// What is left of a particle's way in its wide bound, at least 0 [m].
  GYRO_HD double left(const Sphere& sphere, const Vec3d& seen, Index n) const {
    const double way = (1 - 1e-9) * (wide[n].radius - sphere.radius) - norm(seen - wide[n].x);
    return way > 0 ? way : 0;
  }
};

/// What is left of the wide bounds.
struct Room {
  double smallest = 1e300;  ///< smallest of all particles: what is left of its way over the way it is to have [-]
  GYRO_HD friend Room operator+(const Room& a, const Room& b) { return {smaller(a.smallest, b.smallest)}; }
};
struct RoomIn {
  SetCloseBounds bounds;
  GYRO_HD Room operator()(Index n) const {
    const Sphere sphere = bounds.p.position[n];
    const Vec3d v = bounds.p.motion[n].v, seen = seen_centre(sphere.x, v, bounds.dt, bounds.p.step[n]);
    return {bounds.left(sphere, seen, n) / bounds.ways.of(sphere, v)};
  }
};

/// Sizes and speeds of all particles.
struct Flock {
  double smallest = 1e300;  ///< radius [m]
  double speed2 = 0;        ///< sum of the squares of speeds [m2/s2]
  GYRO_HD friend Flock operator+(const Flock& a, const Flock& b) {
    return {smaller(a.smallest, b.smallest), a.speed2 + b.speed2};
  }
};
struct FlockOf {
  ConstParticleView p;
  GYRO_HD Flock operator()(Index n) const { return {p.position[n].radius, norm2(p.motion[n].v)}; }
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/select.hpp"
#include "core/state/particles.hpp"

// Bounds: a particle has a sphere around it that it does not leave until its neighbours are sought again. Particles
// whose bounds are apart cannot touch until then. Fast particles have large bounds, slow ones small bounds, so that all
// of them leave theirs after about the same time.

namespace gyro {

/// Whether a particle has left its bound, or nearly. Nothing that is not finite has.
/// @param centre, bound  of the bound: centre and radius [m]
/// @param seen, radius   of the particle [m]
template <class D>
GYRO_HD auto has_left(const Vec3<D>& centre, const D& bound, const Vec3<D>& seen, const D& radius) {
  const D way = bound - radius;
  return norm2(seen - centre) > D(1 - 1e-6) * way * way;
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

/// How far contacts see a particle ahead of its position [m]. Ways are longer by that: at the start of a scene contacts
/// see positions.
GYRO_HD inline double way_ahead(const Vec3d& velocity, double dt, double step) {
  return time_to_middle(dt, step) * norm(velocity);
}

/// Gives all particles their wide bounds, inside which candidates for contacts are sought.
struct SetWideBounds {
  ConstParticleView p;
  double dt;  ///< step of the scene [s]
  Ways ways;
  Sphere* wide;

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = p.position[n];
    const Vec3d v = p.motion[n].v;
    const double step = p.step[n];
    wide[n] = {seen_centre(sphere.x, v, dt, step), sphere.radius + ways.of(sphere, v) + way_ahead(v, dt, step)};
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
    const double way = ways.of(sphere, v) + way_ahead(v, dt, p.step[n]);
    close[n] = {seen, sphere.radius + smaller(way, left(sphere, seen, n))};
  }
  /// What is left of a particle's way in its wide bound, at least 0 [m].
  GYRO_HD double left(const Sphere& sphere, const Vec3d& seen, Index n) const {
    const double way = (1 - 1e-6) * (wide[n].radius - sphere.radius) - norm(seen - wide[n].x);
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

/// Sizes and speeds of all particles: the smallest radius, and sums.
struct Flock {
  double smallest = 1e300;   ///< radius [m]
  double speed2 = 0;         ///< squares of speeds [m2/s2]
  double curvature = 0;      ///< 1/radius [1/m]
  double radii_in_time = 0;  ///< speed/radius [1/s]
  GYRO_HD friend Flock operator+(const Flock& a, const Flock& b) {
    return {smaller(a.smallest, b.smallest), a.speed2 + b.speed2, a.curvature + b.curvature,
            a.radii_in_time + b.radii_in_time};
  }
};
struct FlockOf {
  ConstParticleView p;
  GYRO_HD Flock operator()(Index n) const {
    const double radius = p.position[n].radius, speed2 = norm2(p.motion[n].v);
    return {radius, speed2, 1 / radius, ::sqrt(speed2) / radius};
  }
};

/// Steps for which lists are to hold, wide and close.
struct ListSteps {
  double wide, close;
};
/// The number of steps T that costs least, if a list of T steps costs (1 + g T)^3 (look + make/T) a step: the zero of
/// its derivative, 3 look g T^2 + 2 make g T - make.
GYRO_HD inline double cheapest_steps(double g, double look, double make) {
  return (::sqrt(make * make * g * g + 3 * look * make * g) - make * g) / (3 * look * g);
}
/// The numbers of steps that cost least. Particles whose ways are g radii a step, on average, have (1 + g T)^3 times
/// the neighbours if lists are to hold for T steps. In units of the cost of a look at a pair, choosing a pair again
/// costs 12, a look at a candidate meanwhile 1, and finding a candidate 10: of one core in S1 (tests/bench). No bit
/// depends on them.
///
/// T is less than 1/(2 g): however fast all particles are, their ways are half a radius in close and a radius in wide
/// bounds on average, as long as that is more than one step. So particles that fall together do not fill the memory
/// with pairs of which none touches.
GYRO_HD inline ListSteps steps_of_lists(double radii_in_step) {
  const double g = larger(radii_in_step, 1e-6);
  const double close = smaller(larger(cheapest_steps(g, 1, 12), 1.0), 60.0);
  return {smaller(larger(cheapest_steps(g, 1 / close, 10), 2 * close), 400.0), close};
}

}  // namespace gyro

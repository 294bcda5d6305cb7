// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/scenes.hpp"

namespace gyro::verify {

/// An elastic normal impact in closed form (Johnson, Contact Mechanics 1985, ch. 11): the largest
/// overlap [15 m* v^2/(16 E* sqrt(R*))]^(2/5), the duration 2.943275 overlap/v.
struct ElasticImpact {
  double overlap, force, duration;  ///< [m], [N], [s]
  /// @param youngs  E* [Pa]  @param radius  R* [m]  @param mass  m* [kg]  @param speed  of approach [m/s]
  ElasticImpact(double youngs, double radius, double mass, double speed);
};

/// What an impact left behind, and its peaks.
struct ImpactResult {
  Vec3d velocity, angular_velocity;  ///< of the first sphere, once apart [m/s], [rad/s]
  double force = 0;                  ///< largest on the first sphere [N]
  double overlap = 0;                ///< largest [m]
  double duration = 0;  ///< until the bodies are apart, between two steps by interpolation [s]; 0: they stay
};

/// A sphere that hits a wall.
struct WallImpact {
  Material material;
  PairProperties pair;
  double radius;
  Vec3d velocity, angular_velocity{0, 0, 0};  ///< the wall lies at z = 0, its normal is z
  double steps_per_contact = 1000;            ///< duration of the elastic impact / dt
  bool mesh = false;                          ///< a triangle instead of a plane
};
ImpactResult hit_wall(const WallImpact& impact, Precision precision);

/// A sphere that hits a rigid wall and slides or spins.
struct ObliqueImpact {
  Material material;
  PairProperties pair;
  double radius;
  double slide, fall;           ///< velocity along the wall and towards it [m/s]
  double angular_velocity = 0;  ///< positive as that of a sphere that rolls along the wall [rad/s]
};
/// What it left behind, in the directions of ObliqueImpact.
struct ObliqueResult {
  double slide, rebound, angular_velocity;
  double across;  ///< velocity and radius x spin out of the plane of the impact [m/s]
};
/// The plane of the impact is turned by half a radian about the wall's normal.
ObliqueResult hit_obliquely(const ObliqueImpact& impact, Precision precision);

/// Mean lever of a friction that is proportional to the force of an elastic impact, over the radius: friction
/// acts at R - overlap from the centre, and by the elastic law its mean is 1 - B(7/5, 1/2)/2 x peak/R.
double mean_lever(const ObliqueImpact& impact);

/// Two equal spheres that meet head on, each with the speed given.
ImpactResult meet(const Material& material, const PairProperties& pair, double radius, double speed,
                  double steps_per_contact, Precision precision);

}  // namespace gyro::verify

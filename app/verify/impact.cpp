// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/impact.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::verify {
namespace {

/// Runs until the contact of the first sphere is over. The bodies just touch at the start.
/// @param overlap  of the scene as it is now [m]
ImpactResult watch(Stage& stage, const std::function<double(const ParticleSnapshot&)>& overlap, double longest) {
  ImpactResult out;
  double before = 0;
  for (const double end = stage.time() + longest; stage.time() < end;) {
    stage.advance(1);
    const ParticleSnapshot now = stage.dem().particles();
    const double deep = overlap(now);
    out.velocity = now.velocity[0];
    out.angular_velocity = now.angular_velocity[0];
    if (deep <= 0) {
      out.duration = stage.time() + stage.dt() * deep / (before - deep);
      break;
    }
    before = deep;
    out.force = std::max(out.force, norm(now.force[0]));
    out.overlap = std::max(out.overlap, deep);
  }
  return out;
}

}  // namespace

ElasticImpact::ElasticImpact(double youngs, double radius, double mass, double speed) {
  overlap = std::pow(15 * mass * speed * speed / (16 * youngs * std::sqrt(radius)), 0.4);
  force = 4.0 / 3 * youngs * std::sqrt(radius) * std::pow(overlap, 1.5);
  duration = 2.943275 * overlap / speed;
}

ImpactResult hit_wall(const WallImpact& impact, Precision precision) {
  const Material& m = impact.material;
  const ElasticImpact elastic_one(youngs_against_rigid(m), impact.radius, sphere_mass(impact.radius, m.density),
                                  -impact.velocity.z);
  Scene scene = scene_of(m, rigid(), impact.pair, elastic_one.duration / impact.steps_per_contact);
  if (impact.mesh) {
    const double far = 50 * impact.radius;
    scene.walls = {
        {"floor", TriangleMesh{{{-far, -far, 0}, {far, -far, 0}, {0, 2 * far, 0}}, {{0, 1, 2}}}, Fixed{}, 1}};
  } else {
    scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1}};
  }
  Stage stage(scene, precision);
  stage.insert({sphere(0, {0, 0, impact.radius}, impact.velocity, impact.radius, m.density, impact.angular_velocity)});
  return watch(
      stage, [&](const ParticleSnapshot& s) { return s.radius[0] - s.position[0].z; }, 10 * elastic_one.duration);
}

ObliqueResult hit_obliquely(const ObliqueImpact& impact, Precision precision) {
  const Vec3d along{std::cos(0.5), std::sin(0.5), 0}, axis{-along.y, along.x, 0};
  WallImpact in_space{impact.material, impact.pair, impact.radius, impact.slide * along,
                      impact.angular_velocity * axis};
  in_space.velocity.z = -impact.fall;
  in_space.steps_per_contact = 2000;
  const ImpactResult got = hit_wall(in_space, precision);
  const Vec3d strange = got.angular_velocity - dot(got.angular_velocity, axis) * axis;
  return {dot(got.velocity, along), got.velocity.z, dot(got.angular_velocity, axis),
          std::abs(dot(got.velocity, axis)) + impact.radius * norm(strange)};
}

double mean_lever(const ObliqueImpact& impact) {
  const ElasticImpact peak(youngs_against_rigid(impact.material), impact.radius,
                           sphere_mass(impact.radius, impact.material.density), impact.fall);
  return 1 - 0.5 * std::beta(1.4, 0.5) * peak.overlap / impact.radius;
}

ImpactResult meet(const Material& material, const PairProperties& pair, double radius, double speed,
                  double steps_per_contact, Precision precision) {
  const ElasticImpact elastic_one(youngs_of_pair(material), radius / 2, sphere_mass(radius, material.density) / 2,
                                  2 * speed);
  Stage stage(scene_of(material, rigid(), pair, elastic_one.duration / steps_per_contact), precision);
  stage.insert({sphere(0, {-radius, 0, 0}, {speed, 0, 0}, radius, material.density)});
  stage.insert({sphere(1, {radius, 0, 0}, {-speed, 0, 0}, radius, material.density)});
  return watch(
      stage, [&](const ParticleSnapshot& s) { return 2 * radius - norm(s.position[1] - s.position[0]); },
      10 * elastic_one.duration);
}

}  // namespace gyro::verify

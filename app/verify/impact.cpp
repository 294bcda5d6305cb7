// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/impact.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::verify {
namespace {

/// Runs until the contact of the first sphere is over. @param overlap  of the scene as it is now [m]
ImpactResult watch(Stage& stage, const std::function<double(const ParticleSnapshot&)>& overlap, double longest) {
  ImpactResult out;
  double begin = -1;
  for (const double end = stage.time() + longest; stage.time() < end;) {
    stage.advance(1);
    const ParticleSnapshot now = stage.dem().particles();
    const double force = norm(now.force[0]);
    out.velocity = now.velocity[0];
    out.spin = now.spin[0];
    if (begin < 0 && force > 0) begin = stage.time();
    if (begin >= 0 && force == 0 && overlap(now) <= 0) break;
    out.force = std::max(out.force, force);
    out.overlap = std::max(out.overlap, overlap(now));
    if (begin >= 0) out.duration = stage.time() - begin;
  }
  return out;
}

}  // namespace

ElasticImpact::ElasticImpact(double youngs, double radius, double mass, double speed) {
  overlap = std::pow(15 * mass * speed * speed / (16 * youngs * std::sqrt(radius)), 0.4);
  force = 4.0 / 3 * youngs * std::sqrt(radius) * std::pow(overlap, 1.5);
  duration = 2.943275 * overlap / speed;
}

ImpactResult hit_wall(const WallImpact& impact, Loads loads) {
  const Material& m = impact.material;
  const ElasticImpact elastic_one(youngs_against_rigid(m), impact.radius, sphere_mass(impact.radius, m.density),
                                  -impact.velocity.z);
  Scene scene = scene_of(m, rigid(), impact.pair, elastic_one.duration / impact.steps_per_contact);
  if (impact.mesh) {
    const double far = 50 * impact.radius;
    scene.walls = {{"floor", MeshShape{{{-far, -far, 0}, {far, -far, 0}, {0, 2 * far, 0}}, {{0, 1, 2}}}, Fixed{}, 1}};
  } else {
    scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1}};
  }
  Stage stage(scene, loads);
  stage.insert({sphere(0, {0, 0, impact.radius}, impact.velocity, impact.radius, m.density, impact.spin)});
  return watch(
      stage, [&](const ParticleSnapshot& s) { return s.radius[0] - s.position[0].z; }, 10 * elastic_one.duration);
}

ImpactResult meet(const Material& material, const PairProperties& pair, double radius, double speed,
                  double steps_per_contact, Loads loads) {
  const ElasticImpact elastic_one(youngs_of_pair(material), radius / 2, sphere_mass(radius, material.density) / 2,
                                  2 * speed);
  Stage stage(scene_of(material, rigid(), pair, elastic_one.duration / steps_per_contact), loads);
  stage.insert({sphere(0, {-radius, 0, 0}, {speed, 0, 0}, radius, material.density)});
  stage.insert({sphere(1, {radius, 0, 0}, {-speed, 0, 0}, radius, material.density)});
  return watch(
      stage, [&](const ParticleSnapshot& s) { return 2 * radius - norm(s.position[1] - s.position[0]); },
      10 * elastic_one.duration);
}

}  // namespace gyro::verify

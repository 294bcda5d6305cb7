// SPDX-License-Identifier: GPL-3.0-or-later
// Spinning spheres that meet a wall or each other: tests 6 to 8 of Chung & Ooi, Granular Matter 13 (2011) 643.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <span>

namespace gyro::verify {
namespace {

using namespace fixtures;

constexpr double radius = 0.1, fall = 0.2;
constexpr PairProperties rough{0.4, 0.5, 0};
constexpr double gained = 0.4 * 1.5 * fall;  // mu (1 + e) v_n: velocity that friction gives a sliding sphere [m/s]
const std::string momentum = "momentum: friction mu (1 + e) m v_n";

const Material alloy = elastic(70e9, 0.33, 2700), nylon = elastic(2.5e9, 0.40, 1000),
               copper = elastic(120e9, 0.35, 8900);

std::string at_spin(double angular_velocity) {
  char text[32];
  std::snprintf(text, sizeof text, "at-%04.0f-mrad-s", 1000 * angular_velocity);
  return text;
}

/// Test 6, fast spins: the contact slides throughout.
void falls_and_slides(Recorder& out, const Material& material) {
  for (const double angular_velocity : {5.495, 22.86}) {
    const ObliqueImpact impact{material, rough, radius, 0, fall, angular_velocity};
    const ObliqueResult got = hit_obliquely(impact, out.precision());
    out.relative(at_spin(angular_velocity) + "-velocity", got.slide, gained, {1e-3, 1e-3}, momentum);
    out.relative(at_spin(angular_velocity) + "-spin-lost", angular_velocity - got.angular_velocity,
                 2.5 * gained / radius * mean_lever(impact), {1e-3, 1e-3}, momentum);
    out.absolute(at_spin(angular_velocity) + "-across", got.across, 0, {1e-12, 1e-6}, "symmetry");
  }
}

struct Row {
  double angular_velocity, velocity, angular_velocity_after;  ///< [rad/s], [m/s], [rad/s]
};

/// Test 6, slow spins: the contact sticks.
void falls_and_sticks(Recorder& out, const Material& material, std::span<const Row> rows) {
  const std::string source = "impact_reference.py: independent integration of the same law";
  for (const Row& row : rows) {
    const ObliqueResult got = hit_obliquely({material, rough, radius, 0, fall, row.angular_velocity}, out.precision());
    out.relative(at_spin(row.angular_velocity) + "-velocity", got.slide, row.velocity, {2e-3, 2e-3}, source);
    out.relative(at_spin(row.angular_velocity) + "-spin", got.angular_velocity, row.angular_velocity_after,
                 {2e-3, 2e-3}, source);
  }
}

/// Two spheres collide head on while they spin about z [rad/s]. @return their motion after they have separated
ParticleSnapshot two_meet(const Material& material, double spin_0, double spin_1, Precision precision) {
  Stage stage(scene_of(material, rigid(), rough, head_on_impact(material, radius, fall).duration / 1000), precision);
  stage.insert(head_on(material, radius, fall, spin_0, spin_1));
  stage.advance(4000);
  return stage.dem().particles();
}

/// Test 7: spheres with opposite spins roll on each other without slip.
void opposite_spins(Recorder& out, const Material& material) {
  for (const double angular_velocity : {0.175, 22.86}) {
    const ParticleSnapshot s = two_meet(material, angular_velocity, -angular_velocity, out.precision());
    out.relative(at_spin(angular_velocity) + "-first", s.angular_velocity[0].z, angular_velocity, {1e-12, 1e-12},
                 "no slip, no friction");
    out.relative(at_spin(angular_velocity) + "-second", s.angular_velocity[1].z, -angular_velocity, {1e-12, 1e-12},
                 "no slip, no friction");
    out.absolute(at_spin(angular_velocity) + "-velocity",
                 norm(s.velocity[0] + s.velocity[1]) + std::abs(s.velocity[0].y), 0, {1e-12, 1e-12},
                 "no slip, no friction");
    out.relative(at_spin(angular_velocity) + "-rebound", -s.velocity[0].x / fall, 0.5, {5e-4, 5e-4},
                 "prescribed restitution");
  }
}

/// Spheres with equal spins slide as on a wall; each sphere contributes half of the sliding speed.
void equal_spins(Recorder& out) {
  const double angular_velocity = 22.86;
  const ParticleSnapshot s = two_meet(alloy, angular_velocity, angular_velocity, out.precision());
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const std::string which = k == 0 ? "first" : "second";
    out.relative(which + "-velocity", (k == 0 ? -1 : 1) * s.velocity[k].y, gained, {1e-3, 1e-3}, momentum);
    out.relative(which + "-spin", s.angular_velocity[k].z, angular_velocity - 2.5 * gained / radius, {1e-3, 1e-3},
                 momentum);
  }
}

/// Test 8, reduced to what has an exact reference: a sphere that spins and slides hits a sphere of another size, and
/// the momenta are conserved.
void unequal_pair(Recorder& out, double other) {
  const double angular_velocity = 22.86, slide = 0.3;
  Stage stage(scene_of(alloy, rigid(), rough, impact_on_wall(alloy, radius, fall).duration / 2000), out.precision());
  stage.insert({sphere(0, {0, 0, radius}, {slide, 0, -fall}, radius, alloy.density, {3, angular_velocity, 1})});
  stage.insert({sphere(1, {0, 0, -other}, {0, 0, 0}, other, alloy.density)});
  const Vec3d p0 = stage.dem().momentum(), l0 = angular_momentum(stage.dem().particles());
  stage.advance(8000);
  const ParticleSnapshot s = stage.dem().particles();
  const double exchanged = norm(s.mass[0] * (s.velocity[0] - Vec3d{slide, 0, -fall}));  // [kg m/s]
  out.absolute("momentum", norm(stage.dem().momentum() - p0) / exchanged, 0, {1e-12, 1e-12}, "conserved");
  out.absolute("angular-momentum", norm(angular_momentum(s) - l0) / (exchanged * (radius + other)), 0, {1e-12, 1e-6},
               "conserved");
}

/// A partner of 50 m radius acts like a wall with half the stiffness of a rigid one.
void huge_partner(Recorder& out) {
  const double angular_velocity = 22.86, other = 50;
  const ElasticImpact theory(youngs_of_pair(alloy), radius, sphere_mass(radius, alloy.density), fall);
  Stage stage(scene_of(alloy, rigid(), rough, theory.duration / 2000), out.precision());
  stage.insert({sphere(0, {0, 0, radius}, {0, 0, -fall}, radius, alloy.density, {0, angular_velocity, 0})});
  stage.insert({sphere(1, {0, 0, -other}, {0, 0, 0}, other, alloy.density)});
  stage.advance(8000);
  const ParticleSnapshot s = stage.dem().particles();
  out.relative("velocity", s.velocity[0].x, gained, {3e-3, 3e-3}, "test 6 on a wall");
  out.relative("spin", s.angular_velocity[0].y, angular_velocity - 2.5 * gained / radius, {3e-3, 3e-3},
               "test 6 on a wall");
  out.relative("rebound", s.velocity[0].z / fall, 0.5, {3e-3, 3e-3}, "test 6 on a wall");
}

constexpr Row alloy_rows[] = {{0.175, 0.004952, 0.05122}, {0.9326, 0.026587, 0.26806}, {2.0, 0.064206, 0.39527}};
constexpr Row nylon_rows[] = {{0.175, 0.005029, 0.04934}, {0.9326, 0.027053, 0.25661}, {2.0, 0.065510, 0.36334}};

}  // namespace

std::vector<Verification> spin_cases() {
  return {
      {"spin/alloy-sliding-on-wall", [](Recorder& out) { falls_and_slides(out, alloy); }},
      {"spin/nylon-sliding-on-wall", [](Recorder& out) { falls_and_slides(out, nylon); }},
      {"spin/alloy-sticking-on-wall", [](Recorder& out) { falls_and_sticks(out, alloy, alloy_rows); }},
      {"spin/nylon-sticking-on-wall", [](Recorder& out) { falls_and_sticks(out, nylon, nylon_rows); }},
      {"spin/alloy-pair-opposite", [](Recorder& out) { opposite_spins(out, alloy); }},
      {"spin/copper-pair-opposite", [](Recorder& out) { opposite_spins(out, copper); }},
      {"spin/alloy-pair-equal", equal_spins},
      {"spin/pair-of-01-and-05-m", [](Recorder& out) { unequal_pair(out, 0.5); }},
      {"spin/pair-of-01-and-50-m", [](Recorder& out) { unequal_pair(out, 50); }},
      {"spin/huge-partner", huge_partner},
  };
}

}  // namespace gyro::verify

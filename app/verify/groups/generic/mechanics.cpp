// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetries and conservation laws that hold in any scene: drift, rotation, mirroring, order of insertion, time
// reversal, momenta.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

using namespace fixtures;

constexpr double dt = 2e-6;

Scene free_scene() {
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.05;
  return bonded_scene(dt, bonds, {0.5, 0.25, 0.02});
}

/// Two inclined rocks that collide off centre, and three spheres in their path. The whole scene is rotated and moves
/// with `drift`.
std::vector<NewRock> collision(const Quatd& orientation = {1, 0, 0, 0}, const Vec3d& drift = {0, 0, 0}) {
  const NewRock cube = lattice(0, 3, {.bond_radius = grain / 4});
  std::vector<NewRock> rocks{placed(cube, 0, 0, {-0.047, 0.01, 0}, rotation_by({0.24, 0, 0.32})),
                             placed(cube, 1, 100, {0.047, -0.01, 0.005}, rotation_by({0, 0.42, 0.56}))};
  for (NewParticle& p : rocks[0].particles) p.velocity = {2, 0, 0};
  for (NewParticle& p : rocks[1].particles) p.velocity = {-2, 0, 0.1};
  for (int k = 0; k < 3; ++k)
    rocks.push_back(sphere(static_cast<ParticleId>(200 + k), {0.002 * k, 0.09 * (k - 1) + 0.01, 0.03},
                           {0, -0.5 * (k - 1), -0.5}, 0.01, rock_density, {10, 20, 30}));
  for (NewRock& rock : rocks)
    for (NewParticle& p : rock.particles) {
      p.position = rotate(orientation, p.position);
      p.velocity = rotate(orientation, p.velocity) + drift;
      p.angular_velocity = rotate(orientation, p.angular_velocity);
    }
  return rocks;
}

ParticleSnapshot after(const Scene& scene, Precision precision, const std::vector<NewRock>& rocks, int steps) {
  Stage stage(scene, precision);
  stage.insert(rocks);
  stage.advance(steps);
  return stage.dem().particles();
}

using Column = std::vector<Vec3d>;

double largest_difference(const Column& a, const Column& b) {
  double maximum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) maximum = std::max(maximum, norm(a[k] - b[k]));
  return maximum;
}
double largest(const Column& a) {
  return largest_difference(a, Column(a.size(), Vec3d{0, 0, 0}));
}

/// With a constant force velocity Verlet is exact up to the rounding of 1e5 sums: x = x0 + v t - g t^2/2.
void free_fall(Recorder& out) {
  Scene scene = scene_of(elastic(1e9, 0.3, rock_density), rigid(), {0, 1, 0}, 1e-5);
  scene.gravity = {0, 0, -9.81};
  Stage stage(scene, out.precision());
  stage.insert({sphere(0, {0, 0, 0}, {3, -2, 1}, 0.01, rock_density, {5, 6, 7})});
  stage.advance(100000);
  const double t = stage.time();
  const ParticleSnapshot s = stage.dem().particles();
  const Vec3d v{3, -2, 1 - 9.81 * t}, x{3 * t, -2 * t, t - 0.5 * 9.81 * t * t};
  out.absolute("position", norm(s.position[0] - x) / norm(x), 0, {1e-11, 1e-11}, "parabola");
  out.absolute("velocity", norm(s.velocity[0] - v) / norm(v), 0, {1e-11, 1e-11}, "parabola");
  out.absolute("spin", norm(s.angular_velocity[0] - Vec3d{5, 6, 7}), 0, {0, 0}, "no torque");
}

void drift(Recorder& out) {
  const Vec3d wind{10, -10, 5};
  const ParticleSnapshot a = after(free_scene(), out.precision(), collision(), 3000);
  ParticleSnapshot b = after(free_scene(), out.precision(), collision({1, 0, 0, 0}, wind), 3000);
  for (Vec3d& x : b.position) x -= (3000 * dt) * wind;
  out.within("largest-force", largest(a.force), 10, 1e6, "the scene is loaded");
  // Positions are rounded to 1e-17 m, which at a bond stiffness of 2e8 N/m is 2e-9 N; a sphere has up to six bonds.
  out.absolute("force", std::max(0.0, largest_difference(a.force, b.force) - 12e-9) / largest(a.force), 0, {1e-9, 1e-3},
               "Galilean invariance");
  out.absolute("position", largest_difference(a.position, b.position) / grain, 0, {1e-9, 1e-4}, "Galilean invariance");
}

void rotated_scene(Recorder& out) {
  const Quatd q = normalised(Quatd{0.3, -0.5, 0.7, 0.2});
  ParticleSnapshot a = after(free_scene(), out.precision(), collision(), 10000);
  const ParticleSnapshot b = after(free_scene(), out.precision(), collision(q), 10000);
  for (std::size_t k = 0; k < a.size(); ++k) {
    a.position[k] = rotate(q, a.position[k]);
    a.angular_velocity[k] = rotate(q, a.angular_velocity[k]);
  }
  out.absolute("position", largest_difference(a.position, b.position) / grain, 0, {1e-8, 1e-3}, "rotation invariance");
  out.absolute("spin", largest_difference(a.angular_velocity, b.angular_velocity) / largest(a.angular_velocity), 0,
               {1e-8, 1e-3}, "rotation invariance");
}

void mirror(Recorder& out) {
  std::vector<NewRock> rocks = collision(), mirrored = rocks;
  for (NewRock& rock : mirrored)
    for (NewParticle& p : rock.particles) {
      p.position.x = -p.position.x;
      p.velocity.x = -p.velocity.x;
      p.angular_velocity = {p.angular_velocity.x, -p.angular_velocity.y, -p.angular_velocity.z};
    }
  const ParticleSnapshot a = after(free_scene(), out.precision(), rocks, 4000);
  ParticleSnapshot b = after(free_scene(), out.precision(), mirrored, 4000);
  for (std::size_t k = 0; k < b.size(); ++k) {
    b.position[k].x = -b.position[k].x;
    b.angular_velocity[k] = {b.angular_velocity[k].x, -b.angular_velocity[k].y, -b.angular_velocity[k].z};
  }
  out.absolute("position", largest_difference(a.position, b.position) / grain, 0, {1e-10, 1e-4}, "mirror symmetry");
  out.absolute("spin", largest_difference(a.angular_velocity, b.angular_velocity) / largest(a.angular_velocity), 0,
               {1e-8, 1e-3}, "mirror symmetry");
}

/// Rocks that break while they collide, inserted in three different orders.
void permutation(Recorder& out) {
  Scene scene = free_scene();
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 2e6;
  std::vector<NewRock> rocks = collision();
  const ParticleSnapshot a = after(scene, out.precision(), rocks, 3000);
  for (const char* order : {"reversed", "mixed"}) {
    if (order[0] == 'r') std::reverse(rocks.begin(), rocks.end());
    if (order[0] == 'm') std::swap(rocks[1], rocks[3]);
    const ParticleSnapshot b = after(scene, out.precision(), rocks, 3000);
    out.absolute(std::string(order) + "-positions", largest_difference(a.position, b.position), 0, {0, 0},
                 "to the bit");
    out.absolute(std::string(order) + "-forces", largest_difference(a.force, b.force), 0, {0, 0}, "to the bit");
    out.absolute(std::string(order) + "-spins", largest_difference(a.angular_velocity, b.angular_velocity), 0, {0, 0},
                 "to the bit");
  }
}

/// After all velocities are reversed, frictionless elastic spheres in a box return to their initial positions.
void time_reversal(Recorder& out) {
  constexpr double radius = 0.012;
  Scene scene = paper_scene(1e-5, {0, 1, 0});
  scene.gravity = {0, 0, -9.81};
  scene.walls = box({0.06, 0.06, 0.06});
  std::vector<NewRock> there;
  for (int k = 0; k < 27; ++k) {
    const auto r = [&](std::uint32_t draw) { return random_number(static_cast<std::uint64_t>(k), draw); };
    const Vec3d cell{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
    there.push_back(sphere(static_cast<ParticleId>(k), 0.03 * cell + 0.003 * Vec3d{r(0), r(1), r(2)},
                           2.0 * Vec3d{r(3), r(4), r(5)}, radius * (0.9 + 0.1 * r(9)), rock_density,
                           {r(6), r(7), r(8)}));
  }
  const ParticleSnapshot far = after(scene, out.precision(), there, 1000);
  std::vector<NewRock> back = there;
  double change = 0, missed = 0;
  for (std::size_t k = 0; k < back.size(); ++k) {
    NewParticle& p = back[k].particles[0];
    change = std::max(change, norm(far.velocity[k] - p.velocity));
    p.position = far.position[k];
    p.velocity = -far.velocity[k];
    p.angular_velocity = -far.angular_velocity[k];
  }
  const ParticleSnapshot home = after(scene, out.precision(), back, 1000);
  for (std::size_t k = 0; k < back.size(); ++k)
    missed = std::max(missed, norm(home.position[k] - there[k].particles[0].position) / radius);
  out.within("velocity-changed", change, 1, 100, "the spheres collided [m/s]");
  out.absolute("position", missed, 0, {1e-8, 1e-3}, "time reversal");
}

void momenta(Recorder& out) {
  Scene scene = free_scene();
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 2e6;
  Stage stage(scene, out.precision());
  stage.insert(collision());
  const Vec3d linear = stage.dem().momentum(), angular = angular_momentum(stage.dem().particles());
  stage.advance(5000);
  const double one_rock = 27 * sphere_mass(grain / 2, rock_density) * 2;  // [kg m/s]
  const Counts c = stage.dem().counts();
  out.within("broken-bonds", static_cast<double>(c.broken_tension + c.broken_shear), 6, 108, "the rocks broke");
  out.absolute("linear", norm(stage.dem().momentum() - linear) / one_rock, 0, {1e-12, 1e-6}, "closed system");
  out.absolute("angular", norm(angular_momentum(stage.dem().particles()) - angular) / (one_rock * 0.05), 0,
               {1e-12, 1e-6}, "closed system");
}

}  // namespace

std::vector<Verification> generic_mechanics_cases() {
  return {
      {"generic/free-fall", free_fall},
      {"generic/drift", drift},
      {"generic/rotated-scene", rotated_scene},
      {"generic/mirror", mirror},
      {"generic/permutation", permutation},
      {"generic/time-reversal", time_reversal},
      {"generic/momenta", momenta},
  };
}

}  // namespace gyro::verify

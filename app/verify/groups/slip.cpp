// SPDX-License-Identifier: GPL-3.0-or-later
// Sliding, sticking, and the transition between the two.
#include "app/verify/fixtures/held_sphere.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/on_floor.hpp"
#include "app/verify/fixtures/rig.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double g = OnFloor::g, radius = OnFloor::radius;
const std::string ball = "rigid-body mechanics of a ball";

/// A ball that starts to slide without spin begins to roll.
void begins_to_roll(Recorder& out) {
  const double mu = 0.5, v0 = 1, end = 2 * v0 / (7 * mu * g);
  OnFloor s({{mu, 0.5, 0}, 0, v0, 0}, out.precision());
  s.run_to(0.04);
  out.relative("velocity-while-sliding", s.speed(), v0 - mu * g * 0.04, {5e-4, 5e-4}, ball);
  out.relative("spin-while-sliding", s.angular_velocity(), 2.5 * mu * g * 0.04 / radius, {5e-4, 5e-4}, ball);
  double rolls_at = 0;
  while (rolls_at == 0 && s.time() < 2 * end) {
    s.step();
    if (s.speed() <= s.angular_velocity() * radius) rolls_at = s.time();
  }
  out.relative("time", rolls_at, end, {5e-3, 5e-3}, ball);
  out.relative("distance", s.x(), 12 * v0 * v0 / (49 * mu * g), {5e-3, 5e-3}, ball);
  s.run_to(rolls_at + 0.2);
  out.relative("velocity", s.speed(), 5.0 / 7 * v0, {5e-4, 5e-4}, ball);
  out.relative("spin", s.angular_velocity() * radius, 5.0 / 7 * v0, {5e-4, 5e-4}, ball);
}

/// On a slope of 30 degrees a ball slips below mu = tan(30)/3.5 = 0.165 and rolls above.
void slope(Recorder& out, double mu) {
  const double angle = pi / 6;
  OnFloor s({{mu, 0.5, 0}, angle, 0, 0}, out.precision());
  s.run_to(0.05);
  const double v = s.speed(), w = s.angular_velocity();
  s.run_to(0.35);
  const double a = (s.speed() - v) / 0.3, alpha = (s.angular_velocity() - w) / 0.3;
  const bool slips = std::tan(angle) > 3.5 * mu;
  const double expected = slips ? g * (std::sin(angle) - mu * std::cos(angle)) : 5.0 / 7 * g * std::sin(angle);
  out.relative("acceleration", a, expected, {1e-3, 1e-3}, ball);
  out.relative("spin-up", alpha, slips ? 2.5 * mu * g * std::cos(angle) / radius : expected / radius, {1e-3, 1e-3},
               ball);
}

const Material metal = elastic(70e9, 0.33, 2700);
const std::string mindlin = "Mindlin: St = 8 G* sqrt(R delta), G* = G/(2 - nu) on a rigid wall";

double shear_stiffness(double overlap) {
  return 8 * metal.shear_modulus / (2 - metal.poisson_ratio) * std::sqrt(radius * overlap);
}

/// A held sphere that touches the rig.
NewRock sphere_at_rig() {
  return held_sphere(0, Rig::contact + Vec3d{radius, 0, 0}, radius);
}

/// A held sphere is pressed with 100 N and sheared back and forth: the contact sticks with the stiffness St and slides
/// at mu N, and the work of a cycle is the area of its hysteresis loop.
void stick_and_slip(Recorder& out) {
  const double mu = 0.5, normal = 100;
  const double deep = static_overlap(youngs_against_rigid(metal), radius, normal), stiffness = shear_stiffness(deep);
  const double onset = mu * normal / stiffness, far = 3 * onset;
  Rig rig(metal, {mu, 1, 0}, 1e-6, sphere_at_rig(), out.precision());
  rig.move(deep, 0, 4000);
  out.relative("normal-force", rig.force().x, normal, {1e-6, 1e-5}, "Hertz");
  const double start = rig.force().y;  // caused by shear while the contact was pressed
  rig.move(0, 0.5 * onset, 4000);
  const double half = rig.force().y;
  out.relative("sticking-stiffness", (half - start) / (0.5 * onset), stiffness, {1e-5, 1e-4}, mindlin);
  rig.move(0, 0, 20000);
  out.relative("no-creep", rig.force().y, half, {1e-9, 1e-6}, "nothing moves");
  rig.move(0, 0.499 * onset, 4000);
  out.relative("still-sticking", rig.force().y - start, 0.999 * mu * normal, {1e-5, 1e-4}, mindlin);
  rig.move(0, far - 0.999 * onset, 4000);
  out.relative("sliding", rig.force().y, mu * normal, {1e-5, 1e-5}, "Coulomb");
  const double before = rig.work();
  rig.move(0, -2 * far, 20000);
  out.relative("sliding-back", rig.force().y, -mu * normal, {1e-5, 1e-5}, "Coulomb");
  rig.move(0, 2 * far, 20000);
  out.relative("work-of-a-cycle", rig.work() - before, 4 * mu * normal * (far - onset), {1e-3, 1e-3},
               "hysteresis 4 mu N (x0 - mu N/St)");
}

/// A sphere is bonded to a held sphere and touches the moving wall: the bond is the spring that holds it.
void through_a_spring(Recorder& out) {
  const double mu = 0.5, bond_radius = 0.02, length = 2 * radius, density = 2700, normal = 100;
  const double area = pi * bond_radius * bond_radius, inertia = pi * std::pow(bond_radius, 4) / 4;
  BondParameters bond;
  bond.normal_stiffness = 4e9;
  bond.shear_stiffness = 1e9;
  bond.tensile_strength = bond.shear_strength = 1e12;
  bond.damping = 0.3;
  NewRock rock = sphere(0, Rig::contact + Vec3d{radius, 0, 0}, {0, 0, 0}, radius, density);
  rock.id = 0;
  rock.particles.push_back(sphere_at_rig().particles[0]);
  rock.particles[1].id = 1;
  rock.particles[1].position += Vec3d{length, 0, 0};
  rock.bonds = {{0, 1, length, bond_radius, 1}};
  rock.colour_begin = {0, 1};
  Rig rig(metal, {mu, 0.5, 0}, 1e-6, rock, out.precision(), bond);

  const double deep = static_overlap(youngs_against_rigid(metal), radius, normal);
  rig.move(deep + normal / (bond.normal_stiffness * area), 0, 40000);
  rig.move(0, 0, 10000);
  // The sphere shifts and rotates: the bond is sheared, and it is bent with the lever from its middle to the contact.
  const double lever = radius - deep + length / 2;
  const double compliance =
      1 / shear_stiffness(deep) + 1 / (bond.shear_stiffness * area) + lever * lever / (bond.normal_stiffness * inertia);
  const double onset = mu * normal * compliance;
  const auto drift = [&] { return rig.particles().velocity[0].y; };
  const Vec3d start = rig.particles().position[0];
  rig.move(0, 0.6 * onset, 60000);
  rig.move(0, 0, 20000);
  const double shift = rig.particles().position[0].y - start.y;
  out.relative("sticking-shift", shift,
               0.6 * mu * normal *
                   (1 / (bond.shear_stiffness * area) + 0.5 * length * lever / (bond.normal_stiffness * inertia)),
               {2e-3, 2e-3}, "bond and contact in series, exact for one bond");
  out.absolute("no-creep", drift(), 0, {1e-9, 1e-6}, "at rest");
  rig.move(0, 1.4 * onset, 60000);
  rig.move(0, 0.1 * onset, 20000);
  const double slid = rig.particles().position[0].y - start.y;
  out.relative("sliding-shift", slid, shift / 0.6, {5e-3, 5e-3}, "force is cut to mu N");
}

/// A closed loop: load, shear by s, unload to a quarter of the overlap, shear back, unload. If the tangential spring
/// kept its force while the contact is unloaded, it would return St s^2/4 more work than it received.
void closed_loop(Recorder& out) {
  const double deep = 1e-5, shear = 1e-5;
  Rig rig(metal, {100, 1, 0}, 1e-6, sphere_at_rig(), out.precision());
  rig.move(deep, 0, 20000);
  rig.move(0, shear, 20000);
  rig.move(-0.75 * deep, 0, 20000);
  const double kept = rig.force().y;
  rig.move(0, -shear, 20000);
  const double left = rig.force().y;
  rig.move(-0.3 * deep, 0, 20000);
  const double full = shear_stiffness(deep) * shear;
  out.relative("force-after-unloading", kept, 0.5 * full, {1e-3, 1e-3}, "falls with St: sqrt(1/4)");
  out.absolute("force-after-shearing-back", left / full, 0, {1e-3, 1e-3}, "half the force, half the stiffness");
  out.relative("work", rig.work(), 0.25 * full * shear, {3e-3, 3e-3}, "St s^2 (1/2 - 1/4), never negative");
}

/// Sphere and wall rotate together, the sphere a little faster: the tangential spring grows by the difference, and
/// rotates with the contact.
void rotating_contact(Recorder& out) {
  const double deep = 1e-5, angular_velocity = 20, more = 1e-3, dt = 5e-5;
  const int steps = 1000;  // one radian
  Scene scene = scene_of(metal, rigid(), {100, 1, 0}, dt);
  const Vec3d centre{0, 0, radius - deep};
  scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, RotationMotion{{0, 1, 0}, centre, angular_velocity}, 1}};
  Stage stage(scene, out.precision());
  stage.insert({held_sphere(0, centre, radius, {0, 0, 0}, {0, angular_velocity + more, 0})});
  stage.advance(steps);
  const double angle = angular_velocity * stage.time(), normal = hertz_force(metal, radius, deep);
  const Vec3d up{std::sin(angle), 0, std::cos(angle)}, along{std::cos(angle), 0, -std::sin(angle)};
  const Vec3d force = stage.dem().particles().force[0];
  // The contact exists from the start, so that the spring has grown for one step more than the elapsed time.
  const double stretched = more * (radius - deep) * (steps + 1) * dt;
  out.relative("friction", dot(force, along), shear_stiffness(deep) * stretched, {1e-5, 1e-4}, mindlin);
  out.relative("normal-force", dot(force, up), normal, {1e-6, 1e-5}, "Hertz");
}

}  // namespace

std::vector<Verification> slip_cases() {
  return {
      {"slip/comes-to-roll", begins_to_roll},
      {"slip/slope-slipping", [](Recorder& out) { slope(out, 0.10); }},
      {"slip/slope-rolling", [](Recorder& out) { slope(out, 0.30); }},
      {"slip/stick-and-slip", stick_and_slip},
      {"slip/through-a-spring", through_a_spring},
      {"slip/closed-loop", closed_loop},
      {"slip/rotating-contact", rotating_contact},
  };
}

}  // namespace gyro::verify

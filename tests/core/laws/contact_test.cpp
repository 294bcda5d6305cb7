// SPDX-License-Identifier: GPL-3.0-or-later
// The contact law on prescribed paths, and the restitution behind its damping.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

#include "core/laws/contact/models.hpp"
#include "core/laws/contact/restitution.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

constexpr double youngs = 8.6e8, shear = 1.7e8, radius = 0.005, mass = 0.002;

ContactConstants<double> elastic_law() {
  return {youngs, shear, 0, 0.5, 0, 1e-6, 1, 1e6, std::sqrt(2 * youngs), std::sqrt(8 * shear)};
}
/// The law of a case that does not name one.
ContactLoad<double> hertz_mindlin(const ContactConstants<double>& law, const ContactMotion<double>& c,
                                  const ContactHistory<double>& history) {
  ExtraHistory<double> none{};
  return ContactLaw<Hertz, ConstantRolling>::load(law, c, history, none);
}
ContactMotion<double> resting(double overlap) {
  return {{0, 0, 1}, overlap, {0, 0, 0}, {0, 0, 0}, radius, mass, 2e-8, radius, 0};
}
double hertz(double overlap) {
  return 4.0 / 3 * youngs * std::sqrt(radius) * std::pow(overlap, 1.5);
}

/// Loads of a contact that was the same a step ago, except for the history of its spring.
ContactLoad<double> lasting(const ContactConstants<double>& law, const ContactMotion<double>& c,
                            const Vec3d& elastic = {0, 0, 0}, double overlap = 0) {
  ContactHistory<double> history{elastic, overlap, {0, 0, 0}};
  history.drag = hertz_mindlin(law, c, history).history.drag;
  return hertz_mindlin(law, c, history);
}

/// A contact that is moved along a path, with the work done against its tangential force.
struct Path {
  ContactConstants<double> law = elastic_law();
  ContactHistory<double> history{};
  double work = 0, lost = 0, smallest_loss = 0;

  void go(double to_overlap, const Vec3d& slip, int steps) {
    const double from = history.overlap;
    for (int k = 1; k <= steps; ++k) {
      ContactMotion<double> c = resting(from + (to_overlap - from) * k / steps);
      if (c.overlap <= 0) c.overlap = 1e-15;
      c.velocity = (1 / (steps * law.dt)) * slip;
      const ContactLoad<double> load = hertz_mindlin(law, c, history);
      work -= 0.5 * law.dt * dot(history.elastic + load.history.elastic, c.velocity);
      lost += load.slipped;
      smallest_loss = std::min(smallest_loss, load.slipped);
      history = load.history;
    }
  }
  double stored() const { return norm2(history.elastic) / (16 * law.shear * std::sqrt(radius * history.overlap)); }
};

}  // namespace

TEST_CASE("Remembered friction is laid into the plane at equal size, and stays finite if it stands on the plane",
          "[laws]") {
  const Vec3d normal{0, 0, 1};
  const Vec3d tilted{3, 0, 4}, upright{0, 0, 5};
  const Vec3d laid = laid_into_plane(tilted, norm2(tilted), normal);
  CHECK(laid.x == Approx(5));
  CHECK((laid.y == 0 && laid.z == 0));
  CHECK(norm(laid_into_plane(upright, norm2(upright), normal)) == 0);
  const Vec3<float> nearly{1e-7f, 0, 1e12f};  // 1e24 over the square of what lies flat is beyond single precision
  CHECK(norm(laid_into_plane(nearly, norm2(nearly), Vec3<float>{0, 0, 1})) <= 1e6f * 1e-7f);
  const Vec3d none{0, 0, 0};
  CHECK(norm(laid_into_plane(none, 0.0, normal)) == 0);
}

TEST_CASE("Roots of the stiffnesses belong to the constants of a contact", "[laws]") {
  const Material rock{"rock", 2600, 5.57e8, 0.35};
  PairProperties pair;
  pair.restitution = 0.5;
  const auto law = contact_constants<double>(rock, rock, pair, 1e-6);
  CHECK(law.youngs_root * law.youngs_root == Approx(2 * law.youngs));
  CHECK(law.shear_root * law.shear_root == Approx(8 * law.shear));
}

TEST_CASE("Normal force is Hertz's plus damping, and never pulls", "[laws][contact]") {
  ContactConstants<double> law = elastic_law();
  law.damping = 0.6;
  for (const double overlap : {1e-6, 1e-5, 1e-4}) {
    CHECK(-lasting(law, resting(overlap)).force.z == Approx(hertz(overlap)).epsilon(1e-12));
    const double stiffness = 2 * youngs * std::sqrt(radius * overlap);
    const double damper = 2 * std::sqrt(5.0 / 6) * 0.6 * std::sqrt(stiffness * mass);
    for (const double speed : {-3.0, -0.3, -0.01, 0.01, 0.3, 3.0}) {
      ContactMotion<double> c = resting(overlap);
      c.velocity = {0, 0, speed};
      const ContactLoad<double> load = lasting(law, c);
      CHECK(-load.force.z == Approx(std::max(0.0, hertz(overlap) + damper * speed)).epsilon(1e-12));
      CHECK(load.damped == Approx(law.dt * (-load.force.z - hertz(overlap)) * speed));
      CHECK(load.damped >= 0);
    }
  }
}

TEST_CASE("The work of the damping force is half that at the beginning of the step and half that at its end",
          "[laws][contact]") {
  ContactConstants<double> law = elastic_law();
  law.damping = 0.6;
  ContactMotion<double> c = resting(1e-5);
  c.velocity = {0.002, 0, 0.03};
  const ContactLoad<double> first = hertz_mindlin(law, c, {});
  c.velocity = {0.001, 0, 0.01};
  const ContactLoad<double> second = hertz_mindlin(law, c, first.history);
  CHECK(first.damped == Approx(-0.5 * law.dt * dot(first.history.drag, Vec3d{0.002, 0, 0.03})).epsilon(1e-14));
  CHECK(second.damped ==
        Approx(-0.5 * law.dt * dot(first.history.drag + second.history.drag, c.velocity)).epsilon(1e-14));
}

TEST_CASE("Stored energy of a contact is the work of Hertz's force", "[laws][contact]") {
  const double depth = 1e-4;
  double work = 0;
  const int steps = 20000;
  for (int k = 0; k < steps; ++k) work += hertz((k + 0.5) * depth / steps) * depth / steps;
  CHECK(contact_energy<double>({}, elastic_law(), radius, depth, {{0, 0, 0}, depth, {0, 0, 0}}, nullptr) ==
        Approx(work).epsilon(1e-6));
  CHECK(contact_energy<double>({}, elastic_law(), radius, depth, {{3, 4, 0}, depth, {0, 0, 0}}, nullptr) - work ==
        Approx(25 / (16 * shear * std::sqrt(radius * depth))).epsilon(1e-3));
}

TEST_CASE("A sticking contact is Mindlin's spring, a sliding one is Coulomb's limit exactly", "[laws][contact]") {
  const double overlap = 1e-5, limit = 0.5 * hertz(overlap), stiffness = 8 * shear * std::sqrt(radius * overlap);
  Path path;
  path.go(overlap, {0, 0, 0}, 1);
  path.go(overlap, {0.9 * limit / stiffness, 0, 0}, 10);
  CHECK(-path.history.elastic.x == Approx(0.9 * limit).epsilon(1e-12));
  CHECK(std::abs(path.lost) < 1e-12 * path.work);
  path.go(overlap, {0.2 * limit / stiffness, 0, 0}, 10);
  CHECK(-path.history.elastic.x == Approx(limit).epsilon(1e-14));
  path.go(overlap, {0, 3 * limit / stiffness, 0}, 100);
  CHECK(norm(path.history.elastic) == Approx(limit).epsilon(1e-14));

  // With damping and sliding the whole tangential force is the limit.
  ContactConstants<double> law = elastic_law();
  law.damping = 0.7;
  ContactMotion<double> c = resting(overlap);
  c.velocity = {0.5, 0.2, 0.01};
  const ContactLoad<double> load = hertz_mindlin(law, c, path.history);
  CHECK(norm(tangential(load.force, c.normal)) == Approx(0.5 * -load.force.z).epsilon(1e-14));
}

TEST_CASE("The tangential spring follows the tangent plane and keeps its length", "[laws][contact]") {
  ContactMotion<double> c = resting(1e-5);
  const Vec3d before{0.01, 0, 0};
  c.normal = {std::sin(0.1), 0, std::cos(0.1)};
  const ContactLoad<double> load = lasting(elastic_law(), c, before, c.overlap);
  CHECK(norm(load.history.elastic) == Approx(0.01).epsilon(1e-14));
  CHECK(std::abs(dot(load.history.elastic, c.normal)) < 1e-17);
  CHECK(load.history.elastic.x == Approx(0.01 * std::cos(0.1)).epsilon(1e-13));
}

TEST_CASE("Load, shear, unload, shear back creates no energy", "[laws][contact]") {
  // Without the softening while unloading this loop yields energy (Thornton & Randall 1988).
  const double friction = GENERATE(0.3, 5.0);
  const double back = GENERATE(-1.0, -0.5, -1.5);
  const double depth = 1e-4, slip = 2e-6;
  Path path;
  path.law.friction = friction;
  path.go(depth, {0, 0, 0}, 100);
  path.go(depth, {slip, 0, 0}, 100);
  path.go(depth / 4, {0, 0, 0}, 1000);
  path.go(depth / 4, {back * slip, 0, 0}, 100);
  CHECK(path.work == Approx(path.stored() + path.lost).epsilon(1e-9));
  path.go(0, {0, 0, 0}, 1000);
  CHECK(path.work > 0);
  CHECK(path.work == Approx(path.stored() + path.lost).epsilon(1e-9));
  CHECK(path.smallest_loss > -1e-12 * path.work);
}

TEST_CASE("Damping takes energy from any contact", "[laws][contact]") {
  ContactConstants<double> law = elastic_law();
  law.damping = 0.7;
  for (std::uint64_t k = 0; k < 300; ++k) {
    ContactMotion<double> c = resting(1e-5 * (1.2 + random_number(k, 0)));
    c.velocity = 0.05 * random_vector(k, 1);
    const Vec3d before = tangential((0.5 * hertz(c.overlap)) * random_vector(k, 4), c.normal);
    const ContactLoad<double> load = lasting(law, c, before, c.overlap * (1 + 0.1 * random_number(k, 7)));
    CHECK(load.damped >= -1e-15);
    CHECK(norm(tangential(load.force, c.normal)) <= 0.5 * -load.force.z * (1 + 1e-12));
  }
}

TEST_CASE("Rolling resistance is mu_r R* Fn, and near rest the torque that balances rotation and friction",
          "[laws][contact]") {
  ContactConstants<double> law = elastic_law();
  law.rolling = 0.05;
  ContactMotion<double> c = resting(1e-5);
  c.angular_velocity = {300, 400, 70};  // the part about the normal does not roll
  const ContactLoad<double> fast = lasting(law, c, {0, 0, 0}, c.overlap);
  CHECK(norm(fast.couple) == Approx(0.05 * radius * hertz(1e-5)).epsilon(1e-12));
  CHECK(dot(fast.couple, Vec3d{0.6, 0.8, 0}) == Approx(-norm(fast.couple)).epsilon(1e-12));
  CHECK(fast.slipped == Approx(law.dt * norm(fast.couple) * 500).epsilon(1e-12));
  c.angular_velocity = {1e-3, 0, 0};
  const ContactLoad<double> slow = lasting(law, c, {0, 0, 0}, c.overlap);
  CHECK(c.angular_velocity.x + 4 * slow.couple.x * law.dt / c.inertia == Approx(0).margin(1e-18));
  c.angular_velocity = {0, 0, 0};
  const ContactLoad<double> rest = lasting(law, c, {1e-3, 2e-3, 0}, c.overlap);
  CHECK(norm(rest.couple + c.lever * cross(c.normal, rest.force)) < 1e-15 * norm(rest.couple));
  CHECK(norm(rest.couple) > 0);
  CHECK(rest.slipped == Approx(0).margin(1e-18));
}

TEST_CASE("Restitution of a contact that cannot pull: published pairs", "[laws][contact]") {
  const double pairs[][2] = {{0.05, 1.94535}, {0.10, 1.24319}, {0.20, 0.73125}, {0.25, 0.59734},
                             {0.30, 0.49724}, {0.50, 0.25528}, {0.70, 0.12221}, {0.90, 0.03427}};
  for (const auto& [e, zeta] : pairs) {
    CHECK(damping_for_restitution(e) == Approx(zeta).margin(6e-6));
    CHECK(restitution_of_damping(damping_for_restitution(e)) == Approx(e).epsilon(1e-12));
  }
  CHECK(damping_for_restitution(1) == 0);
  CHECK(restitution_of_damping(1) == Approx(std::exp(-2.0)).epsilon(1e-12));
  CHECK(restitution_of_damping(1 - 1e-6) == Approx(std::exp(-2.0)).epsilon(1e-5));
  CHECK(restitution_of_damping(1 + 1e-6) == Approx(std::exp(-2.0)).epsilon(1e-5));
}

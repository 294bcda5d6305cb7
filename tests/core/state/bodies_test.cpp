// SPDX-License-Identifier: GPL-3.0-or-later
// Rotation of a rigid body without torque.
#include "core/state/bodies.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace gyro;

namespace {

Body body_with(const Vec3d& moments, const Vec3d& spin) {
  Body body{};
  body.orientation = rotation_about({0.6, 0, 0.8}, 0.7);
  body.spin = spin;
  body.diagonal = {1 / moments.x, 1 / moments.y, 1 / moments.z};
  return body;
}

double energy(const Body& body) {
  return 0.5 * dot(body.spin, angular_velocity(body, body.orientation));
}

}  // namespace

TEST_CASE("The inverse of a symmetric matrix undoes it, and a point has the inertia m (r r - |r|^2)", "[levels]") {
  Symmetric m{{2, 3, 4}, {0, 0, 0}};
  m.add_point(1.5, {0.3, -0.4, 0.5});
  CHECK(m.diagonal.x == Approx(2 + 1.5 * (0.16 + 0.25)));
  CHECK(m.rest.x == Approx(1.5 * 0.12));
  CHECK(m.rest.z == Approx(-1.5 * 0.15));
  const Vec3d v{0.2, 0.7, -1.1}, back = inverse(m) * (m * v);
  CHECK(norm(back - v) < 1e-14);
}

TEST_CASE("The axis of a symmetric body goes round its angular momentum at L/I", "[levels]") {
  // Landau & Lifshitz, Mechanics, section 33: the precession of a free symmetrical top.
  const double across = 3, along = 1, time = 2;
  const Vec3d spin{1, 2, 4};
  std::vector<double> errors;
  for (const int steps : {200, 400}) {
    Body body = body_with({across, across, along}, spin);
    const Vec3d before = rotate(body.orientation, Vec3d{0, 0, 1});
    for (int k = 0; k < steps; ++k) turn(body, time / steps);
    const double angle = norm(spin) / across * time;
    const Vec3d expected = rotate(rotation_about((1 / norm(spin)) * spin, angle), before);
    errors.push_back(norm(rotate(body.orientation, Vec3d{0, 0, 1}) - expected));
  }
  CHECK(errors[0] < 1e-3);
  CHECK(errors[1] == Approx(errors[0] / 4).epsilon(0.05));
}

TEST_CASE("The energy of a tumbling body does not drift", "[levels]") {
  Body body = body_with({1, 2, 3}, {0.4, 3, -0.5});  // near the middle axis, about which it turns over
  const double start = energy(body);
  double early = 0, late = 0;
  constexpr int steps = 40000;
  for (int k = 0; k < steps; ++k) {
    turn(body, 0.01);
    double& worst = k < steps / 2 ? early : late;
    worst = std::max(worst, std::abs(energy(body) / start - 1));
  }
  CHECK(early < 1e-4);
  CHECK(late < 1.1 * early);
}

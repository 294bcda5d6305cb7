// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers against published vectors, and rotations.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

bool is(const Random4& r, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return r.v[0] == a && r.v[1] == b && r.v[2] == c && r.v[3] == d;
}

}  // namespace

TEST_CASE("Philox gives the published known answers", "[math][random]") {
  // kat_vectors of Random123 (Salmon et al. 2011), philox4x32 with 10 rounds.
  const std::uint32_t f = 0xffffffffu;
  CHECK(is(philox(0, 0, {{0, 0, 0, 0}}), 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8));
  CHECK(is(philox(f, f, {{f, f, f, f}}), 0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd));
  CHECK(is(philox(0xa4093822, 0x299f31d0, {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}}), 0xd16cfe09, 0x94fdcceb,
           0x5001e420, 0x24126ea1));
}

TEST_CASE("Uniform numbers are uniform, and streams, things and draws differ", "[math][random]") {
  const int n = 40000;
  double sum = 0, square = 0, product = 0, smallest = 1, largest = 0;
  for (int k = 0; k < n; ++k) {
    const auto thing = static_cast<std::uint64_t>(k);
    const double u = uniform(3, Stream::size, thing, 0), w = uniform(3, Stream::turn, thing, 0);
    sum += u;
    square += u * u;
    product += (u - 0.5) * (w - 0.5);
    smallest = std::min(smallest, u);
    largest = std::max(largest, u);
  }
  const double error = 1 / std::sqrt(12.0 * n);  // of the mean
  CHECK(std::abs(sum / n - 0.5) < 4 * error);
  CHECK(std::abs(square / n - 1.0 / 3) < 4 * std::sqrt(4.0 / 45 / n));
  CHECK(std::abs(product / n) < 4.0 / 12 / std::sqrt(double(n)));
  CHECK(smallest > 0);
  CHECK(smallest < 1e-3);
  CHECK(largest < 1);
  CHECK(largest > 0.999);
  CHECK(uniform(3, Stream::size, 5, 0) != uniform(3, Stream::size, 5, 1));
  CHECK(uniform(3, Stream::size, 5, 0) != uniform(4, Stream::size, 5, 0));
  CHECK(uniform(std::uint64_t{1} << 40, Stream::size, 5, 0) != uniform(0, Stream::size, 5, 0));
  CHECK(uniform(3, Stream::size, std::uint64_t{1} << 40, 0) != uniform(3, Stream::size, 0, 0));
}

TEST_CASE("A quaternion rotates vectors as Rodrigues' formula says", "[math][quaternion]") {
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Vec3d raw = random_vector(k, 0), axis = (1 / norm(raw)) * raw, v = random_vector(k, 3);
    const double angle = 3 * random_number(k, 6), c = std::cos(angle), s = std::sin(angle);
    const Vec3d expected = c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
    const Quatd q = rotation_about(axis, angle);
    CHECK(distance(rotate(q, v), expected) < 2e-15);
    CHECK(distance(rotate_back(q, rotate(q, v)), v) < 2e-15);
    const Quatd p = random_orientation(k, 10);
    CHECK(distance(rotate(p * q, v), rotate(p, rotate(q, v))) < 2e-15);
    const Quatd longer{3.7 * q.w, 3.7 * q.x, 3.7 * q.y, 3.7 * q.z};
    CHECK(distance(rotate_any(longer, v), expected) < 2e-15);
  }
}

TEST_CASE("A step rotates a quaternion by 2 atan(w dt/2) and keeps its length", "[math][quaternion]") {
  const Vec3d w{30, 60, 80};
  const double dt = GENERATE(1e-6, 1e-3);
  const int steps = 1000;
  Quatd q = random_orientation(1, 0);
  const Quatd start = q;
  for (int k = 0; k < steps; ++k) q = rotated(q, w, dt);
  // renormalised() is exact to 35/128 x^4 with x = (w dt/2)^2, and forgets the error of the step before.
  const double half = norm(w) * dt / 2, short_of = 35.0 / 128 * std::pow(half, 8);
  CHECK(std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-15 + 2.1 * short_of);
  const double angle = steps * 2 * std::atan(norm(w) * dt / 2);
  const Quatd expected = rotation_about((1 / norm(w)) * w, angle) * start;
  const Vec3d v{0.3, -0.5, 0.8};
  CHECK(distance(rotate(q, v), rotate(expected, v)) < 1e-12 + 4.2 * short_of);
}

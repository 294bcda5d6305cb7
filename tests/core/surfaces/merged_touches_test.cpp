// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surfaces/merge.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

using namespace gyro;

namespace {

constexpr double pi = std::numbers::pi;

/// Sum of weight x overlap^1.5 x normal: the elastic force except for its constant.
Vec3d push(const WallTouches& touches) {
  Vec3d sum{0, 0, 0};
  for (int i = 0; i < touches.count; ++i)
    sum += touches.touch[i].weight * std::pow(-touches.touch[i].gap, 1.5) * touches.touch[i].normal;
  return sum;
}

WallTouches merged(std::vector<NearPoint> points, double radius) {
  const auto each_point = [&](FindDeepest& finder) {
    for (const NearPoint& p : points)
      if (finder.wants(p, Place::inside)) finder.take(p, Place::inside);
  };
  return merged_touches(visible_points(each_point), radius);
}

/// Valley of two planes through the origin along y, each risen by half the fold; closest points that lie
/// on the half-plane's own side only, and the seam itself as an edge.
WallTouches in_valley(double fold, double x, double z, double radius) {
  std::vector<NearPoint> points;
  for (const double side : {-1.0, 1.0}) {
    const Vec3d n{-side * std::sin(fold / 2), 0, std::cos(fold / 2)};
    const double along = side * x * std::cos(fold / 2) + z * std::sin(fold / 2);
    const double height = n.x * x + n.z * z;
    if (along >= 0 && height < radius) points.push_back({n, height});
  }
  const double seam = std::hypot(x, z);
  if (seam < radius) points.push_back({1 / seam * Vec3d{x, 0, z}, seam});
  return merged(points, radius);
}

}  // namespace

TEST_CASE("A point that belongs to several triangles counts once") {
  const NearPoint face{{0, 0, 1}, 0.9}, edge{{0, 0, 1}, 0.9};
  const WallTouches t = merged({edge, edge, face, edge}, 1);
  REQUIRE(t.count == 1);
  CHECK(t.touch[0].weight == 1);
  CHECK(t.touch[0].gap == Approx(-0.1));
}

TEST_CASE("M4: a corner of 90 degrees is two full contacts") {
  const double x = GENERATE(0.95, 0.97, 0.999), z = GENERATE(0.92, 0.99);
  const WallTouches t =
      merged({{{1, 0, 0}, x}, {{0, 0, 1}, z}, {1 / std::hypot(x, z) * Vec3d{x, 0, z}, std::hypot(x, z)}}, 1);
  REQUIRE(t.count == 2);
  CHECK(t.touch[0].weight == 1);
  CHECK(t.touch[1].weight == 1);
}

TEST_CASE("M4: the corner of a box is three full contacts") {
  const WallTouches t = merged({{{1, 0, 0}, 0.99}, {{0, 1, 0}, 0.98}, {{0, 0, 1}, 0.97}}, 1);
  REQUIRE(t.count == 3);
  for (const WallTouch& touch : t.touch) CHECK(touch.weight == 1);
  CHECK(t.touch[0].normal.z == 1);  // deepest first
}

TEST_CASE("M4: the force at a seam tends to that of a plane as the fold flattens, to first order") {
  double before = 0;
  for (const double degrees : {4.0, 2.0, 1.0, 0.5}) {
    const double fold = degrees * pi / 180;
    const WallTouches t = in_valley(fold, 0, 0.99 / std::cos(fold / 2), 1);
    REQUIRE(t.count == 2);
    CHECK(t.touch[0].weight + t.touch[1].weight == Approx(1).margin(fold * fold));
    CHECK(t.touch[0].weight == Approx(t.touch[1].weight).epsilon(1e-9));
    const double error = norm(push(t) - Vec3d{0, 0, std::pow(0.01, 1.5)}) / std::pow(0.01, 1.5);
    CHECK(error < fold);
    if (before > 0) CHECK(error < 0.6 * before);
    before = error;
  }
}

TEST_CASE("The force is continuous across a valley of any angle") {
  const double degrees = GENERATE(0.1, 1.0, 5.0, 30.0, 59.0, 61.0, 90.0);
  const double fold = degrees * pi / 180, height = 0.99 / std::cos(fold / 2);
  const double width = 1.3 * std::max(height * std::sin(fold / 2), 0.02);
  const auto largest_step = [&](int steps) {
    double largest = 0;
    Vec3d last = push(in_valley(fold, -width, height, 1));
    for (int i = 1; i <= steps; ++i) {
      const Vec3d now = push(in_valley(fold, width * (2.0 * i / steps - 1), height, 1));
      largest = std::max(largest, norm(now - last));
      last = now;
    }
    return largest / std::pow(0.01, 1.5);
  };
  // A jump would not shrink with the step.
  CHECK(largest_step(40000) < 0.15 * largest_step(4000));
}

TEST_CASE("The force is continuous when a third face begins and ends to touch") {
  // A bowl of three faces; the sphere passes the point at which the third one begins to touch.
  const double tilt = 0.3;
  const auto bowl = [&](double x, double y, double z) {
    std::vector<NearPoint> points;
    for (int k = 0; k < 3; ++k) {
      const double azimuth = 2 * pi * k / 3;
      const Vec3d n{-std::sin(tilt) * std::cos(azimuth), -std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
      const double height = dot(n, Vec3d{x, y, z});
      if (height < 1) points.push_back({n, height});
    }
    return push(merged(points, 1));
  };
  double coarse = 0, fine = 0;
  for (const int steps : {2000, 20000}) {
    Vec3d last = bowl(-0.1, 0.01, 1.03);
    double largest = 0;
    for (int i = 1; i <= steps; ++i) {
      const Vec3d now = bowl(-0.1 + 0.2 * i / steps, 0.01, 1.03);
      largest = std::max(largest, norm(now - last));
      last = now;
    }
    (steps == 2000 ? coarse : fine) = largest;
  }
  CHECK(fine < 0.15 * coarse);
}

TEST_CASE("Many nearly parallel faces share one weight and leave three contacts") {
  std::vector<NearPoint> points;
  for (int k = 0; k < 8; ++k) {
    const double azimuth = 2 * pi * k / 8, tilt = 0.01;
    points.push_back(
        {{-std::sin(tilt) * std::cos(azimuth), -std::sin(tilt) * std::sin(azimuth), std::cos(tilt)}, 0.99});
  }
  const WallTouches t = merged(points, 1);
  CHECK(t.count <= 3);
  double sum = 0;
  for (int i = 0; i < t.count; ++i) sum += t.touch[i].weight;
  CHECK(sum == Approx(1).margin(1e-3));
  CHECK(norm(push(t) - Vec3d{0, 0, 1e-3}) < 2e-6);
}

TEST_CASE("The order of the triangles changes no bit") {
  std::vector<NearPoint> points{
      {{0, 0, 1}, 0.97}, {{0.6, 0, 0.8}, 0.96}, {{0, 0.28, 0.96}, 0.97}, {{0.1, 0.1, std::sqrt(0.98)}, 0.99}};
  const WallTouches first = merged(points, 1);
  std::vector<int> order{0, 1, 2, 3};
  do {
    std::vector<NearPoint> shuffled;
    for (const int i : order) shuffled.push_back(points[static_cast<std::size_t>(i)]);
    const WallTouches t = merged(shuffled, 1);
    REQUIRE(t.count == first.count);
    for (int i = 0; i < t.count; ++i) {
      CHECK(t.touch[i].weight == first.touch[i].weight);
      CHECK(t.touch[i].gap == first.touch[i].gap);
      CHECK(norm(t.touch[i].normal - first.touch[i].normal) == 0);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

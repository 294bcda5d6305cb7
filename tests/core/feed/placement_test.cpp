// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/placement.hpp"

#include "core/math/random.hpp"
#include "scenes.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

constexpr double R = 0.05, gap = 1e-4, never = std::numeric_limits<double>::infinity();
const Region box = BoxRegion{{-1, -1, 0}, {1, 1, 2}};
const Quatd straight{1, 0, 0, 0};

double height_of(const Bed& bed, const std::vector<Wall>& walls, double x, double y = 0) {
  const FeedRegion region(box, walls);
  WallSet set(walls, R, gap);
  return Placement(region, set, bed, gap).lowest_height(sphere_rock(R), x, y, straight, never);
}

}  // namespace

TEST_CASE("A sphere is placed on the foot of its region, or on the sphere below", "[feed]") {
  Bed bed;
  CHECK(height_of(bed, {}, 0.3) == Approx(R).epsilon(1e-14));
  bed.add({0, 0, R}, R);
  const double offset = GENERATE(0.0, 0.03, 0.06, 0.09);
  CHECK(height_of(bed, {}, offset) ==
        Approx(R + std::sqrt((2 * R + gap) * (2 * R + gap) - offset * offset)).epsilon(1e-12));
  CHECK(height_of(bed, {}, 2 * R + 2 * gap) == Approx(R).epsilon(1e-12));
}

TEST_CASE("The lowest free height is found below others too", "[feed]") {
  Bed bed;
  bed.add({0, 0, 10 * R}, R);  // suspended, with room below it
  CHECK(height_of(bed, {}, 0) == Approx(R).epsilon(1e-12));
  bed.add({0, 0, R}, R);
  CHECK(height_of(bed, {}, 0) == Approx(3 * R + gap).epsilon(1e-12));
  bed.add({0, 0, 6 * R}, 2 * R);  // closes the room between
  CHECK(height_of(bed, {}, 0) == Approx(11 * R + R + gap).epsilon(1e-12));
}

TEST_CASE("Spheres of very different size are found in a bed", "[feed]") {
  Bed bed;
  bed.add({0.4, 0, 0.3}, 0.3);
  bed.add({0, 0, 0.004}, 0.004);
  CHECK(bed.raised({0, 0, 0.005}, 0.004, 0) == Approx(0.012).epsilon(1e-12));
  CHECK(bed.raised({0.4, 0.1, 0.7}, 0.2, 0) == Approx(0.3 + std::sqrt(0.25 - 0.01)).epsilon(1e-12));
  CHECK(bed.raised({0.4, 0.1, 0.8}, 0.2, 0) == 0.8);
}

TEST_CASE("A bed raises to the same height as a brute-force search", "[feed]") {
  Bed bed;
  std::vector<Vec3d> centres;
  std::vector<double> radii;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const auto u = [k](std::uint32_t draw) { return uniform(9, Stream::place, k, draw); };
    centres.push_back({2 * u(0) - 1, 2 * u(1) - 1, 1.5 * u(2)});
    radii.push_back(0.01 * std::pow(6.0, u(3)));
    bed.add(centres.back(), radii.back());
  }
  for (std::uint64_t k = 0; k < 300; ++k) {
    const Vec3d p{1.6 * uniform(10, Stream::place, k, 0) - 0.8, 1.6 * uniform(10, Stream::place, k, 1) - 0.8, 0};
    double z = R;  // lowest height that no sphere's forbidden interval covers
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t s = 0; s < centres.size(); ++s) {
        const double apart = R + radii[s] + gap;
        const double h2 = apart * apart - std::pow(p.x - centres[s].x, 2) - std::pow(p.y - centres[s].y, 2);
        if (h2 > 0 && std::abs(z - centres[s].z) < std::sqrt(h2) * (1 - 1e-12)) {
          z = centres[s].z + std::sqrt(h2);
          moved = true;
        }
      }
    }
    CHECK(height_of(bed, {}, p.x, p.y) == Approx(z > 2 - R ? never : z).epsilon(1e-9));
  }
}

TEST_CASE("A sphere stands on planes, in cones and in meshes of them", "[feed]") {
  const double slope =
      0.6;  // cone z = slope r, rock above: the sphere touches at height R sqrt(1 + slope^2) on the axis
  ProfileShape cone{{{0, 0}, {2, 2 * slope}}};  // travels outwards: left is up
  const double exact = (R + gap) * std::sqrt(1 + slope * slope);
  CHECK(height_of({}, {{"cone", cone, Fixed{}, 0}}, 0) == Approx(exact).margin(gap));
  CHECK(height_of({}, {{"cone", cone, Fixed{}, 0}}, 0.3, 0.4) == Approx(exact + 0.5 * slope).margin(gap));

  const double s = 1 / std::sqrt(1 + slope * slope);
  const PlaneShape plane{{0, 0, 0}, {-slope * s, 0, s}};
  CHECK(height_of({}, {{"plane", plane, Fixed{}, 0}}, 0.3) == Approx(exact + 0.3 * slope).margin(gap));

  const double a = 3;
  TriangleMesh mesh{{{-a, -a, -a * slope}, {a, -a, a * slope}, {a, a, a * slope}, {-a, a, -a * slope}},
                    {{0, 1, 2}, {0, 2, 3}}};
  CHECK(height_of({}, {{"mesh", mesh, Fixed{}, 0}}, 0.05) == Approx(exact + 0.05 * slope).margin(gap));
  CHECK(height_of({}, {{"mesh", mesh, Fixed{}, 0}}, 0.3) == R);  // a mesh has two sides: there is room below it
}

TEST_CASE("A rock of several spheres rests on the first one in contact", "[feed]") {
  RockTemplate rod = sphere_rock(R);
  rod.centres = {{-2 * R, 0, 0}, {0, 0, 0}, {2 * R, 0, 0}};
  rod.radii = {R, R, R};
  Bed bed;
  bed.add({2.5 * R, 0, R}, R);
  const FeedRegion region(box, {});
  WallSet walls({}, R, gap);
  const Placement placement(region, walls, bed, gap);
  const double on_top = R + std::sqrt((2 * R + gap) * (2 * R + gap) - R * R / 4);
  CHECK(placement.lowest_height(rod, 0, 0, straight, never) == Approx(on_top).epsilon(1e-12));
  // Upright it rests on its lowest sphere; rotated by 90 degrees about z it misses the sphere.
  const Quatd upright = rotation_about({0, 1, 0}, std::numbers::pi / 2);
  CHECK(placement.lowest_height(rod, 0, 0, upright, never) == Approx(3 * R).epsilon(1e-12));
  const Quatd across = rotation_about({0, 0, 1}, std::numbers::pi / 2);
  CHECK(placement.lowest_height(rod, 0, 0, across, never) == Approx(R).margin(1e-12));
  CHECK(placement.lowest_height(rod, 0, 0, straight, 2 * R) == never);    // above the limit
  CHECK(placement.lowest_height(rod, 0.9, 0, straight, never) == never);  // through the side
}

TEST_CASE("Orientations are uniform over all rotations", "[feed]") {
  // A rotated x axis is uniform on the sphere: each component has mean 0 and mean square 1/3, and
  // the trace of the rotation, 4 w^2 - 1, has mean 0 and variance 1.
  const int n = 20000;
  Vec3d mean{0, 0, 0}, square{0, 0, 0};
  double trace = 0;
  for (std::uint64_t k = 0; k < n; ++k) {
    const auto u = [k](std::uint32_t draw) { return uniform(3, Stream::turn, k, draw); };
    const Quatd q = uniform_orientation(u(0), u(1), u(2));
    const Vec3d x = rotate(q, Vec3d{1, 0, 0});
    mean += x;
    square += {x.x * x.x, x.y * x.y, x.z * x.z};
    trace += 4 * q.w * q.w - 1;
  }
  const double se = 5 / std::sqrt(n);  // five standard errors of a unit variable
  for (const double m : {mean.x, mean.y, mean.z}) CHECK(std::abs(m / n) < se * std::sqrt(1.0 / 3));
  for (const double m : {square.x, square.y, square.z}) CHECK(std::abs(m / n - 1.0 / 3) < se * std::sqrt(4.0 / 45));
  CHECK(std::abs(trace / n) < se);
}

TEST_CASE("A bed of spheres of very different sizes finds what a look at all of them finds", "[feed]") {
  Bed bed;
  std::vector<Vec3d> centres;
  std::vector<double> radii;
  std::uint32_t draws = 0;
  const auto draw = [&] { return uniform(7, Stream::place, 0, draws++); };
  for (int k = 0; k < 300; ++k) {
    centres.push_back({draw(), draw(), draw()});
    radii.push_back(0.2 * std::pow(10.0, -6 * draw()));
    bed.add(centres.back(), radii.back());
  }
  for (const double radius : {1e-6, 1e-3, 0.1, 10.0}) {
    const Vec3d at{draw(), draw(), draw()};
    std::vector<Index> wanted;
    for (std::size_t k = 0; k < centres.size(); ++k)
      if (norm2(at - centres[k]) < (radius + radii[k]) * (radius + radii[k])) wanted.push_back(static_cast<Index>(k));
    CHECK(bed.overlapped(at, radius) == wanted);
  }
  CHECK(bed.overlapped({1e7, -1e7, 1e7}, 1e-6).empty());
}

TEST_CASE("Rocks look for room from the foot of a charge, or from two diameters below where it is high", "[feed]") {
  BedSurface surface({{-1, -1, 0.5}, {1, 1, 3}}, 0.5, 0.1);
  CHECK(surface.floor(0, 0) == 0.5);
  surface.add({0.05, 0.05, 0.88}, 0.01);
  CHECK(surface.floor(0.05, 0.05) == 0.5);
  surface.add({0.05, 0.05, 0.95}, 0.01);
  surface.add({0.05, 0.05, 0.7}, 0.01);
  CHECK(surface.floor(0.05, 0.05) == Approx(0.76).epsilon(1e-12));
  CHECK(surface.floor(0.25, 0.05) == 0.5);
  CHECK(surface.floor(7, -7) == 0.5);  // outside of the bounds
}

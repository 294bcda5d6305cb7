// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/fill.hpp"
#include "core/base/errors.hpp"
#include "core/geometry/mesh.hpp"
#include "core/rocks/packing.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyro;

TEST_CASE("The packing is dense, random and hardly overlaps") {
  const Packing& packing = rock_packing();
  const double side = packing.side;
  CHECK(packing.fraction > 0.58);
  CHECK(packing.fraction < 0.64);
  double closest = 2, neighbours = 0;
  for (std::size_t i = 0; i < packing.centres.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3d d = packing.centres[i] - packing.centres[j];
      const auto wrap = [&](double x) { return x - side * std::nearbyint(x / side); };
      const double r = norm(Vec3d{wrap(d.x), wrap(d.y), wrap(d.z)});
      closest = std::min(closest, r);
      neighbours += r < 2.05 ? 2 : 0;
    }
  }
  CHECK(2 - closest < 0.01);  // one percent of the radius
  CHECK(packing.overlap == Approx(2 - closest).margin(1e-9));
  const double n = static_cast<double>(packing.centres.size());
  CHECK(packing.fraction == Approx(n * 4 * std::numbers::pi / 3 / (side * side * side)));
  CHECK(neighbours / n > 6.5);  // a crystal of this density has below 6, random packing 7
  CHECK(neighbours / n < 8);
}

TEST_CASE("Particle counts by fill ratio") {
  struct Case {
    double ratio;
    std::size_t minimum, maximum;
  };
  const Case c = GENERATE(Case{10, 550, 650}, Case{6, 115, 140}, Case{4, 33, 42}, Case{2, 3, 7});
  const BondRule rule{0.05, RelativeBondRadius{0.5}};
  for (int rock = 0; rock < 12; ++rock) {
    const Mould mould(procedural_shape(1, rock));
    const Filling f = fill(mould, MonoFill{c.ratio}, rule, {1, 42, static_cast<std::uint64_t>(rock)});
    CAPTURE(c.ratio, rock, f.centres.size());
    CHECK(f.centres.size() >= c.minimum);
    CHECK(f.centres.size() <= c.maximum);
    CHECK(f.radii[0] == Approx(std::cbrt(6 / std::numbers::pi) / 2 / c.ratio));
    const auto bonds = make_bonds(f.centres, f.radii, rule);
    CHECK(largest_piece(bonds, static_cast<Index>(f.centres.size())).size() == f.centres.size());
    for (const Vec3d& p : f.centres) CHECK(mould.inside.contains(p));
  }
}

TEST_CASE("A smooth fill touches the faces of its shape and crosses none") {
  const double ratio = GENERATE(6.0, 8.0);
  const double slenderness = 2, loading_angle = GENERATE(0.0, 0.5);
  const Mould mould(cylinder_shape(slenderness, loading_angle));
  const Filling f =
      fill(mould, MonoFill{ratio, MonoFill::Surface::smooth}, {0.05, RelativeBondRadius{0.5}}, {1, 42, 0});
  const double r = f.radii[0], end = bounding_box(mould.shape.surface).high.x;
  CHECK(std::cbrt(6 / std::numbers::pi) / (2 * r) == Approx(ratio).epsilon(0.01));
  int at_end = 0;
  for (const Vec3d& p : f.centres) {
    for (const InsideTest::Plane& plane : mould.inside.planes())
      CHECK(dot(plane.normal, p) <= plane.offset - 0.99 * r);  // overlaps of at most 1 %
    at_end += p.x > end - 1.05 * r ? 1 : 0;
  }
  // A dense layer of discs covers 0.8 of the end face.
  const double face = 1 / (2 * end);
  CAPTURE(ratio, at_end, f.centres.size());
  CHECK(at_end > 0.4 * face / (std::numbers::pi * r * r));
  CHECK(sphere_volume(f.radii) > 0.5);
}

TEST_CASE("A smooth fill depends on the seed and needs a convex shape") {
  const Mould mould(cylinder_shape(0.5));
  const MonoFill smooth{5, MonoFill::Surface::smooth};
  const Filling a = fill(mould, smooth, {}, {1, 1, 0}), same = fill(mould, smooth, {}, {1, 1, 0});
  CHECK(norm(a.centres[0] - same.centres[0]) == 0);
  CHECK(norm(a.centres[0] - fill(mould, smooth, {}, {1, 2, 0}).centres[0]) > 0);
  ShapeStyle rough;
  rough.roughness = 0.1;
  const Mould stone(procedural_shape(1, 0, rough));
  CHECK_THROWS_WITH(fill(stone, smooth, {}, {1, 1, 0}), Catch::Matchers::Contains("convex"));
}

TEST_CASE("A rock larger than the packing is tiled from it, without overlaps at the seams") {
  const Mould mould(procedural_shape(1, 0));
  const Filling f = fill(mould, MonoFill{22}, {0.05, RelativeBondRadius{0.5}}, {1, 42, 0});
  CHECK(static_cast<double>(f.centres.size()) == Approx(rock_packing().fraction * 22 * 22 * 22).epsilon(0.01));
  double deepest = 0;
  for (const TemplateBond& b : make_bonds(f.centres, f.radii, {0, RelativeBondRadius{1}})) {
    deepest = std::max(deepest, 2 - b.length / f.radii[0]);
  }
  CHECK(deepest < 0.01);
}

TEST_CASE("A filling depends on seed and rock only") {
  const Mould mould(procedural_shape(1, 0));
  const BondRule rule{};
  const Filling a = fill(mould, MonoFill{6}, rule, {1, 42, 3}), b = fill(mould, MonoFill{6}, rule, {1, 42, 3});
  REQUIRE(a.centres.size() == b.centres.size());
  for (std::size_t k = 0; k < a.centres.size(); ++k) CHECK(norm(a.centres[k] - b.centres[k]) == 0);
  CHECK(norm(fill(mould, MonoFill{6}, rule, {1, 42, 4}).centres[0] - a.centres[0]) > 0);
}

TEST_CASE("Neighbours in memory are neighbours in space") {
  const Mould mould(procedural_shape(1, 1));
  const Filling f = fill(mould, MonoFill{10}, {}, {1, 1, 1});
  double along = 0;
  for (std::size_t k = 1; k < f.centres.size(); ++k) along += norm(f.centres[k] - f.centres[k - 1]);
  // In random order: 36/35 of the rock's radius, the mean distance of two points in a ball, 10 particle radii.
  CHECK(along / static_cast<double>(f.centres.size()) < 5 * f.radii[0]);
}

TEST_CASE("Ratios and gaps out of range are refused") {
  const Mould mould(procedural_shape(1, 0));
  CHECK_THROWS_AS(fill(mould, MonoFill{1.5}, {}, {1, 1, 0}), BadInput);
  CHECK_THROWS_AS(fill(mould, MonoFill{1e6}, {}, {1, 1, 0}), BadInput);
  CHECK_THROWS_AS(fill(mould, MonoFill{NAN}, {}, {1, 1, 0}), BadInput);
}

TEST_CASE("A plate thinner than its particles is refused, because they do not form one piece") {
  const Mould plate(make_shape(block({10, 10, 0.1})));
  CHECK_THROWS_WITH(fill(plate, MonoFill{4}, {}, {1, 1, 0}), Catch::Matchers::Contains("do not hold together"));
  CHECK_NOTHROW(fill(plate, MonoFill{40}, {}, {1, 1, 0}));
}

TEST_CASE("The inertia of two spheres is that of a dumb-bell") {
  const double m = 4 * std::numbers::pi / 3;
  const auto t = sphere_inertia({{1, 5, 5}, {4, 5, 5}}, {1, 1}, 1);
  CHECK(t[0] == Approx(2 * 0.4 * m));
  CHECK(t[1] == Approx(2 * m * (0.4 + 1.5 * 1.5)));
  CHECK(centre_of_mass({{0, 0, 0}, {9, 0, 0}}, {1, 2}).x == Approx(8));
}

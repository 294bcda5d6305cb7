// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapes.hpp"
#include "core/base/errors.hpp"
#include "core/geometry/edges.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/rough_surface.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"

#include <set>

using namespace gyro;

TEST_CASE("A hull is a solid around its points") {
  const TriangleMesh hull = convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}});
  CHECK(hull.vertices.size() == 4);
  CHECK(check_edges(hull).is_solid());
  CHECK(mass_properties(hull).volume == Approx(1.0 / 6));
}

TEST_CASE("Procedural rocks are normalised solids of the stated proportions") {
  std::set<std::size_t> faces;
  for (int k = 0; k < 40; ++k) {
    const RockShape rock = procedural_shape(7, k);
    CAPTURE(k);
    CHECK(check_edges(rock.surface).is_solid());
    const MassProperties p = mass_properties(rock.surface);
    CHECK(p.volume == Approx(1).epsilon(1e-12));
    CHECK(norm(p.centroid) < 1e-12);
    CHECK(p.inertia[0] == Approx(rock.inertia.x).epsilon(1e-10));
    CHECK(p.inertia[2] == Approx(rock.inertia.z).epsilon(1e-10));
    for (int d = 3; d < 6; ++d) CHECK(std::abs(p.inertia[d]) < 1e-10);
    CHECK(rock.inertia.x <= rock.inertia.y);
    CHECK(rock.inertia.y <= rock.inertia.z);
    // Axes of the ellipsoid of the same moments: c/a from 0.42 to 0.9 as drawn, and some jitter.
    const Vec3d i = rock.inertia;
    const double flatness = std::sqrt((i.x + i.y - i.z) / (i.y + i.z - i.x));
    CHECK(flatness > 0.35);
    CHECK(flatness < 1);
    const double diameter = std::cbrt(6 / 3.14159265358979);
    CHECK(rock.sieve_size > 0.7 * diameter);
    CHECK(rock.sieve_size < 1.1 * diameter);
    faces.insert(rock.surface.triangles.size());
  }
  CHECK(faces.size() > 5);
}

TEST_CASE("A shape depends on seed and number only") {
  const RockShape a = procedural_shape(7, 3), b = procedural_shape(7, 3), c = procedural_shape(8, 3);
  REQUIRE(a.surface.vertices.size() == b.surface.vertices.size());
  CHECK(a.surface.vertices[5].x == b.surface.vertices[5].x);
  CHECK(a.inertia.x == b.inertia.x);
  CHECK(a.inertia.x != c.inertia.x);
}

TEST_CASE("A fine scan keeps its surface for filling and its hull for previews") {
  TriangleMesh scan = ellipsoid(1, 0.8, 0.6, 3000);
  for (std::size_t k = 0; k < scan.vertices.size(); k += 2) scan.vertices[k] = 0.98 * scan.vertices[k];
  const RockShape rock = make_shape(scan);
  CHECK(rock.surface.triangles.size() == scan.triangles.size());
  CHECK(rock.preview.triangles.size() < 0.7 * static_cast<double>(scan.triangles.size()));
  CHECK(mass_properties(rock.preview).volume > 1);
  CHECK(procedural_shape(1, 1).preview.triangles.size() == procedural_shape(1, 1).surface.triangles.size());
}

namespace {

/// Mean over 30 rocks.
template <class Measure>
double mean_of(const ShapeStyle& style, const Measure& measure) {
  double sum = 0;
  for (int k = 0; k < 30; ++k) sum += measure(procedural_shape(3, k, style));
  return sum / 30;
}

/// Axis ratios of the ellipsoid with the same moments of inertia.
double flatness_of(const RockShape& rock) {
  const Vec3d i = rock.inertia;
  return std::sqrt((i.x + i.y - i.z) / (i.x + i.z - i.y));
}
double elongation_of(const RockShape& rock) {
  const Vec3d i = rock.inertia;
  return std::sqrt((i.x + i.z - i.y) / (i.y + i.z - i.x));
}

/// Surface of the sphere of the same volume / surface: 1 for a sphere, 0.8 for a cube.
double sphericity_of(const RockShape& rock) {
  return std::cbrt(36 * 3.14159265358979) / surface_area(rock.surface);
}

}  // namespace

TEST_CASE("Shapes follow the axis ratios of the style") {
  const ShapeStyle flat{.flatness = {0.3, 0.4}}, rod{.elongation = {0.3, 0.4}};
  CHECK(mean_of(flat, flatness_of) == Approx(0.35).margin(0.04));
  CHECK(mean_of(flat, elongation_of) == Approx(0.8).margin(0.05));
  CHECK(mean_of(rod, elongation_of) == Approx(0.35).margin(0.04));
}

TEST_CASE("Angular rocks have fewer faces and are less like spheres") {
  const auto faces = [](const RockShape& rock) { return static_cast<double>(rock.surface.triangles.size()); };
  const ShapeStyle round{.angularity = 0}, middle{}, sharp{.angularity = 1};
  CHECK(mean_of(round, faces) > 2 * mean_of(middle, faces));
  CHECK(mean_of(middle, faces) > 2 * mean_of(sharp, faces));
  CHECK(mean_of(round, sphericity_of) > mean_of(middle, sphericity_of) + 0.02);
  CHECK(mean_of(middle, sphericity_of) > mean_of(sharp, sphericity_of) + 0.05);
}

TEST_CASE("Rough rocks are closed, deviate as specified and keep their proportions") {
  for (int k = 0; k < 8; ++k) {
    const RockShape rough = procedural_shape(3, k, {.roughness = 0.05}), smooth = procedural_shape(3, k);
    CHECK(check_edges(rough.surface).is_solid());
    CHECK(mass_properties(rough.surface).volume == Approx(1).epsilon(1e-12));
    CHECK(rough.surface.triangles.size() == 1280);
    CHECK(flatness_of(rough) == Approx(flatness_of(smooth)).epsilon(0.15));
    const double hull_volume = mass_properties(convex_hull(rough.surface.vertices)).volume;
    CHECK(hull_volume > 1.02);  // not convex any more
  }
  const auto roughness_seen = [](double roughness) { return mean_of({.roughness = roughness}, sphericity_of); };
  CHECK(roughness_seen(0.1) < roughness_seen(0.05) - 0.01);
  CHECK(procedural_shape(3, 1, {.roughness = 0.05}).surface.vertices[9].x ==
        procedural_shape(3, 1, {.roughness = 0.05}).surface.vertices[9].x);
}

TEST_CASE("The noise of rough rocks has the specified deviation") {
  const TriangleMesh sphere = roughened(ellipsoid(1, 1, 1, 3000), 0, 1, 1, 0);
  double sum = 0, squares = 0, count = 0;
  for (int k = 0; k < 200; ++k) {
    const TriangleMesh rough = roughened(block({2, 2, 2}, {-1, -1, -1}), 0.1, 5, k, 0);
    const TriangleMesh flat = roughened(block({2, 2, 2}, {-1, -1, -1}), 0, 5, k, 0);
    for (std::size_t v = 0; v < rough.vertices.size(); v += 40) {
      const double deviation = std::log(norm(rough.vertices[v]) / norm(flat.vertices[v]));
      sum += deviation, squares += deviation * deviation, ++count;
    }
  }
  CHECK(std::abs(sum / count) < 0.01);
  CHECK(std::sqrt(squares / count) == Approx(0.1).epsilon(0.05));
  for (const Vec3d& v : sphere.vertices) CHECK(norm(v) == Approx(1).epsilon(3e-3));
}

TEST_CASE("A cylinder has its proportions and lies along its principal axes") {
  const double slenderness = GENERATE(2.0, 0.5);
  const RockShape rock = cylinder_shape(slenderness);
  CHECK(check_edges(rock.surface).is_solid());
  CHECK(mass_properties(rock.surface).volume == Approx(1).epsilon(1e-12));
  const double diameter = std::cbrt(4 / 3.14159265358979 / slenderness), length = slenderness * diameter;
  const Box box = bounding_box(rock.surface);
  const Vec3d size = box.high - box.low;
  CHECK((slenderness > 1 ? size.x : size.z) == Approx(length));
  CHECK(size.y == Approx(diameter).epsilon(5e-3));
  const double across = (3 * diameter * diameter + 4 * length * length) / 48, about_axis = diameter * diameter / 8;
  CHECK(rock.inertia.z == Approx(slenderness > 1 ? across : about_axis).epsilon(2e-3));
}

TEST_CASE("A flattened disc has two flats that face y, with the width of the loading angle") {
  const double angle = 0.5, slenderness = 0.5;
  const RockShape rock = cylinder_shape(slenderness, angle);
  CHECK(check_edges(rock.surface).is_solid());
  CHECK(mass_properties(rock.surface).volume == Approx(1).epsilon(1e-12));
  const double kept = 1 - (angle - std::sin(angle)) / 3.14159265358979;  // of the circle's area
  const double diameter = std::cbrt(4 / (3.14159265358979 * slenderness * kept));
  const Box box = bounding_box(rock.surface);
  const Vec3d size = box.high - box.low;
  CHECK(size.x == Approx(diameter).epsilon(2e-3));  // 64 sides for a circle
  CHECK(size.y == Approx(diameter * std::cos(angle / 2)).epsilon(2e-3));
  CHECK(size.z == Approx(slenderness * diameter).epsilon(2e-3));
  double width = 0;
  for (const Vec3d& v : rock.surface.vertices)
    if (v.y > box.high.y - 1e-9) width = std::max(width, 2 * std::abs(v.x));
  CHECK(width == Approx(diameter * std::sin(angle / 2)).epsilon(0.03));  // the circle's sagitta, 1/800, over tan(a/2)
}

TEST_CASE("A coarse polyhedron approximates a scan") {
  TriangleMesh scan = ellipsoid(1, 0.8, 0.6, 3000);
  const TriangleMesh coarse = coarse_polyhedron(scan, 60), fine = coarse_polyhedron(scan, 5000);
  CHECK(coarse.vertices.size() <= 60);
  CHECK(coarse.vertices.size() > 40);
  CHECK(check_edges(coarse).is_solid());
  const double volume = mass_properties(scan).volume;
  CHECK(mass_properties(coarse).volume == Approx(volume).epsilon(0.12));
  CHECK(mass_properties(fine).volume == Approx(volume).epsilon(1e-12));
}

TEST_CASE("Styles out of range are refused") {
  CHECK_THROWS_AS(check_style({.elongation = {0.9, 0.5}}), BadInput);
  CHECK_THROWS_AS(check_style({.flatness = {0, 0.5}}), BadInput);
  CHECK_THROWS_AS(check_style({.flatness = {0.5, 1.1}}), BadInput);
  CHECK_THROWS_AS(check_style({.angularity = 1.1}), BadInput);
  CHECK_THROWS_AS(check_style({.roughness = -0.1}), BadInput);
  CHECK_THROWS_AS(check_style({.roughness = NAN}), BadInput);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/geometry/edges.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/solid.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"

#include <algorithm>
#include <cmath>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

/// A rock-like scan of 1996 triangles.
TriangleMesh scan() {
  return ellipsoid(1, 0.8, 0.6, 1000);
}

/// Every triangle with corners of its own, moved at random by up to the distance.
TriangleMesh soup(const TriangleMesh& mesh, double distance) {
  TriangleMesh out;
  std::uint32_t draw = 0;
  const auto jitter = [&] { return distance * (uniform(3, Stream::place, 0, draw++) - 0.5); };
  for (const auto& t : mesh.triangles) {
    const Index first = static_cast<Index>(out.vertices.size());
    for (const Index v : {t.x, t.y, t.z})
      out.vertices.push_back(mesh.vertices[v] + Vec3d{jitter(), jitter(), jitter()});
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

std::string all_notes(const RepairedMesh& mesh) {
  std::string text;
  for (const std::string& note : mesh.notes) text += note + "\n";
  return text;
}

/// Drops triangles whose centre is nearer to a point than the distance.
TriangleMesh with_hole(TriangleMesh mesh, const Vec3d& at, double distance) {
  std::erase_if(mesh.triangles, [&](const Vec3<Index>& t) {
    return norm((1.0 / 3) * (mesh.vertices[t.x] + mesh.vertices[t.y] + mesh.vertices[t.z]) - at) < distance;
  });
  return mesh;
}

void add(TriangleMesh& mesh, const TriangleMesh& other) {
  const Index first = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t.x + first, t.y + first, t.z + first});
}

const double volume = mass_properties(scan()).volume;

}  // namespace

TEST_CASE("A clean scan needs no note") {
  const RepairedMesh clean = repaired_solid(scan());
  CHECK(clean.notes.empty());
  CHECK(mass_properties(clean.mesh).volume == Approx(volume).epsilon(1e-9));
}

TEST_CASE("Corners that almost coincide are welded") {
  const double distance = GENERATE(0.0, 1e-6, 1e-5, 1e-4);
  const RepairedMesh welded = repaired_solid(soup(scan(), distance));
  CAPTURE(distance, all_notes(welded));
  CHECK(check_edges(welded.mesh).is_solid());
  CHECK(mass_properties(welded.mesh).volume == Approx(volume).epsilon(1e-4));
  CHECK(welded.notes.empty() == (distance == 0));
  if (distance > 0) CHECK_THAT(welded.notes[0], Contains("welded, which closes the surface"));
}

TEST_CASE("Triangles that face the wrong way are flipped") {
  TriangleMesh mixed = scan();
  for (std::size_t k = 0; k < mixed.triangles.size(); k += 3) std::swap(mixed.triangles[k].x, mixed.triangles[k].y);
  const RepairedMesh turned = repaired_solid(mixed);
  CHECK(mass_properties(turned.mesh).volume == Approx(volume).epsilon(1e-9));
  CHECK_THAT(all_notes(turned), Contains("666 triangles flipped"));
}

TEST_CASE("Repeated and empty triangles are dropped") {
  TriangleMesh mesh = scan();
  for (std::size_t k = 0; k < 50; ++k) {
    mesh.triangles.push_back(mesh.triangles[7 * k]);
    mesh.triangles.push_back({mesh.triangles[k].x, mesh.triangles[k].x, mesh.triangles[k].y});
  }
  const RepairedMesh cleaned = repaired_solid(mesh);
  CHECK(mass_properties(cleaned.mesh).volume == Approx(volume).epsilon(1e-9));
  CHECK_THAT(all_notes(cleaned), Contains("50 repeated triangles dropped") && Contains("50 triangles without area"));
}

TEST_CASE("Small holes are closed, inverted or not") {
  TriangleMesh holed = with_hole(with_hole(scan(), {1, 0, 0}, 0.15), {0, 0, 0.6}, 0.12);
  if (GENERATE(false, true)) {
    for (auto& t : holed.triangles) std::swap(t.x, t.y);
  }
  const RepairedMesh closed = repaired_solid(holed);
  CHECK(check_edges(closed.mesh).is_solid());
  CHECK(mass_properties(closed.mesh).volume == Approx(volume).epsilon(5e-3));
  CHECK_THAT(all_notes(closed), Contains("2 holes closed"));
}

TEST_CASE("A vertex on a neighbour's edge is a slit, which is closed") {
  TriangleMesh block_with_slit = block({1, 1, 1});
  const auto t = block_with_slit.triangles[0];
  block_with_slit.vertices.push_back(0.5 * (block_with_slit.vertices[t.x] + block_with_slit.vertices[t.y]));
  const Index m = static_cast<Index>(block_with_slit.vertices.size()) - 1;
  block_with_slit.triangles[0] = {t.x, m, t.z};
  block_with_slit.triangles.push_back({m, t.y, t.z});
  const RepairedMesh closed = repaired_solid(block_with_slit);
  CHECK(mass_properties(closed.mesh).volume == Approx(1));
  CHECK_THAT(all_notes(closed), Contains("1 hole closed"));
}

TEST_CASE("Specks beside a rock are dropped") {
  TriangleMesh mesh = scan();
  add(mesh, block({0.05, 0.05, 0.05}, {2, 0, 0}));
  add(mesh, {{{3, 0, 0}, {3, 1, 0}, {3, 0, 1}}, {{0, 1, 2}}});  // a single triangle
  const RepairedMesh cleaned = repaired_solid(mesh);
  CHECK(mass_properties(cleaned.mesh).volume == Approx(volume).epsilon(1e-9));
  CHECK_THAT(all_notes(cleaned), Contains("2 floating specks"));
}

TEST_CASE("All faults together are repaired") {
  TriangleMesh mesh = with_hole(scan(), {0, 0.8, 0}, 0.12);
  for (std::size_t k = 0; k < mesh.triangles.size(); k += 5) std::swap(mesh.triangles[k].x, mesh.triangles[k].y);
  mesh.triangles.push_back(mesh.triangles[11]);
  add(mesh, block({0.02, 0.02, 0.02}, {0, 0, 2}));
  const RepairedMesh repaired = repaired_solid(soup(mesh, 0));
  CHECK(check_edges(repaired.mesh).is_solid());
  CHECK(mass_properties(repaired.mesh).volume == Approx(volume).epsilon(5e-3));
  CHECK(repaired.notes.size() == 4);
}

TEST_CASE("Faults that cannot be repaired are refused with the reason") {
  const auto refused = [](const TriangleMesh& mesh, const std::string& reason) {
    CHECK_THROWS_AS(repaired_solid(mesh), BadInput);
    CHECK_THROWS_WITH(repaired_solid(mesh), Contains(reason));
  };
  refused(with_hole(scan(), {1, 0, 0}, 0.6), "around a hole of");
  TriangleMesh two = scan();
  add(two, block({0.5, 0.5, 0.5}, {2, 0, 0}));
  refused(two, "2 separate bodies");
  TriangleMesh finned = scan();
  finned.vertices.push_back({0, 0, 2});
  const auto t = finned.triangles[40];
  finned.triangles.push_back({t.x, t.y, static_cast<Index>(finned.vertices.size()) - 1});
  refused(finned, "1 edge with more than two triangles");
  // A closed band with half a twist has one side; so has every surface that contains it.
  TriangleMesh band;
  for (int k = 0; k < 12; ++k) {
    const double a = k * 3.14159265358979 / 6, half = a / 2;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1 + s * std::cos(half);
      band.vertices.push_back({r * std::cos(a), r * std::sin(a), s * std::sin(half)});
    }
  }
  for (Index k = 0; k < 12; ++k) {
    const Index a = 2 * k, b = a + 1;
    const Index c = k == 11 ? 1 : a + 2, d = k == 11 ? 0 : a + 3;
    band.triangles.push_back({a, b, c});
    band.triangles.push_back({b, d, c});
  }
  refused(band, "only one side");
  TriangleMesh flat = scan();
  for (Vec3d& v : flat.vertices) v.z = 0;
  refused(flat, "encloses no volume");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/walls/liners.hpp"
#include "scenes.hpp"
#include "tests/catch.hpp"

#include <chrono>
#include <iostream>

using namespace gyro;

namespace {

/// Sizes whose masses are the mass quantiles of a log-uniform distribution.
RockLibrary library_of(double smallest, double largest, int samples, double ratio) {
  RockLibrary library;
  for (int k = 0; k < samples; ++k) {
    library.rocks.push_back(ball_rock(smallest * std::pow(largest / smallest, (k + 0.5) / samples), ratio));
  }
  return library;
}

FeedPlan charge_plan(double mass, double high = 3.2) {
  FeedPlan plan;
  plan.initial = mass;
  plan.charge = ChamberRegion{0, 1, 0.0, high};
  plan.seed = 7;
  return plan;
}

const std::vector<WallPose> rest(2);

/// Smallest gap between spheres and the walls' profiles, unsigned, in the profiles' half-plane.
double smallest_wall_gap(const std::vector<NewRock>& rocks, const std::vector<Wall>& walls,
                         const std::vector<WallPose>& poses) {
  double smallest = 1e9;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto& points = std::get<ProfileShape>(walls[w].shape).points;
    for (const NewRock& rock : rocks) {
      for (const NewParticle& p : rock.particles) {
        const Vec3d b = to_body(poses[w], p.position);
        const Vec3d section{std::hypot(b.x, b.y), 0, b.z};
        for (std::size_t k = 1; k < points.size(); ++k) {
          const Vec3d from{points[k - 1].r, 0, points[k - 1].z}, to{points[k].r, 0, points[k].z};
          smallest = std::min(smallest, std::sqrt(distance2_to_segment(from, to, section)) - p.radius);
        }
      }
    }
  }
  return smallest;
}

/// Radius of a liner's profile at a height.
double radius_at(const Wall& wall, double z) {
  const auto& points = std::get<ProfileShape>(wall.shape).points;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto &a = points[k - 1], &b = points[k];
    if ((a.z - z) * (b.z - z) <= 0 && a.z != b.z) return a.r + (z - a.z) / (b.z - a.z) * (b.r - a.r);
  }
  return 0;
}

/// Share of solid rock in the chamber below a height, from slices: particles count by their
/// centres, each for its mass over the density of rock.
double solid_fraction(const std::vector<NewRock>& rocks, const std::vector<Wall>& walls, double low, double high) {
  double solid = 0, room = 0;
  for (const NewRock& rock : rocks) {
    for (const NewParticle& p : rock.particles) {
      const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(p.radius, 3);
      if (p.position.z >= low && p.position.z < high) solid += p.density * volume / solid_density;
    }
  }
  const int slices = 1000;
  for (int k = 0; k < slices; ++k) {
    const double z = low + (k + 0.5) * (high - low) / slices;
    room += std::numbers::pi * (std::pow(radius_at(walls[0], z), 2) - std::pow(radius_at(walls[1], z), 2));
  }
  return solid / (room * (high - low) / slices);
}

bool same(const std::vector<NewRock>& a, const std::vector<NewRock>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].particles.size() != b[k].particles.size() || a[k].id != b[k].id) return false;
    for (std::size_t i = 0; i < a[k].particles.size(); ++i) {
      const Vec3d p = a[k].particles[i].position, q = b[k].particles[i].position;
      if (p.x != q.x || p.y != q.y || p.z != q.z) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("Rocks are drawn so that every template has its share of the mass", "[feed]") {
  // Spheres of 50 ... 500 mm stand for 10 % of the mass each. With p ~ 1/m the expected mass of n
  // draws is the same for all; the largest of the deviations of the cumulative mass is compared
  // with its standard error, from the variance of the counts.
  RockLibrary library;
  const int kinds = 10;
  for (int k = 0; k < kinds; ++k) library.rocks.push_back(sphere_rock(0.025 + 0.025 * k));
  FeedPlan plan;
  plan.rate = 1e6;
  plan.positions = 1;
  plan.entry = BoxRegion{{-1, -1, 0}, {1, 1, 2}};
  plan.seed = 11;
  Feed feed(library, plan, {});
  // Each call fills an empty box, which is then emptied.
  double time = 0;
  while (feed.account().rocks < 40000) feed.due(time += 0.02, {}, {});

  double total_inverse = 0;
  for (Index k = 0; k < kinds; ++k) total_inverse += 1 / feed.template_mass(k);
  const double n = static_cast<double>(feed.account().rocks);
  double cumulative = 0, largest_se = 0;
  for (Index k = 0; k < kinds; ++k) {
    const double m = feed.template_mass(k), p = 1 / m / total_inverse;
    const double count = static_cast<double>(feed.state().of_template[static_cast<std::size_t>(k)]);
    CHECK(std::abs(count - n * p) < 4.5 * std::sqrt(n * p * (1 - p)));
    // Kolmogorov-Smirnov distance in mass: share of mass up to this template against (k + 1)/kinds.
    cumulative += count * m / (n * kinds / total_inverse);
    largest_se += 1 / (n * p) / (kinds * kinds);
    CHECK(std::abs(cumulative - (k + 1.0) / kinds) < 4.5 * std::sqrt(largest_se));
  }
}

TEST_CASE("An initial charge lies dense and free of overlap between the liners", "[feed]") {
  const RockLibrary library = library_of(0.10, 0.25, 6, 6);
  const std::vector<Wall> walls = chamber_walls();
  Feed feed(library, charge_plan(2500), walls);
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<NewRock> rocks = feed.initial(rest);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  CHECK(smallest_gap(rocks) >= 1e-4 * (1 - 1e-6));
  CHECK(smallest_wall_gap(rocks, walls, rest) >= 1e-4 * (1 - 1e-6));
  std::int64_t particles = 0;
  double mass = 0, top = 0;
  bool between = true;
  for (const NewRock& rock : rocks) {
    particles += static_cast<std::int64_t>(rock.particles.size());
    for (const NewParticle& p : rock.particles) {
      const double m = p.density * 4.0 / 3.0 * std::numbers::pi * std::pow(p.radius, 3);
      mass += m;
      top = std::max(top, p.position.z);
      const double r = std::hypot(p.position.x, p.position.y), z = p.position.z;
      between = between && r > radius_at(walls[1], z) && r < radius_at(walls[0], z) && z - p.radius >= -1e-12;
    }
  }
  CHECK(between);
  const FeedAccount account = feed.account();
  CHECK(account.rocks == static_cast<std::int64_t>(rocks.size()));
  CHECK(account.particles == particles);
  CHECK(account.mass == Approx(mass).epsilon(1e-12));
  CHECK(std::abs(mass - 2500) <= 0.5 * feed.template_mass(5));
  // Ids are consecutive, and each rock's bonds refer to its own particles.
  CHECK(rocks.back().particles.back().id + 1 == particles);
  CHECK(account.bonds > 0);

  const double dense = solid_fraction(rocks, walls, 0.1, 0.8 * top);
  std::cout << rocks.size() << " rocks, " << particles << " particles in " << seconds << " s; solid fraction " << dense
            << " below " << 0.8 * top << " m, top " << top << " m\n";
  CHECK(dense >= 0.35);
}

TEST_CASE("A charge of many layers lies dense and free of overlap", "[feed]") {
  const RockLibrary library = library_of(0.05, 0.06, 3, 3);
  const std::vector<Wall> walls = chamber_walls();
  const std::vector<NewRock> rocks = Feed(library, charge_plan(1000), walls).initial(rest);
  double top = 0;
  for (const NewRock& rock : rocks)
    for (const NewParticle& p : rock.particles) top = std::max(top, p.position.z);
  CHECK(top > 0.48);  // deep enough that rocks do not look for room from the foot on
  CHECK(smallest_gap(rocks) >= 1e-4 * (1 - 1e-6));
  CHECK(smallest_wall_gap(rocks, walls, rest) >= 1e-4 * (1 - 1e-6));
  CHECK(solid_fraction(rocks, walls, 0.1, 0.8 * top) >= 0.35);
}

TEST_CASE("Equal seeds give equal charges, and different seeds different ones", "[feed]") {
  const RockLibrary library = library_of(0.15, 0.3, 3, 4);
  const std::vector<Wall> walls = chamber_walls();
  FeedPlan plan = charge_plan(1000);
  Feed a(library, plan, walls), b(library, plan, walls);
  const std::vector<NewRock> first = a.initial(rest);
  CHECK(same(first, b.initial(rest)));
  plan.seed = 8;
  Feed c(library, plan, walls);
  CHECK(!same(first, c.initial(rest)));
}

TEST_CASE("A charge leaves room for a leaning mantle and existing particles", "[feed]") {
  const RockLibrary library = library_of(0.12, 0.25, 4, 4);
  std::vector<Wall> walls = chamber_walls();
  walls[1].motion = GyrationMotion{0.0217, 4.2, 0};
  const std::vector<WallPose> poses{WallPose{}, pose_of(walls[1], 0, {1.0, 0, 0, 0})};
  FeedPlan plan = charge_plan(800);
  Feed before(library, plan, walls);
  std::vector<NewRock> all = before.initial(poses);
  plan.first_rock = static_cast<RockId>(all.size());
  plan.first_particle = static_cast<ParticleId>(before.account().particles);
  Feed after(library, plan, walls);
  for (NewRock& rock : after.initial(poses, snapshot_of(all))) all.push_back(std::move(rock));
  CHECK(all.back().id == static_cast<RockId>(all.size()) - 1);
  CHECK(smallest_gap(all) >= 1e-4 * (1 - 1e-6));
  CHECK(smallest_wall_gap(all, walls, poses) >= 1e-4 * (1 - 1e-6));
}

TEST_CASE("A charge lies between liner meshes as between their profiles", "[feed]") {
  const RockLibrary library = library_of(0.15, 0.3, 4, 4);
  std::vector<Wall> walls = chamber_walls();
  for (Wall& wall : walls) wall.shape = revolve(std::get<ProfileShape>(wall.shape), 60);
  Feed feed(library, charge_plan(1500), walls);
  const std::vector<NewRock> rocks = feed.initial(rest);
  CHECK(smallest_gap(rocks) >= 1e-4 * (1 - 1e-6));
  double nearest = 1;
  for (const NewRock& rock : rocks) {
    for (const NewParticle& p : rock.particles) {
      const double r = std::hypot(p.position.x, p.position.y), z = p.position.z;
      CHECK((r > radius_at(chamber_walls()[1], z) - 2e-3 && r < radius_at(chamber_walls()[0], z)));
      for (const Wall& wall : walls) {
        const auto& mesh = std::get<TriangleMesh>(wall.shape);
        for (const auto& t : mesh.triangles) {
          const auto at = [&](Index v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
          const Vec3d n = cross(at(t.y) - at(t.x), at(t.z) - at(t.x));
          if (!(norm2(n) > 0)) continue;
          const FlatTriangle triangle{at(t.x), at(t.y), at(t.z), (1 / norm(n)) * n};
          nearest = std::min(nearest, std::sqrt(distance2_to_triangle(triangle, p.position)) - p.radius);
        }
      }
    }
  }
  CHECK(nearest >= 1e-4 * (1 - 1e-6));
}

TEST_CASE("A charge that does not fit is refused with the requested and the placed mass", "[feed]") {
  const RockLibrary library = library_of(0.2, 0.3, 2, 3);
  Feed feed(library, charge_plan(3000, 0.9), chamber_walls());
  CHECK_THROWS_WITH(feed.initial(rest), Catch::Matchers::Contains("does not fit below 0.9"));
}

TEST_CASE("Plans that cannot be carried out are refused", "[feed]") {
  const RockLibrary library = library_of(0.2, 0.3, 2, 3);
  const std::vector<Wall> walls = chamber_walls();
  const auto make = [&](const FeedPlan& plan) { Feed feed(library, plan, walls); };
  FeedPlan plan = charge_plan(1000);
  CHECK_NOTHROW(make(plan));
  plan.charge.reset();
  CHECK_THROWS_AS(make(plan), BadInput);  // the region is missing
  plan.charge = BoxRegion{{0, 0, 0}, {0.05, 1, 1}};
  CHECK_THROWS_WITH(make(plan), Catch::Matchers::Contains("larger than the region"));
  plan.charge = ChamberRegion{5, 1, 0, 1};
  CHECK_THROWS_AS(make(plan), BadInput);  // the wall does not exist
  plan.charge = ChamberRegion{0, 1, 1, 1};
  CHECK_THROWS_AS(make(plan), BadInput);  // empty
  plan = {};
  plan.rate = 10;
  plan.entry = CylinderRegion{{0, 0, 3.2}, 0.1, 1};
  CHECK_THROWS_WITH(make(plan), Catch::Matchers::Contains("a rock of"));
  plan.rate = -1;
  CHECK_THROWS_AS(make(plan), BadInput);
  CHECK_THROWS_AS(Feed(RockLibrary{}, FeedPlan{}, walls), BadInput);
}

TEST_CASE("A rock knows its template's frame and load table", "[feed]") {
  RockLibrary library = library_of(0.2, 0.3, 2, 4);
  library.rocks[1].load_table = 7;
  FeedPlan plan;
  const Quatd turned = rotation_about({0, 0.6, 0.8}, 1.3);
  plan.fixed = {{1, {0, 0, 2}, turned}};
  const std::vector<Wall> floor{{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 0}};
  const NewRock rock = Feed(library, plan, floor).initial(std::vector<WallPose>(1)).at(0);
  CHECK(rock.load_table == 7);
  for (std::size_t k = 0; k < rock.particles.size(); ++k)
    CHECK(norm(rock.particles[k].position - Vec3d{0, 0, 2} - rotate(rock.orientation, library.rocks[1].centres[k])) <
          1e-12);
}

TEST_CASE("A fixed rock has its given position, or is refused", "[feed]") {
  const RockLibrary library = library_of(0.2, 0.3, 2, 4);
  const std::vector<Wall> floor{{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 0}};
  const double reach = library.rocks[1].bounding_radius;
  FeedPlan plan;
  plan.fixed = {{1, {0.5, 0.2, reach}, {1, 0, 0, 0}}};
  Feed feed(library, plan, floor, [](RockId rock, ParticleId i, ParticleId j) { return rock + 1.0 + i * 1e-3 + j; });
  const std::vector<NewRock> rocks = feed.initial(std::vector<WallPose>(1));
  REQUIRE(rocks.size() == 1);
  const Vec3d c = rocks[0].particles[3].position - library.rocks[1].centres[3];
  CHECK((c.x == Approx(0.5) && c.y == Approx(0.2) && c.z == Approx(reach)));
  CHECK(rocks[0].bonds[4].strength == 1.0 + 4e-3 + 5);
  CHECK(feed.account().mass == Approx(feed.template_mass(1)));
  CHECK(!feed.wants(100));

  const auto refused = [&](const std::vector<FixedRock>& fixed, const std::string& why) {
    plan.fixed = fixed;
    Feed other(library, plan, floor);
    CHECK_THROWS_WITH(other.initial(std::vector<WallPose>(1)), Catch::Matchers::Contains(why));
  };
  refused({{1, {0, 0, 0.05}}}, "wall");
  refused({{1, {0, 0, -0.5}}}, "wall");  // behind it: every sphere is far from the plane but on the wrong side
  refused({{1, {0, 0, 0.3}}, {0, {0.1, 0, 0.3}}}, "overlaps");
  refused({{2, {0, 0, 0.3}}}, "library");
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Charges that are so high that rocks look for room from below their surface on.
#include "scenes.hpp"
#include "tests/catch.hpp"

#include <iostream>

using namespace gyro;

namespace {

FeedPlan plan_of(double mass) {
  FeedPlan plan;
  plan.initial = mass;
  plan.charge = CylinderRegion{{0, 0, 0}, 0.2, 2};
  plan.seed = 7;
  return plan;
}

/// Number of the template with particles of this radius.
std::size_t kind_of(const RockLibrary& library, double radius) {
  std::size_t kind = 0;
  while (library.rocks.at(kind).radii[0] != radius) ++kind;
  return kind;
}

/// Heights of the centres of mass of rocks of equal spheres [m].
std::vector<double> heights_of(const std::vector<NewRock>& rocks) {
  std::vector<double> heights;
  for (const NewRock& rock : rocks) {
    double sum = 0;
    for (const NewParticle& p : rock.particles) sum += p.position.z;
    heights.push_back(sum / static_cast<double>(rock.particles.size()));
  }
  return heights;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double top_of(const std::vector<NewRock>& rocks) {
  double top = 0;
  for (const NewRock& rock : rocks)
    for (const NewParticle& p : rock.particles) top = std::max(top, p.position.z);
  return top;
}

/// The same rocks, in the same order, each of which looks for room from the foot of the charge on.
std::vector<NewRock> placed_from_the_foot(const std::vector<NewRock>& rocks, const RockLibrary& library,
                                          const FeedPlan& plan) {
  const WallSet walls({}, library.rocks.back().radii[0], plan.clearance);
  const FeedRegion region(*plan.charge, {});
  Bed bed;
  const Placement placement(region, walls, bed, plan.clearance);
  double top = region.low();
  std::vector<NewRock> placed;
  for (const NewRock& rock : rocks) {
    const RockTemplate& shape = library.rocks[kind_of(library, rock.particles[0].radius)];
    const double expected = std::min(top + 2 * shape.bounding_radius, region.high());
    const auto pose = placement.lowest(
        shape, {plan.seed, static_cast<std::uint64_t>(rock.id), plan.positions, plan.improvements, 0, expected});
    if (!pose) return {};
    placed.push_back(rock);
    for (std::size_t k = 0; k < shape.centres.size(); ++k) {
      const Vec3d centre = pose->position + rotate(pose->orientation, shape.centres[k]);
      placed.back().particles[k].position = centre;
      bed.add(centre, shape.radii[k]);
      top = std::max(top, centre.z);
    }
  }
  return placed;
}

}  // namespace

TEST_CASE("A charge of many layers lies as one whose rocks look for room from the foot on", "[feed]") {
  RockLibrary library;
  for (const double diameter : {0.0515, 0.0548, 0.0583}) library.rocks.push_back(ball_rock(diameter, 3));
  const FeedPlan plan = plan_of(80);
  const std::vector<NewRock> rocks = Feed(library, plan, {}).initial({});
  const std::vector<NewRock> others = placed_from_the_foot(rocks, library, plan);
  REQUIRE(others.size() == rocks.size());
  CHECK(top_of(rocks) > 0.35);  // deep enough: 4 diameters are 0.23 m
  const std::vector<double> here = heights_of(rocks), there = heights_of(others);
  std::size_t same = 0;
  while (same < here.size() && here[same] == Approx(there[same]).margin(1e-12)) ++same;
  std::cout << rocks.size() << " rocks, the first " << same << " in the same places; mean heights " << mean(here)
            << " and " << mean(there) << " m\n";
  CHECK(same > 100);          // while the charge is low
  CHECK(same < here.size());  // else nothing is compared
  CHECK(mean(here) == Approx(mean(there)).epsilon(0.02));
}

TEST_CASE("A deep charge that fits only with room deep below its surface is placed", "[feed]") {
  // One position a rock leaves holes everywhere. Those within two diameters of the surface hold 55 spheres, all 63.
  RockLibrary library;
  library.rocks.push_back(sphere_rock(0.1));
  FeedPlan plan;
  plan.charge = BoxRegion{{0, 0, 0}, {0.5, 0.5, 4}};
  plan.positions = 1;
  plan.improvements = 0;
  plan.seed = 2;
  plan.initial = 60 * Feed(library, plan, {}).template_mass(0);
  const std::vector<NewRock> rocks = Feed(library, plan, {}).initial({});
  CHECK(rocks.size() == 60);
  CHECK(top_of(rocks) > 3);
  CHECK(smallest_gap(rocks) >= 1e-4 * (1 - 1e-6));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/lid.hpp"

#include "app/assembly/bad_key.hpp"
#include "app/assembly/in_mm.hpp"
#include "app/assembly/walls.hpp"
#include "app/simulation/time_step.hpp"
#include "core/feed/region.hpp"

#include <algorithm>

namespace gyro {
namespace {

/// @throws BadKey if rock reaches above the lid
void require_below(double lid, double top, const std::string& key, const std::string& what) {
  if (top > lid)
    throw BadKey(key, what + " reaches to z = " + in_mm(top) + ", above the lid at " + in_mm(lid) +
                          ", which nothing passes; give crusher.lid at least this height, or lower the rock");
}

double top_of(const Region& region) {
  if (const auto* box = std::get_if<BoxRegion>(&region)) return box->high.z;
  if (const auto* cylinder = std::get_if<CylinderRegion>(&region)) return cylinder->base.z + cylinder->height;
  return std::get<ChamberRegion>(region).high;
}

void check_feed(double lid, const FeedPlan& plan, const RockLibrary& library) {
  if (plan.charge) require_below(lid, top_of(*plan.charge), "feed", "the initial charge");
  if (plan.entry) require_below(lid, top_of(*plan.entry), "feed", "the feed (twice the largest rock above the wall)");
  for (const FixedRock& fixed : plan.fixed) {
    const RockTemplate& rock = library.rocks[static_cast<std::size_t>(fixed.rock)];
    require_below(lid, fixed.position.z + rock.bounding_radius, "feed.at", "a rock");
  }
}

const Wall& concave_of(std::span<const Wall> walls) {
  return *std::ranges::find(walls, "concave", &Wall::name);
}

/// By how much the rim of the concave is out of round [m]: its largest radius, which the lid has, less its smallest.
double rim_gap(std::span<const Wall> walls) {
  const Wall& concave = concave_of(walls);
  if (std::holds_alternative<ProfileShape>(concave.shape)) return 0;
  const ConcaveOutline outline = concave_outline(walls).value();
  const double height_of_slice = (outline.rim() - outline.edge()) / 512;  // of RadiusByHeight, which takes the smallest
  return outline.radius(outline.rim() - height_of_slice) - opening_above(concave, 0).radius;
}

}  // namespace

Wall make_lid(double height, std::span<const Wall> walls) {
  const std::optional<ConcaveOutline> outline = concave_outline(walls);
  if (!outline) throw BadInput("the lid needs a rim to stand on; give a fixed concave, by crusher.profile or stl");
  const double rim = outline->rim();
  if (!(height > rim))
    throw BadInput("the lid at z = " + in_mm(height) + " is not above the rim of the concave at " + in_mm(rim) +
                   "; raise it, so that there is room for the rock that is fed");
  // Upwards, then inwards: rock is on the left of the direction of travel.
  const double radius = outline->radius(rim);
  Wall lid;
  lid.name = "lid";
  lid.shape = ProfileShape{{{radius, rim}, {radius, height}, {0, height}}};
  lid.material = concave_of(walls).material;
  return lid;
}

void check_lid(double height, const Setup& setup) {
  const std::vector<Wall>& walls = setup.scene.walls;
  if (setup.feed) check_feed(height, *setup.feed, setup.library);
  for (const NewRock& rock : setup.start)
    for (const NewParticle& p : rock.particles)
      require_below(height, p.position.z + p.radius, "particles", "a particle");
  const double gap = rim_gap(walls);
  if (gap > 2 * smallest_radius(setup.library, setup.start))
    throw BadKey("crusher.lid", "the rim of the concave is not round: between it and the lid are up to " + in_mm(gap) +
                                    ", more than the smallest particle; close the mesh at its top");
}

}  // namespace gyro

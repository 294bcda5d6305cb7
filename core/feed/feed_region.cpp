// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/feed/placement.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyro {
namespace {

/// Faster than std::hypot, which guards against overflow.
double radius_of(double x, double y) {
  return std::sqrt(x * x + y * y);
}

Vec3d on_ring(double inner, double outer, double u, double v) {
  const double r = std::sqrt(inner * inner + u * (outer * outer - inner * inner)), t = 2 * std::numbers::pi * v;
  return {r * std::cos(t), r * std::sin(t), 0};
}

const Wall& wall_of(std::span<const Wall> walls, Index k) {
  if (k < 0 || static_cast<std::size_t>(k) >= walls.size()) {
    throw BadInput("the feed's chamber refers to a wall that does not exist; name walls of the scene");
  }
  return walls[static_cast<std::size_t>(k)];
}

}  // namespace

FeedRegion::FeedRegion(const Region& region, std::span<const Wall> walls) : region_(region) {
  if (const auto* box = std::get_if<BoxRegion>(&region)) {
    low_ = box->low.z;
    high_ = box->high.z;
    if (!(box->low.x < box->high.x && box->low.y < box->high.y)) {
      throw BadInput("the feed's box is empty; its low corner must lie below the high one in x, y and z");
    }
  } else if (const auto* cylinder = std::get_if<CylinderRegion>(&region)) {
    low_ = cylinder->base.z;
    high_ = low_ + cylinder->height;
    if (!(cylinder->radius > 0)) throw BadInput("the feed's cylinder is empty; its radius must be above 0 m");
  } else {
    const auto& chamber = std::get<ChamberRegion>(region);
    low_ = chamber.low;
    high_ = chamber.high;
    outer_.emplace(wall_of(walls, chamber.outer), RadiusByHeight::Side::outer);
    if (chamber.inner != none) inner_.emplace(wall_of(walls, chamber.inner), RadiusByHeight::Side::inner);
  }
  if (!(low_ < high_)) {
    throw BadInput("the feed's region is empty; its top (" + std::to_string(high_) + " m) must lie above its foot (" +
                   std::to_string(low_) + " m)");
  }
}

double FeedRegion::largest_radius() const {
  return narrowest() / 2;
}

double FeedRegion::narrowest() const {
  const double height = high_ - low_;
  if (const auto* box = std::get_if<BoxRegion>(&region_)) {
    return std::min(height, std::min(box->high.x - box->low.x, box->high.y - box->low.y));
  }
  if (const auto* cylinder = std::get_if<CylinderRegion>(&region_)) return std::min(height, 2 * cylinder->radius);
  // The gap of a chamber changes with height; its widest gap counts.
  double widest = 0;
  for (int k = 0; k <= 64; ++k) {
    const double z = low_ + k * height / 64;
    widest = std::max(widest, inner_ && inner_->at(z) > 0 ? outer_->at(z) - inner_->at(z) : 2 * outer_->at(z));
  }
  return std::min(height, widest);
}

Vec3d FeedRegion::draw(double height, double u, double v) const {
  if (const auto* box = std::get_if<BoxRegion>(&region_)) {
    return {box->low.x + u * (box->high.x - box->low.x), box->low.y + v * (box->high.y - box->low.y), 0};
  }
  if (const auto* cylinder = std::get_if<CylinderRegion>(&region_)) {
    return cylinder->base + on_ring(0, cylinder->radius, u, v);
  }
  return on_ring(inner_ ? std::min(inner_->at(height), outer_->at(height)) : 0, outer_->at(height), u, v);
}

double FeedRegion::raised(const WallSet& walls, const Vec3d& c, double radius) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (const auto* box = std::get_if<BoxRegion>(&region_)) {
    const bool inside = c.x - radius >= box->low.x && c.x + radius <= box->high.x && c.y - radius >= box->low.y &&
                        c.y + radius <= box->high.y;
    return inside ? c.z : never;
  }
  if (const auto* cylinder = std::get_if<CylinderRegion>(&region_)) {
    const double r = radius_of(c.x - cylinder->base.x, c.y - cylinder->base.y);
    return r + radius <= cylinder->radius ? c.z : never;
  }
  return chamber_holds(std::get<ChamberRegion>(region_), walls, c, radius) ? c.z : c.z + radius / 4;
}

/// Distances to the walls are checked elsewhere. A mesh has no sides, so the side is checked here.
bool FeedRegion::chamber_holds(const ChamberRegion& chamber, const WallSet& walls, const Vec3d& c,
                               double radius) const {
  const Vec3d at_outer = to_body(walls.pose(chamber.outer), c);
  const double outer_radius = radius_of(at_outer.x, at_outer.y);
  if (outer_radius > outer_->at(at_outer.z)) return false;
  if (at_outer.z > outer_->high() && outer_radius + radius > outer_->at(at_outer.z)) return false;
  if (!inner_) return true;
  const Vec3d at_inner = to_body(walls.pose(chamber.inner), c);
  return radius_of(at_inner.x, at_inner.y) >= inner_->at(at_inner.z);
}

BoxRegion FeedRegion::bounds() const {
  if (const auto* box = std::get_if<BoxRegion>(&region_)) return *box;
  Vec3d base{0, 0, low_};
  double radius = 0;
  if (const auto* cylinder = std::get_if<CylinderRegion>(&region_)) {
    base = cylinder->base;
    radius = cylinder->radius;
  } else {
    for (int k = 0; k <= 512; ++k) radius = std::max(radius, outer_->at(low_ + k * (high_ - low_) / 512));
  }
  return {{base.x - radius, base.y - radius, low_}, {base.x + radius, base.y + radius, high_}};
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/mesh_setting.hpp"

#include "core/base/errors.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

namespace gyro {
namespace {

constexpr int strip_count = 24;
constexpr double strip_half = 0.02;  // [rad]; at the concave of a 62-75 that is 22 mm, about a facet of 240 sectors
constexpr int angles = 24;           // of the eccentric over a gyration, starting at the azimuth of the strip
constexpr double spacing = 0.004;    // of points, relative to the concave's height

double azimuth_of(const Vec3d& v) {
  return std::atan2(v.y, v.x);
}

/// Difference of two angles, in [-pi, pi].
double apart(double a, double b) {
  return std::remainder(a - b, 2 * std::numbers::pi);
}

/// Calls visit(point) for points of a triangle on a raster, corners included.
template <class Visit>
void raster(const Vec3d& a, const Vec3d& b, const Vec3d& c, double step, const Visit& visit) {
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  const int cuts = std::clamp(static_cast<int>(std::ceil(longest / step)), 1, 400);
  for (int i = 0; i <= cuts; ++i)
    for (int j = 0; i + j <= cuts; ++j) visit(a + double(i) / cuts * (b - a) + double(j) / cuts * (c - a));
}

/// Removes points that neighbouring triangles give twice on their common edge, up to rounding.
void drop_repeated(std::vector<Vec3d>& points) {
  std::ranges::sort(points,
                    [](const Vec3d& a, const Vec3d& b) { return std::tie(a.z, a.x, a.y) < std::tie(b.z, b.x, b.y); });
  const auto same = [](const Vec3d& a, const Vec3d& b) { return norm(a - b) < 1e-9; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
}

/// Drops points that are more than 0.08 of the zone's height behind the surface that is nearest to the other liner at
/// the same height. They lie on the shell or the rings of a liner drawn as a thick body.
/// @param sign  -1 to keep the innermost surface, 1 to keep the outermost
void drop_behind(std::vector<Vec3d>& points, double low, double height, double sign) {
  constexpr int levels = 20;
  const double behind = 0.08 * height;
  std::vector<double> surface(levels, -1e300);  // largest sign x radius
  const auto level = [&](const Vec3d& p) -> double& {
    return surface[static_cast<std::size_t>(
        std::clamp(static_cast<int>((p.z - low) / height * levels), 0, levels - 1))];
  };
  const auto depth = [&](const Vec3d& p) { return sign * std::hypot(p.x, p.y); };
  for (const Vec3d& p : points) level(p) = std::max(level(p), depth(p));
  std::erase_if(points, [&](const Vec3d& p) { return depth(p) < level(p) - behind; });
}

}  // namespace

MeshGap::MeshGap(const TriangleMesh& mantle, const TriangleMesh& concave, const GyrationMotion& motion)
    : mantle_(mantle), concave_(concave), motion_(motion) {
  for (const Vec3d& v : concave.vertices) height_ = std::max(height_, v.z);
  if (!(height_ > 0)) throw BadInput("no part of the concave is above the discharge plane z = 0; shift the mesh");
  for (int k = 0; k < strip_count; ++k) strips_.push_back({2 * std::numbers::pi * k / strip_count, {}, {}});
  add_points(concave, 0, 0.1 * height_, &Strip::concave, Side::inner);
  double lowest = 1e300;
  for (const Vec3d& v : mantle.vertices) lowest = std::min(lowest, v.z);
  add_points(mantle, lowest, lowest + 0.1 * height_, &Strip::mantle, Side::outer);
  std::erase_if(strips_, [](const Strip& strip) { return strip.concave.empty(); });
  if (strips_.empty())
    throw BadInput("the concave is open where the setting is measured; it must be a closed ring there");
  reach_ = widest_gap() + 0.1 * height_;
}

/// Upper bound of all gaps: the distance of one point of each strip, plus the change in a gyration, which is less than
/// twice the eccentricity at the discharge.
double MeshGap::widest_gap() const {
  double widest = 0;
  for (const Strip& strip : strips_) {
    const Nearest nearest = nearest_triangle(mantle_, strip.concave.front(), 0.1 * height_);
    if (nearest.triangle == none) throw BadInput("the mantle is far from the concave; it must be inside");
    widest = std::max(widest, nearest.point.height + 2 * motion_.eccentricity);
  }
  return widest;
}

void MeshGap::add_points(const TriangleMesh& mesh, double low, double high, std::vector<Vec3d> Strip::*points,
                         Side side) {
  const auto add = [&](const Vec3d& p) {
    if (p.z < low || p.z > high) return;
    const double strips = azimuth_of(p) / (2 * std::numbers::pi) * strip_count;
    Strip& strip =
        strips_[static_cast<std::size_t>((static_cast<int>(std::lround(strips)) + strip_count) % strip_count)];
    if (std::abs(apart(azimuth_of(p), strip.azimuth)) <= strip_half) (strip.*points).push_back(p);
  };
  const auto at = [&](Index i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
  for (const Vec3<Index>& t : mesh.triangles) {
    const Vec3d a = at(t.x), b = at(t.y), c = at(t.z);
    if (std::max({a.z, b.z, c.z}) < low || std::min({a.z, b.z, c.z}) > high) continue;
    raster(a, b, c, spacing * height_, add);
  }
  for (Strip& strip : strips_) {
    drop_behind(strip.*points, low, high - low, side == Side::inner ? -1 : 1);
    drop_repeated(strip.*points);
  }
}

/// Negative where the mantle's points lie outside the concave: farther from the machine's axis than its surface.
double MeshGap::gap_of_mantle(const Strip& strip, const WallPose& pose, double minimum) const {
  for (const Vec3d& point : strip.mantle) {
    const Vec3d p = to_world(pose, point);
    const Nearest nearest = nearest_within(concave_, p, std::min(std::abs(minimum), reach_));
    if (nearest.triangle == none) continue;
    const Vec3d q = p - nearest.point.height * nearest.point.normal;
    if (q.z < 0 || q.z > 0.1 * height_) continue;
    const double side = std::hypot(p.x, p.y) <= std::hypot(q.x, q.y) ? 1 : -1;
    minimum = std::min(minimum, side * nearest.point.height);
  }
  return minimum;
}

/// Negative where the surfaces overlap: the concave's points are nearer to the mantle's axis than its surface.
double MeshGap::gap(const Strip& strip, double angle, double lift) const {
  GyrationMotion motion = motion_;
  motion.lift = lift;
  const WallPose pose = gyration_pose(motion, {.angle = angle});
  double minimum = reach_;
  for (const Vec3d& point : strip.concave) {
    const Vec3d p = to_body(pose, point);
    const Nearest nearest = nearest_within(mantle_, p, std::min(std::abs(minimum), reach_));
    if (nearest.triangle == none) continue;
    const Vec3d q = p - nearest.point.height * nearest.point.normal;
    const double side = std::hypot(p.x, p.y) >= std::hypot(q.x, q.y) ? 1 : -1;
    minimum = std::min(minimum, side * nearest.point.height);
  }
  return gap_of_mantle(strip, pose, minimum);
}

double MeshGap::closed(double lift) const {
  double minimum = 1e300;
  for (const Strip& strip : strips_) minimum = std::min(minimum, gap(strip, strip.azimuth, lift));
  return minimum;
}

SideOfMeshes MeshGap::side(const Strip& strip, double lift) const {
  SideOfMeshes side{strip.azimuth, 1e300, -1e300};
  for (int k = 0; k < angles; ++k) {
    const double now = gap(strip, strip.azimuth + 2 * std::numbers::pi * k / angles, lift);
    side = {side.azimuth, std::min(side.closed, now), std::max(side.open, now)};
  }
  return side;
}

MeshSetting MeshGap::measure(double lift) const {
  MeshSetting setting{1e300, -1e300};
  for (std::size_t s = 0; s < strips_.size(); s += 4) {
    const SideOfMeshes now = side(strips_[s], lift);
    setting = {std::min(setting.closed, now.closed), std::max(setting.open, now.open)};
  }
  return setting;
}

std::vector<SideOfMeshes> MeshGap::sides(double lift) const {
  std::vector<SideOfMeshes> sides;
  for (const Strip& strip : strips_) sides.push_back(side(strip, lift));
  return sides;
}

double MeshGap::solve_lift(double wanted) const {
  // A lift by s changes a distance by at most s. So a step as long as the missing gap cannot skip a narrow place, for
  // example where the mantle's rim passes the concave's rim; the gap widens again beyond it.
  const double maximum = height_ / 2, minimum = maximum / 256;
  double low = 0, high = 0;  // the gap is too wide at low, too narrow at high
  double at_low = closed(0) - wanted, at_high = at_low, narrowest = at_low;
  while (at_low < 0 && low > -maximum) {
    low -= std::max(-at_low, minimum);
    at_low = closed(low) - wanted;
  }
  while (at_high > 0 && high < maximum) {
    high += std::max(at_high, minimum);
    at_high = closed(high) - wanted;
    narrowest = std::min(narrowest, at_high);
  }
  if (at_low + wanted <= std::max(narrowest + wanted, 0.0) && (at_low < 0 || at_high > 0))
    throw BadInput(
        "the mantle touches the concave at every height; it must fit inside the concave, and both meshes must be in "
        "metres");
  if (at_low < 0 || at_high > 0)
    throw BadInput("lifting the mantle gives no closed_side_setting of " + std::to_string(wanted) +
                   " m; it must be between " + std::to_string(std::max(narrowest + wanted, 0.0)) + " and " +
                   std::to_string(at_low + wanted) + " m");
  while (high - low > 1e-6) {  // regula falsi, kept away from the ends
    const double share = at_low == at_high ? 0.5 : std::clamp(at_low / (at_low - at_high), 0.05, 0.95);
    const double middle = low + share * (high - low), value = closed(middle) - wanted;
    if (std::abs(value) < 1e-6) return middle;
    (value >= 0 ? low : high) = middle;
    (value >= 0 ? at_low : at_high) = value;
  }
  return (low + high) / 2;
}

}  // namespace gyro

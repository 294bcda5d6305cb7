// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/placement.hpp"

#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyro {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The random numbers of one rock, in the order of use.
struct Draws {
  std::uint64_t seed, rock;
  std::uint32_t position, orientation;
  double next_position() { return uniform(seed, Stream::place, rock, position++); }
  double next_orientation() { return uniform(seed, Stream::turn, rock, orientation++); }
  Quatd random_orientation() {
    const double u = next_orientation(), v = next_orientation(), w = next_orientation();
    return uniform_orientation(u, v, w);
  }
  /// A rotation about a random axis by up to this angle [rad].
  Quatd small_rotation(double angle) {
    const double z = 2 * next_orientation() - 1, t = 2 * std::numbers::pi * next_orientation(),
                 s = std::sqrt(1 - z * z);
    return rotation_about({s * std::cos(t), s * std::sin(t), z}, angle * next_orientation());
  }
};

}  // namespace

Quatd uniform_orientation(double u, double v, double w) {
  const double a = std::sqrt(1 - u), b = std::sqrt(u), s = 2 * std::numbers::pi * v, t = 2 * std::numbers::pi * w;
  return {b * std::cos(t), a * std::sin(s), a * std::cos(s), b * std::sin(t)};
}

WallSet::WallSet(std::span<const Wall> walls, double largest_radius, double gap) : poses_(walls.size()) {
  for (const Wall& wall : walls) walls_.emplace_back(wall, 2 * (largest_radius + gap));
}

void WallSet::move(std::span<const WallPose> poses) {
  poses_.assign(poses.begin(), poses.end());
}

double WallSet::distance(const Vec3d& point) const {
  double nearest = never;
  for (std::size_t k = 0; k < walls_.size(); ++k) nearest = std::min(nearest, walls_[k].at(poses_[k], point));
  return nearest;
}

BedSurface::BedSurface(const BoxRegion& bounds, double foot, double largest)
    : low_(bounds.low),
      foot_(foot),
      cell_(largest),
      along_x_(static_cast<int>((bounds.high.x - bounds.low.x) / largest) + 1),
      along_y_(static_cast<int>((bounds.high.y - bounds.low.y) / largest) + 1),
      top_(static_cast<std::size_t>(along_x_) * static_cast<std::size_t>(along_y_), foot) {}

double BedSurface::floor(double x, double y) const {
  const double top = top_[cell_of(x, y)];
  return top - deep * cell_ > foot_ ? top - depth * cell_ : foot_;
}

void BedSurface::add(const Vec3d& centre, double radius) {
  double& top = top_[cell_of(centre.x, centre.y)];
  top = std::max(top, centre.z + radius);
}

std::size_t BedSurface::cell_of(double x, double y) const {
  const int i = static_cast<int>(std::clamp((x - low_.x) / cell_, 0.0, along_x_ - 1.0)),
            j = static_cast<int>(std::clamp((y - low_.y) / cell_, 0.0, along_y_ - 1.0));
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(along_x_) + static_cast<std::size_t>(i);
}

double Placement::raised(const Vec3d& centre, double radius) const {
  Vec3d p = centre;
  while (p.z < region_.high()) {
    const double here = p.z;
    p.z = region_.raised(walls_, p, radius);
    if (p.z > here) continue;
    p.z = bed_.raised(p, radius, gap_);
    if (p.z > here) continue;
    // Raising a sphere by s changes its distance to a wall by at most s.
    const double missing = radius + gap_ - walls_.distance(p);
    if (missing <= 0) return here;
    p.z += std::max(missing, gap_);
  }
  return never;
}

double Placement::lowest_height(const RockTemplate& rock, double x, double y, const Quatd& orientation, double limit,
                                double floor) const {
  const std::size_t n = rock.centres.size();
  std::vector<Vec3d> arm(n);
  double foot = 0, top = 0;
  for (std::size_t k = 0; k < n; ++k) {
    arm[k] = rotate(orientation, rock.centres[k]);
    foot = std::min(foot, arm[k].z - rock.radii[k]);
    top = std::max(top, arm[k].z + rock.radii[k]);
  }
  double z = std::max(region_.low(), floor) - foot;
  const double highest = std::min(limit, region_.high() - top);
  // Cycle through the spheres until all are free at one height.
  for (std::size_t k = 0, free = 0; free < n; k = k + 1 < n ? k + 1 : 0) {
    if (!(z <= highest)) return never;
    const double height = z + arm[k].z;
    const double up = raised({x + arm[k].x, y + arm[k].y, height}, rock.radii[k]) - height;
    free = up > 0 ? 1 : free + 1;
    z += up;
  }
  return z <= highest ? z : never;
}

std::optional<RockPose> Placement::lowest(const RockTemplate& rock, const Search& search) const {
  const auto first = search.attempt * static_cast<std::uint32_t>(3 * search.positions + 4 * search.improvements);
  Draws draws{search.seed, search.rock, first, first};
  RockPose best{{0, 0, never}, {1, 0, 0, 0}};
  const auto offer = [&](double x, double y, const Quatd& orientation) {
    const double floor = search.surface ? search.surface->floor(x, y) : -never;
    const double z = lowest_height(rock, x, y, orientation, best.position.z, floor);
    const bool lower = z < best.position.z;
    if (lower) best = {{x, y, z}, orientation};
    return lower;
  };
  for (int k = 0; k < search.positions; ++k) {
    const double share = draws.next_position(), u = draws.next_position(), v = draws.next_position();
    const Vec3d p = region_.draw(region_.low() + share * (search.expected_top - region_.low()), u, v);
    offer(p.x, p.y, draws.random_orientation());
  }
  if (best.position.z == never) return std::nullopt;
  // Moves shrink while they fail, as a rock settles.
  double step = 0.5 * rock.bounding_radius, angle = 1;
  for (int k = 0; k < search.improvements; ++k) {
    const double t = 2 * std::numbers::pi * draws.next_position(), r = step * draws.next_position();
    const Quatd orientation = normalised(draws.small_rotation(angle) * best.orientation);
    if (!offer(best.position.x + r * std::cos(t), best.position.y + r * std::sin(t), orientation)) {
      step *= 0.93;
      angle *= 0.93;
    }
  }
  return best;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/filling.hpp"

#include "core/feed/bed.hpp"
#include "core/feed/placement.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace gyro {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Random numbers of one piece, in the order of use.
struct Draws {
  std::uint64_t seed, piece;
  std::uint32_t position = 0, orientation = 0;
  double next() { return uniform(seed, Stream::place, piece, position++); }
  Quatd turn() {
    const double u = next_turn(), v = next_turn(), w = next_turn();
    return uniform_orientation(u, v, w);
  }

 private:
  double next_turn() { return uniform(seed, Stream::turn, piece, orientation++); }
};

double largest_radius(const RockLibrary& library) {
  double largest = 0;
  for (const RockTemplate& rock : library.rocks)
    for (const double r : rock.radii) largest = std::max(largest, r);
  return largest;
}

/// Distance from the centre of a rock down to its lowest point [m].
double depth_of(const RockTemplate& rock, const Quatd& orientation) {
  double depth = 0;
  for (std::size_t k = 0; k < rock.centres.size(); ++k)
    depth = std::max(depth, rock.radii[k] - rotate(orientation, rock.centres[k]).z);
  return depth;
}

/// The search for the place of one piece.
class PieceSearch {
 public:
  PieceSearch(const Placement& placement, const RockTemplate& piece, const Vec3d& target, Draws draws)
      : placement_(placement), piece_(piece), target_(target), draws_(draws) {}

  /// Tries positions in a circle about the target. @param reach  its radius [m]
  /// @param within  distance from the target that is near enough [m]
  std::optional<RockPose> around(double reach, double within, int positions) {
    nearest_ = within;
    for (int k = 0; k < positions; ++k) {
      const double r = reach * k / positions * std::sqrt(draws_.next()), t = 2 * std::numbers::pi * draws_.next();
      const double below = (k % 4) * piece_.bounding_radius / 3;
      offer(target_ + Vec3d{r * std::cos(t), r * std::sin(t), -below}, r);
    }
    return best_;
  }

  /// Tries positions in the whole section of the region, and takes the lowest.
  std::optional<RockPose> anywhere(const FeedRegion& region, int positions) {
    nearest_ = never;
    for (int k = 0; k < positions; ++k) {
      const double u = draws_.next(), v = draws_.next();
      const Vec3d p = region.draw(target_.z, u, v);
      offer({p.x, p.y, target_.z}, 0);
    }
    return best_;
  }

 private:
  void offer(const Vec3d& p, double aside) {
    const Quatd orientation = draws_.turn();
    if (aside >= nearest_) return;
    const double z = placement_.lowest_height(piece_, p.x, p.y, orientation, target_.z + nearest_,
                                              p.z - depth_of(piece_, orientation));
    const double distance = std::hypot(aside, z - target_.z);
    if (!(distance < nearest_)) return;
    nearest_ = distance;
    best_ = RockPose{{p.x, p.y, z}, orientation};
  }

  const Placement& placement_;
  const RockTemplate& piece_;
  Vec3d target_;
  Draws draws_;
  double nearest_ = never;  ///< distance from the target [m]
  std::optional<RockPose> best_;
};

/// Ids of the first particles of all pieces, and at the end that after the last.
std::vector<ParticleId> first_ids(const RockLibrary& library, const ChamberFilling& filling) {
  std::vector<ParticleId> first{filling.first_particle};
  for (const Piece& piece : filling.pieces) {
    const std::size_t count = piece.particles.empty() ? library.rocks[static_cast<std::size_t>(piece.rock)].radii.size()
                                                      : piece.particles.size();
    first.push_back(first.back() + static_cast<ParticleId>(count));
  }
  return first;
}

NewRock made_of(const RockTemplate& piece, const RockPose& pose, RockId number, ParticleId first,
                const BondStrength& strength) {
  NewRock rock;
  rock.id = piece.centres.size() > 1 ? number : none;
  rock.substeps = piece.substeps;
  rock.load_table = piece.load_table;
  rock.orientation = pose.orientation;
  for (std::size_t k = 0; k < piece.centres.size(); ++k)
    rock.particles.push_back({first + static_cast<ParticleId>(k),
                              pose.position + rotate(pose.orientation, piece.centres[k]),
                              {0, 0, 0},
                              {0, 0, 0},
                              piece.radii[k],
                              piece.particle_density});
  for (const TemplateBond& b : piece.bonds) {
    const auto i = first + static_cast<ParticleId>(b.i), j = first + static_cast<ParticleId>(b.j);
    rock.bonds.push_back({b.i, b.j, b.length, b.radius, strength ? strength(rock.id, i, j) : 1.0});
  }
  if (!piece.bonds.empty()) rock.colour_begin = piece.colour_begin;
  return rock;
}

}  // namespace

FillingCounts counts_of(const ChamberFilling& filling, const RockLibrary& library) {
  FillingCounts counts;
  counts.particles = static_cast<std::int64_t>(first_ids(library, filling).back() - filling.first_particle);
  for (const Piece& piece : filling.pieces) {
    counts.bonds += piece.bonds;
    counts.mass += piece.mass;
    if (piece.bonds == 0) counts.singles_mass += piece.mass;
  }
  return counts;
}

Filled fill(const RockLibrary& library, const ChamberFilling& filling, std::span<const Wall> walls,
            std::span<const WallPose> poses, const ParticleSnapshot& present, const BondStrength& strength) {
  const FeedRegion region(filling.chamber, walls);
  WallSet wall_set(walls, largest_radius(library), filling.clearance);
  wall_set.move(poses);
  Bed bed;
  for (std::size_t k = 0; k < present.size(); ++k) bed.add(present.position[k], present.radius[k]);
  const Placement placement(region, wall_set, bed, filling.clearance);
  const std::vector<ParticleId> first = first_ids(library, filling);
  std::vector<std::size_t> order(filling.pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t k) { return filling.pieces[k].mass; });
  std::vector<std::optional<NewRock>> made(filling.pieces.size());
  Filled filled;
  for (const std::size_t k : order) {
    const Piece& piece = filling.pieces[k];
    const RockTemplate part = template_of(library.rocks[static_cast<std::size_t>(piece.rock)], piece);
    const double reach = part.bounding_radius;
    const RockId number = filling.first_rock + static_cast<RockId>(k);
    PieceSearch search(placement, part, piece.target, {filling.seed, static_cast<std::uint64_t>(number)});
    std::optional<RockPose> pose = search.around(reach, 2 * reach, filling.positions);
    if (!pose) pose = search.around(4 * reach, 8 * reach, 4 * filling.positions);
    if (!pose) pose = search.anywhere(region, 16 * filling.positions);
    if (!pose) {
      ++filled.lost;
      filled.lost_mass += piece.mass;
      continue;
    }
    filled.mass += piece.mass;
    filled.shift += piece.mass * norm(pose->position - piece.target);
    filled.rise += piece.mass * (pose->position.z - piece.target.z);
    made[k] = made_of(part, *pose, number, first[k], strength);
    for (NewParticle& p : made[k]->particles) {
      p.velocity = piece.velocity;
      bed.add(p.position, p.radius);
    }
  }
  if (filled.mass > 0) filled.shift /= filled.mass, filled.rise /= filled.mass;
  for (std::optional<NewRock>& rock : made)
    if (rock) filled.rocks.push_back(std::move(*rock));
  return filled;
}

}  // namespace gyro

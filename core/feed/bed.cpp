// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/bed.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace gyro {
namespace {

/// Cells far outside are one, so that their numbers fit.
Vec3<Index> cell_of(const Vec3d& p, double cell) {
  constexpr double outside = 1e9;
  const auto number = [&](double x) { return static_cast<Index>(std::clamp(std::floor(x / cell), -outside, outside)); };
  return {number(p.x), number(p.y), number(p.z)};
}

/// A search that covers so many cells for each sphere is slower than to look at all spheres.
constexpr double max_cells_per_sphere = 8, few_cells = 1e4;

int level_number(double radius) {
  return static_cast<int>(std::ceil(std::log2(radius)));
}

// Large odd multipliers (Teschner et al. 2003, Optimized spatial hashing). Cells that share a
// bucket cost a distance check and change no result.
constexpr std::uint32_t by_x = 73856093u, by_y = 19349663u, by_z = 83492791u, by_level = 2654435761u;

std::uint32_t part_of_hash(Index cell, std::uint32_t factor) {
  return static_cast<std::uint32_t>(cell) * factor;
}

}  // namespace

const Bed::Level& Bed::level_of(double radius) const {
  return *std::ranges::find(levels_, level_number(radius), &Level::number);
}

void Bed::link(Index sphere) {
  const Sphere& s = spheres_[static_cast<std::size_t>(sphere)];
  const Level& level = level_of(s.radius);
  const Vec3<Index> cell = cell_of(s.centre, level.cell);
  const std::size_t b = bucket(part_of_hash(cell.x, by_x) ^ part_of_hash(cell.y, by_y) ^ part_of_hash(cell.z, by_z) ^
                               part_of_hash(level.number, by_level));
  next_[static_cast<std::size_t>(sphere)] = first_[b];
  first_[b] = sphere;
}

void Bed::add(const Vec3d& centre, double radius) {
  const int number = level_number(radius);
  auto level = std::ranges::lower_bound(levels_, number, std::greater<>(), &Level::number);
  if (level == levels_.end() || level->number != number)
    level = levels_.insert(level, Level{number, 2 * std::exp2(number), 0.0});
  level->largest = std::max(level->largest, radius);
  spheres_.push_back({centre, radius});
  next_.push_back(none);
  if (2 * spheres_.size() <= first_.size()) return link(static_cast<Index>(spheres_.size()) - 1);
  first_.assign(2 * first_.size(), none);
  for (std::size_t k = 0; k < spheres_.size(); ++k) link(static_cast<Index>(k));
}

double Bed::cells_near(double radius, double gap) const {
  double cells = 0;
  for (const Level& level : levels_) {
    const double along = 2 * (radius + level.largest + gap) / level.cell + 1;
    cells += along * along * along;
  }
  return cells;
}

template <class Visit>
void Bed::visit_near(const Vec3d& centre, double radius, double gap, const Visit& visit) const {
  const auto near = [&](std::size_t k, double& apart) {
    apart = radius + spheres_[k].radius + gap;
    return norm2(centre - spheres_[k].centre) < apart * apart;
  };
  double apart;
  if (cells_near(radius, gap) > few_cells + max_cells_per_sphere * static_cast<double>(spheres_.size())) {
    for (std::size_t k = 0; k < spheres_.size(); ++k)
      if (near(k, apart) && visit(static_cast<Index>(k), apart)) return;
    return;
  }
  for (const Level& level : levels_) {
    const double reach = radius + level.largest + gap;
    const Vec3d corner{reach, reach, reach};
    const Vec3<Index> low = cell_of(centre - corner, level.cell), high = cell_of(centre + corner, level.cell);
    for (Index z = low.z; z <= high.z; ++z) {
      const std::uint32_t layer = part_of_hash(z, by_z) ^ part_of_hash(level.number, by_level);
      for (Index y = low.y; y <= high.y; ++y) {
        const std::uint32_t row = layer ^ part_of_hash(y, by_y);
        for (Index x = low.x; x <= high.x; ++x) {
          for (Index k = first_[bucket(row ^ part_of_hash(x, by_x))]; k != none; k = next_[static_cast<std::size_t>(k)])
            if (near(static_cast<std::size_t>(k), apart) && visit(k, apart)) return;
        }
      }
    }
  }
}

double Bed::raised(const Vec3d& centre, double radius, double gap) const {
  double height = centre.z;
  visit_near(centre, radius, gap, [&](Index k, double apart) {
    const Vec3d d = centre - spheres_[static_cast<std::size_t>(k)].centre;
    const double above = std::sqrt(apart * apart - d.x * d.x - d.y * d.y);
    height = std::max(spheres_[static_cast<std::size_t>(k)].centre.z + above, std::nextafter(centre.z, centre.z + 1));
    return true;
  });
  return height;
}

std::vector<Index> Bed::overlapped(const Vec3d& centre, double radius) const {
  std::vector<Index> found;  // cells may share a bucket, so a sphere may be found twice
  visit_near(centre, radius, 0, [&](Index k, double) {
    found.push_back(k);
    return false;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace gyro

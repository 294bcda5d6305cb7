// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/bed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

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

int level_of(double radius) {
  return static_cast<int>(std::ceil(std::log2(radius)));
}

}  // namespace

std::size_t Bed::bucket(int level, const Vec3<Index>& cell) const {
  // Large odd multipliers (Teschner et al. 2003, Optimized spatial hashing). Cells that share a
  // bucket cost a distance check and change no result.
  const auto h = static_cast<std::uint32_t>(cell.x) * 73856093u ^ static_cast<std::uint32_t>(cell.y) * 19349663u ^
                 static_cast<std::uint32_t>(cell.z) * 83492791u ^ static_cast<std::uint32_t>(level) * 2654435761u;
  return (h ^ (h >> 15)) & (first_.size() - 1);
}

void Bed::link(Index sphere) {
  Sphere& s = spheres_[static_cast<std::size_t>(sphere)];
  const int level = level_of(s.radius);
  const std::size_t b = bucket(level, cell_of(s.centre, levels_.at(level).cell));
  s.next = first_[b];
  first_[b] = sphere;
}

void Bed::add(const Vec3d& centre, double radius) {
  const int level = level_of(radius);
  Level& l = levels_.try_emplace(level, Level{2 * std::exp2(level), 0.0}).first->second;
  l.largest = std::max(l.largest, radius);
  spheres_.push_back({centre, radius, none});
  if (2 * spheres_.size() <= first_.size()) return link(static_cast<Index>(spheres_.size()) - 1);
  first_.assign(2 * first_.size(), none);
  for (std::size_t k = 0; k < spheres_.size(); ++k) link(static_cast<Index>(k));
}

double Bed::cells_near(double radius, double gap) const {
  double cells = 0;
  for (const auto& [number, level] : levels_) {
    const double along = 2 * (radius + level.largest + gap) / level.cell + 1;
    cells += along * along * along;
  }
  return cells;
}

template <class Visit>
void Bed::visit_near(const Vec3d& centre, double radius, double gap, const Visit& visit) const {
  if (cells_near(radius, gap) > few_cells + max_cells_per_sphere * static_cast<double>(spheres_.size())) {
    for (std::size_t k = 0; k < spheres_.size(); ++k) {
      const double apart = radius + spheres_[k].radius + gap;
      if (norm2(centre - spheres_[k].centre) < apart * apart && visit(static_cast<Index>(k), apart)) return;
    }
    return;
  }
  for (auto entry = levels_.rbegin(); entry != levels_.rend(); ++entry) {
    const auto& [number, level] = *entry;
    const double reach = radius + level.largest + gap;
    const Vec3d corner{reach, reach, reach};
    const Vec3<Index> low = cell_of(centre - corner, level.cell), high = cell_of(centre + corner, level.cell);
    for (Index z = low.z; z <= high.z; ++z) {
      for (Index y = low.y; y <= high.y; ++y) {
        for (Index x = low.x; x <= high.x; ++x) {
          for (Index k = first_[bucket(number, {x, y, z})]; k != none;) {
            const Sphere& s = spheres_[static_cast<std::size_t>(k)];
            const double apart = radius + s.radius + gap;
            if (norm2(centre - s.centre) < apart * apart && visit(k, apart)) return;
            k = s.next;
          }
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

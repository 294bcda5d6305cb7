// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surfaces/profile_surface.hpp"

#include "core/base/errors.hpp"

#include <algorithm>

namespace gyro {

ProfileSurface::ProfileSurface(const ProfileShape& shape) {
  if (shape.points.size() < 2)
    throw BadInput("the profile has " + std::to_string(shape.points.size()) + " points; it needs two or more");
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const ProfilePoint& p = shape.points[i];
    const std::string which = "point " + std::to_string(i) + " of the profile ";
    if (!(std::isfinite(p.r) && std::isfinite(p.z))) throw BadInput(which + "is not finite; give finite numbers");
    if (p.r < 0) throw BadInput(which + "has a negative radius; it must be >= 0");
    if (i == 0) continue;
    const ProfilePoint& q = shape.points[i - 1];
    const double length = std::hypot(p.r - q.r, p.z - q.z);
    if (!(length > 0)) throw BadInput(which + "repeats the one before; remove one of them");
    segments_.push_back({q.r, q.z, (p.r - q.r) / length, (p.z - q.z) / length, length});
  }
  fill_bins(shape);
}

void ProfileSurface::fill_bins(const ProfileShape& shape) {
  const auto [low, high] = std::minmax_element(shape.points.begin(), shape.points.end(),
                                               [](const ProfilePoint& a, const ProfilePoint& b) { return a.z < b.z; });
  const auto count = static_cast<Index>(segments_.size());
  const Index bin_count = high->z > low->z ? std::clamp<Index>(2 * count, 16, 4096) : 1;
  z_begin_ = low->z;
  // A hair taller, so that the highest point is inside the last slice whatever the rounding.
  bin_height_ = high->z > low->z ? (high->z - low->z) / bin_count * (1 + 1e-12) : 1;
  bins_.assign(static_cast<std::size_t>(bin_count), {count, 0});
  for (Index k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double z0 = shape.points[i].z, z1 = shape.points[i + 1].z;
    const auto bin_of = [&](double z) {
      return std::clamp<Index>(static_cast<Index>((z - z_begin_) / bin_height_), 0, bin_count - 1);
    };
    // One slice more on each side: rounding cannot lose a segment.
    const Index first = std::max<Index>(bin_of(std::min(z0, z1)) - 1, 0);
    const Index last = std::min<Index>(bin_of(std::max(z0, z1)) + 1, bin_count - 1);
    for (Index b = first; b <= last; ++b) {
      SegmentRange& range = bins_[static_cast<std::size_t>(b)];
      range.first = std::min(range.first, k);
      range.last = std::max(range.last, k + 1);
    }
  }
}

ProfileView ProfileSurface::view() const {
  return {segments_.data(), static_cast<Index>(segments_.size()),
          bins_.data(),     static_cast<Index>(bins_.size()),
          z_begin_,         bin_height_};
}

}  // namespace gyro

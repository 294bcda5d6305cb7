// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/scene/scene.hpp"
#include "core/surfaces/profile.hpp"

#include <vector>

namespace gyro {

/// A profile prepared for contact: unit directions and a table of segments by height.
class ProfileSurface {
 public:
  /// @throws BadInput for fewer than two points, points that repeat, a negative radius, a number
  ///         that is not finite
  explicit ProfileSurface(const ProfileShape& shape);

  ProfileView view() const;
  const std::vector<ProfileSegment>& segments() const { return segments_; }
  const std::vector<SegmentRange>& bins() const { return bins_; }

 private:
  void fill_bins(const ProfileShape& shape);

  std::vector<ProfileSegment> segments_;
  std::vector<SegmentRange> bins_;
  double z_begin_ = 0, bin_height_ = 1;
};

}  // namespace gyro

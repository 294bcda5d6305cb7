// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/close_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro::bench {
namespace {

/// Spheres in cells that are as wide as the longest reach, in the order of the cells.
class Cells {
 public:
  Cells(std::span<const Vec3d> centres, double width) : width_(width) {
    low_ = high_ = centres.front();
    for (const Vec3d& x : centres) {
      low_ = {std::min(low_.x, x.x), std::min(low_.y, x.y), std::min(low_.z, x.z)};
      high_ = {std::max(high_.x, x.x), std::max(high_.y, x.y), std::max(high_.z, x.z)};
    }
    const Vec3<int> last = cell_of(high_);
    count_ = {last.x + 1, last.y + 1, last.z + 1};
    begin_.assign(static_cast<std::size_t>(count_.x) * count_.y * count_.z + 1, 0);
    for (const Vec3d& x : centres) ++begin_[number(cell_of(x)) + 1];
    for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    members_.resize(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
      members_[next[number(cell_of(centres[i]))]++] = static_cast<Index>(i);
  }

  /// Calls visit(j) for the members of the 27 cells around a point.
  template <class Visit>
  void visit_around(const Vec3d& x, const Visit& visit) const {
    const Vec3<int> c = cell_of(x);
    for (int a = std::max(c.x - 1, 0); a <= std::min(c.x + 1, count_.x - 1); ++a)
      for (int b = std::max(c.y - 1, 0); b <= std::min(c.y + 1, count_.y - 1); ++b)
        for (int d = std::max(c.z - 1, 0); d <= std::min(c.z + 1, count_.z - 1); ++d) {
          const std::size_t cell = number({a, b, d});
          for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k) visit(members_[k]);
        }
  }

 private:
  Vec3<int> cell_of(const Vec3d& x) const {
    const auto along = [this](double at, double low) { return static_cast<int>((at - low) / width_); };
    return {along(x.x, low_.x), along(x.y, low_.y), along(x.z, low_.z)};
  }
  std::size_t number(const Vec3<int>& c) const {
    return (static_cast<std::size_t>(c.x) * count_.y + c.y) * count_.z + c.z;
  }

  double width_;
  Vec3d low_, high_;
  Vec3<int> count_;
  std::vector<std::size_t> begin_;  ///< of each cell in members_
  std::vector<Index> members_;
};

}  // namespace

std::vector<ClosePair> close_pairs(std::span<const Vec3d> centres, std::span<const double> radii, double gap) {
  std::vector<ClosePair> pairs;
  if (centres.empty()) return pairs;
  const double largest = *std::ranges::max_element(radii);
  const Cells cells(centres, 2 * largest + gap);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const std::size_t first = pairs.size();
    cells.visit_around(centres[i], [&](Index j) {
      const auto other = static_cast<std::size_t>(j);
      const double reach = radii[i] + radii[other] + gap;
      if (other > i && norm2(centres[other] - centres[i]) < reach * reach) pairs.push_back({static_cast<Index>(i), j});
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(),
              [](const ClosePair& a, const ClosePair& b) { return a.j < b.j; });
  }
  return pairs;
}

double smallest_room(std::span<const Vec3d> centres, std::span<const double> radii) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : close_pairs(centres, radii, 0.5 * *std::ranges::min_element(radii)))
    smallest = std::min(smallest, norm(centres[j] - centres[i]) / (radii[i] + radii[j]));
  return smallest;
}

}  // namespace gyro::bench

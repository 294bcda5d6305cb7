// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/packing.hpp"

#include "core/base/hd.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

/// Packing fraction of the soft spheres. Random equal spheres jam at about 0.639 (O'Hern et al., Phys.
/// Rev. E 68 (2003) 011306). One percent below, the energy falls to nothing in half the steps, overlaps
/// end at 0.4 % of the radius instead of 2 %, and the neighbours within 0.05 radius are as many (7.2).
constexpr double soft_fraction = 0.632;
constexpr double largest_overlap = 0.009;  // [radius]
constexpr double margin = 0.3;             // of the neighbour list [radius]

struct Pair {
  Index i, j;
};

/// Shortest difference between images in a periodic cube.
Vec3d nearest(Vec3d d, double side) {
  const auto wrap = [side](double x) { return x - side * std::nearbyint(x / side); };
  return {wrap(d.x), wrap(d.y), wrap(d.z)};
}

/// All pairs of centres closer than the reach, by a grid of cells of at least that size.
std::vector<Pair> close_pairs(const std::vector<Vec3d>& x, double side, double reach) {
  const int cells = std::max(3, static_cast<int>(side / reach));
  const auto place = [&](double c) {
    const int k = static_cast<int>(std::floor(c / side * cells)) % cells;
    return k < 0 ? k + cells : k;
  };
  std::vector<std::vector<Index>> members(static_cast<std::size_t>(cells) * cells * cells);
  const auto cell = [&](int a, int b, int c) -> std::vector<Index>& {
    return members[(static_cast<std::size_t>(a) * cells + b) * cells + c];
  };
  std::vector<Pair> pairs;
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) {  // each with the earlier ones only
    const int a = place(x[i].x), b = place(x[i].y), c = place(x[i].z);
    for (int k = 0; k < 27; ++k) {
      const auto& others =
          cell((a + k / 9 + cells - 1) % cells, (b + k / 3 % 3 + cells - 1) % cells, (c + k % 3 + cells - 1) % cells);
      for (const Index j : others) {
        if (norm2(nearest(x[i] - x[j], side)) < reach * reach) pairs.push_back({j, i});
      }
    }
    cell(a, b, c).push_back(i);
  }
  return pairs;
}

/// Soft spheres of mass 1 that repel with force = overlap, on their way to rest.
class SoftSpheres {
 public:
  SoftSpheres(std::vector<Vec3d> centres, double side)
      : side_(side), x_(std::move(centres)), v_(x_.size(), Vec3d{0, 0, 0}), force_(x_.size()) {}

  /// FIRE with its published parameters. @return steps taken
  int settle(double force_tolerance, int most_steps) {
    double dt = 0.1, mixing = 0.1;
    int downhill = 0, step = 0;
    find_pairs();
    update_forces();
    for (; step < most_steps && largest_force() > force_tolerance; ++step) {
      double power = 0, speed2 = 0, force2 = 0;
      for (std::size_t i = 0; i < x_.size(); ++i) {
        power += dot(force_[i], v_[i]), speed2 += norm2(v_[i]), force2 += norm2(force_[i]);
      }
      if (power > 0) {
        const double along = mixing * std::sqrt(speed2 / force2);
        for (std::size_t i = 0; i < x_.size(); ++i) v_[i] = (1 - mixing) * v_[i] + along * force_[i];
        if (++downhill > 5) dt = std::min(1.1 * dt, 0.5), mixing *= 0.99;
      } else {
        std::fill(v_.begin(), v_.end(), Vec3d{0, 0, 0});
        dt = std::max(0.5 * dt, 0.02), mixing = 0.1, downhill = 0;
      }
      for (std::size_t i = 0; i < x_.size(); ++i) {
        v_[i] += dt * force_[i];
        x_[i] += dt * v_[i];
      }
      if (moved_too_far()) find_pairs();
      update_forces();
    }
    return step;
  }

  const std::vector<Vec3d>& centres() const { return x_; }

 private:
  void find_pairs() {
    pairs_ = close_pairs(x_, side_, 2 + margin);
    listed_ = x_;
  }

  bool moved_too_far() const {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (norm2(x_[i] - listed_[i]) > margin * margin / 4) return true;
    }
    return false;
  }

  void update_forces() {
    std::fill(force_.begin(), force_.end(), Vec3d{0, 0, 0});
    for (const auto& [i, j] : pairs_) {
      const Vec3d d = nearest(x_[i] - x_[j], side_);
      const double r2 = norm2(d);
      if (r2 >= 4 || r2 == 0) continue;
      const double r = std::sqrt(r2);
      const Vec3d f = ((2 - r) / r) * d;
      force_[i] += f, force_[j] -= f;
    }
  }

  double largest_force() const {
    double largest = 0;
    for (const Vec3d& f : force_) largest = std::max(largest, norm2(f));
    return std::sqrt(largest);
  }

  double side_;
  std::vector<Vec3d> x_, v_, force_, listed_;
  std::vector<Pair> pairs_;
};

}  // namespace

Packing jam_spheres(int spheres, std::uint64_t seed) {
  constexpr double sphere_volume = 4 * std::numbers::pi / 3;
  const double soft_side = std::cbrt(spheres * sphere_volume / soft_fraction);
  std::vector<Vec3d> points;
  for (int i = 0; i < spheres; ++i) {
    const auto draw = [&](std::uint32_t k) { return soft_side * uniform(seed, Stream::fill, i, k); };
    points.push_back({draw(0), draw(1), draw(2)});
  }
  SoftSpheres soft(std::move(points), soft_side);
  soft.settle(1e-4, 5000);

  double closest = 2;
  for (const auto& [i, j] : close_pairs(soft.centres(), soft_side, 2)) {
    closest = std::min(closest, norm(nearest(soft.centres()[i] - soft.centres()[j], soft_side)));
  }
  const double growth = std::max(1.0, (2 - largest_overlap) / closest);
  Packing packing;
  packing.side = growth * soft_side;
  packing.fraction = spheres * sphere_volume / (packing.side * packing.side * packing.side);
  packing.overlap = 2 - growth * closest;
  for (const Vec3d& x : soft.centres()) {
    const auto wrap = [&](double c) { return c - packing.side * std::floor(c / packing.side); };
    const Vec3d y = growth * x;
    packing.centres.push_back({wrap(y.x), wrap(y.y), wrap(y.z)});
  }
  return packing;
}

const Packing& rock_packing() {
  static const Packing packing = jam_spheres(2500, 1);
  return packing;
}

}  // namespace gyro

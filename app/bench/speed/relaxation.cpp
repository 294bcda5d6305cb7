// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/relaxation.hpp"

#include "app/bench/speed/close_pairs.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyro::bench {
namespace {

constexpr double tolerance = 1e-4;  ///< overlap / sum of radii [-]
constexpr int max_steps = 800;

std::vector<Vec3d> lattice(double spacing, const Domain& domain) {
  std::vector<Vec3d> points;
  for (double x = domain.low.x + spacing / 2; x < domain.high.x; x += spacing)
    for (double y = domain.low.y + spacing / 2; y < domain.high.y; y += spacing)
      for (double z = domain.low.z + spacing / 2; z < domain.high.z; z += spacing)
        if (domain.inside({x, y, z})) points.push_back({x, y, z});
  return points;
}

/// Leaves out points at random until there are `count`.
void thin_out(std::vector<Vec3d>& points, std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [seed](std::size_t k) { return uniform(seed, Stream::fill, k, 0); };
  std::ranges::sort(order, {}, rank);
  order.resize(count);
  std::ranges::sort(order);
  for (std::size_t k = 0; k < count; ++k) points[k] = points[order[k]];
  points.resize(count);
}

/// FIRE with unit masses and a unit spring.
class Relaxation {
 public:
  Relaxation(std::vector<Vec3d>& centres, const std::vector<double>& radii, const Confine& confine)
      : x_(centres),
        radii_(radii),
        confine_(confine),
        skin_(0.3 * *std::ranges::max_element(radii)),
        v_(centres.size(), Vec3d{0, 0, 0}),
        force_(centres.size()) {}

  void run() {
    for (int step = 0; step < max_steps; ++step) {
      if (step == 0 || moved_too_far()) pairs_ = close_pairs(listed_ = x_, radii_, skin_);
      if (!push()) return;
      turn_downhill();
      move();
    }
  }

 private:
  bool moved_too_far() const {
    for (std::size_t i = 0; i < x_.size(); ++i)
      if (norm2(x_[i] - listed_[i]) > 0.25 * skin_ * skin_) return true;
    return false;
  }
  /// Forces. @return false if there is nothing left to do
  bool push() {
    std::ranges::fill(force_, Vec3d{0, 0, 0});
    double largest = 0;
    for (const auto& [i, j] : pairs_) {
      const Vec3d d = x_[j] - x_[i];
      const double sum = radii_[i] + radii_[j], distance = norm(d) + 1e-300, overlap = sum - distance;
      if (overlap <= 0) continue;
      largest = std::max(largest, overlap / sum);
      const Vec3d f = ((overlap + 2 * tolerance * sum) / distance) * d;
      force_[i] -= f, force_[j] += f;
    }
    return largest >= tolerance;
  }
  void turn_downhill() {
    double power = 0, speed2 = 0, force2 = 0;
    for (std::size_t i = 0; i < x_.size(); ++i)
      power += dot(force_[i], v_[i]), speed2 += norm2(v_[i]), force2 += norm2(force_[i]);
    if (power > 0) {
      const double along = mixing_ * std::sqrt(speed2 / force2);
      for (std::size_t i = 0; i < x_.size(); ++i) v_[i] = (1 - mixing_) * v_[i] + along * force_[i];
      if (++downhill_ > 5) dt_ = std::min(1.1 * dt_, 0.9), mixing_ *= 0.99;
    } else {
      std::ranges::fill(v_, Vec3d{0, 0, 0});
      dt_ = std::max(0.5 * dt_, 0.1), mixing_ = 0.1, downhill_ = 0;
    }
  }
  void move() {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Vec3d before = x_[i];
      x_[i] = confine_(before + dt_ * (v_[i] + dt_ * force_[i]), radii_[i]);
      v_[i] = (1 / dt_) * (x_[i] - before);
    }
  }

  std::vector<Vec3d>& x_;
  const std::vector<double>& radii_;
  const Confine& confine_;
  double skin_;
  std::vector<Vec3d> v_, force_, listed_;  ///< listed_: centres when the pairs were found
  std::vector<ClosePair> pairs_;
  double dt_ = 0.3, mixing_ = 0.1;
  int downhill_ = 0;
};

}  // namespace

std::vector<Vec3d> jittered_lattice(int count, const Domain& domain, std::uint64_t seed) {
  const Vec3d size = domain.high - domain.low;
  const double share = std::cbrt(size.x * size.y * size.z / count);
  double close = 0.2 * share, wide = 2 * share;
  for (int k = 0; k < 40; ++k) {
    const double spacing = 0.5 * (close + wide);
    (lattice(spacing, domain).size() >= static_cast<std::size_t>(count) ? close : wide) = spacing;
  }
  std::vector<Vec3d> points = lattice(close, domain);
  thin_out(points, static_cast<std::size_t>(count), seed);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto jitter = [&](std::uint32_t axis) {
      return 0.3 * close * (2 * uniform(seed, Stream::place, k, axis) - 1);
    };
    points[k] += Vec3d{jitter(0), jitter(1), jitter(2)};
  }
  return points;
}

void separate(std::vector<Vec3d>& centres, const std::vector<double>& radii, const Confine& confine) {
  Relaxation(centres, radii, confine).run();
}

}  // namespace gyro::bench

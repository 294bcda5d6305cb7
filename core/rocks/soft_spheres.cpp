// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/soft_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

/// Spheres of a periodic cube, sorted into cells that are at least `reach` wide.
class CellGrid {
 public:
  CellGrid(double side, double reach)
      : side_(side),
        cells_(std::max(3, static_cast<int>(side / reach))),
        members_(static_cast<std::size_t>(cells_) * cells_ * cells_) {}

  void add(const Vec3d& x, Index i) { members(cell(x.x), cell(x.y), cell(x.z)).push_back(i); }

  /// Calls visit(j) for all members of the 27 cells around a point.
  template <class Visit>
  void visit_around(const Vec3d& x, const Visit& visit) {
    const int a = cell(x.x) + cells_, b = cell(x.y) + cells_, c = cell(x.z) + cells_;
    for (int k = 0; k < 27; ++k) {
      for (const Index j : members((a + k / 9 - 1) % cells_, (b + k / 3 % 3 - 1) % cells_, (c + k % 3 - 1) % cells_))
        visit(j);
    }
  }

 private:
  int cell(double c) const {
    const int k = static_cast<int>(std::floor(c / side_ * cells_)) % cells_;
    return k < 0 ? k + cells_ : k;
  }
  std::vector<Index>& members(int a, int b, int c) {
    return members_[(static_cast<std::size_t>(a) * cells_ + b) * cells_ + c];
  }

  double side_;
  int cells_;
  std::vector<std::vector<Index>> members_;
};

}  // namespace

void scale(Vessel& vessel, double factor) {
  for (Vessel::Face& face : vessel.faces) face.offset *= factor;
  vessel.volume *= factor * factor * factor;
  vessel.reach *= factor;
}

Vec3d nearest_image(const Vec3d& d, double side) {
  const auto wrap = [side](double x) { return x - side * std::nearbyint(x / side); };
  return {wrap(d.x), wrap(d.y), wrap(d.z)};
}

SoftSpheres::SoftSpheres(std::vector<Vec3d> centres, std::vector<double> radii, double side, double list_skin)
    : side_(side),
      skin_(list_skin),
      largest_radius_(*std::max_element(radii.begin(), radii.end())),
      radii_(std::move(radii)),
      x_(std::move(centres)),
      v_(x_.size(), Vec3d{0, 0, 0}),
      force_(x_.size()) {}

// If the period is at least four times the reach, no sphere touches the image of another one.
SoftSpheres::SoftSpheres(std::vector<Vec3d> centres, std::vector<double> radii, Vessel vessel, double list_skin)
    : SoftSpheres(std::move(centres), std::move(radii), 4 * vessel.reach, list_skin) {
  vessel_ = std::move(vessel);
}

bool SoftSpheres::settle(double force_tolerance, int max_steps, double overlap_limit) {
  dt_ = 0.1, mixing_ = 0.1, downhill_ = 0;
  std::fill(v_.begin(), v_.end(), Vec3d{0, 0, 0});
  find_pairs();
  update_forces();
  for (int step = 0; step < max_steps; ++step) {
    if (!(largest_force() > force_tolerance)) return true;
    if (overlap_limit > 0 && step % 10 == 0 && largest_overlap() <= overlap_limit) return true;
    move();
    if (moved_too_far()) find_pairs();
    update_forces();
  }
  return false;
}

/// One step of FIRE.
void SoftSpheres::move() {
  double power = 0, speed2 = 0, force2 = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    power += dot(force_[i], v_[i]), speed2 += norm2(v_[i]), force2 += norm2(force_[i]);
  }
  if (power > 0) {
    const double along = mixing_ * std::sqrt(speed2 / force2);
    for (std::size_t i = 0; i < x_.size(); ++i) v_[i] = (1 - mixing_) * v_[i] + along * force_[i];
    if (++downhill_ > 5) dt_ = std::min(1.1 * dt_, 0.5), mixing_ *= 0.99;
  } else {
    std::fill(v_.begin(), v_.end(), Vec3d{0, 0, 0});
    dt_ = std::max(0.5 * dt_, 0.02), mixing_ = 0.1, downhill_ = 0;
  }
  for (std::size_t i = 0; i < x_.size(); ++i) {
    v_[i] += (dt_ / radii_[i]) * force_[i];
    x_[i] += dt_ * v_[i];
  }
}

void SoftSpheres::scale(double factor) {
  side_ *= factor;
  gyro::scale(vessel_, factor);
  for (Vec3d& x : x_) x = factor * x;
}

/// Lists the pairs whose surfaces are closer than the skin. Spheres are sorted into levels, one for each factor 2 of
/// radius, each with a grid of cells as wide as its longest reach. Each sphere searches its own level and coarser ones.
void SoftSpheres::find_pairs() {
  std::vector<CellGrid> levels;
  for (double largest = 1; levels.empty() || largest / 2 < largest_radius_; largest *= 2)
    levels.emplace_back(side_, 2 * std::min(largest, largest_radius_) + skin_);
  pairs_.clear();
  const auto count = static_cast<Index>(x_.size());
  std::vector<std::size_t> level(x_.size());
  for (Index i = 0; i < count; ++i) {
    level[i] = static_cast<std::size_t>(std::ceil(std::log2(radii_[i])));
    levels[level[i]].visit_around(x_[i], [&](Index j) { add_if_close(j, i); });  // of those added before
    levels[level[i]].add(x_[i], i);
  }
  for (Index i = 0; i < count; ++i) {
    for (std::size_t coarser = level[i] + 1; coarser < levels.size(); ++coarser)
      levels[coarser].visit_around(x_[i], [&](Index j) { add_if_close(j, i); });
  }
  find_touches();
  x_listed_ = x_;
}

void SoftSpheres::find_touches() {
  touches_.clear();
  for (Index i = 0; i < static_cast<Index>(x_.size()); ++i) {
    for (std::size_t k = 0; k < vessel_.faces.size(); ++k)
      if (depth({i, k}) > -skin_) touches_.push_back({i, k});
  }
}

/// Overlap of a sphere with a face.
double SoftSpheres::depth(const Touch& touch) const {
  const Vessel::Face& face = vessel_.faces[touch.face];
  return dot(face.normal, x_[touch.i]) + radii_[touch.i] - face.offset;
}

void SoftSpheres::add_if_close(Index j, Index i) {
  const double far = radii_[i] + radii_[j] + skin_;
  if (norm2(nearest_image(x_[i] - x_[j], side_)) < far * far) pairs_.push_back({j, i});
}

bool SoftSpheres::moved_too_far() const {
  const double allowed = skin_ - reach_;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (norm2(x_[i] - x_listed_[i]) > allowed * allowed / 4) return true;
  }
  return false;
}

void SoftSpheres::update_forces() {
  std::fill(force_.begin(), force_.end(), Vec3d{0, 0, 0});
  for (const auto& [i, j] : pairs_) {
    const Vec3d d = nearest_image(x_[i] - x_[j], side_);
    const double sum = radii_[i] + radii_[j], far = sum + reach_;
    const double r2 = norm2(d);
    if (r2 >= far * far || r2 == 0) continue;
    const double r = std::sqrt(r2), overlap = sum - r;
    const double push = cohesion_ == 0 ? overlap : overlap - cohesion_ * std::min(1.0, 1 + overlap / reach_);
    const Vec3d f = (2 * radii_[i] * radii_[j] / sum * push / r) * d;
    force_[i] += f, force_[j] -= f;
  }
  for (const Touch& touch : touches_) {
    const double overlap = depth(touch);
    if (overlap > 0) force_[touch.i] -= (2 * radii_[touch.i] * overlap) * vessel_.faces[touch.face].normal;
  }
}

double SoftSpheres::largest_force() const {
  double largest = 0;
  for (const Vec3d& f : force_) largest = std::max(largest, norm2(f));
  return std::sqrt(largest);
}

double SoftSpheres::largest_overlap() const {
  double largest = 0;
  for (const auto& [i, j] : pairs_) {
    const double r = norm(nearest_image(x_[i] - x_[j], side_));
    largest = std::max(largest, (radii_[i] + radii_[j] - r) / std::min(radii_[i], radii_[j]));
  }
  for (const Touch& touch : touches_) largest = std::max(largest, depth(touch) / radii_[touch.i]);
  return largest;
}

double SoftSpheres::growth_to(double overlap) const {
  double growth = 1;
  for (const auto& [i, j] : pairs_) {
    const double allowed = radii_[i] + radii_[j] - overlap * std::min(radii_[i], radii_[j]);
    growth = std::max(growth, allowed / norm(nearest_image(x_[i] - x_[j], side_)));
  }
  for (const Touch& touch : touches_) {
    const Vessel::Face& face = vessel_.faces[touch.face];
    growth = std::max(growth, radii_[touch.i] * (1 - overlap) / (face.offset - dot(face.normal, x_[touch.i])));
  }
  return growth;
}

double SoftSpheres::fraction() const {
  double sum = 0;
  for (const double r : radii_) sum += r * r * r;
  const double cube = side();
  return 4 * std::numbers::pi / 3 * sum / (cube * cube * cube);
}

double SoftSpheres::side() const {
  return vessel_.faces.empty() ? side_ : std::cbrt(vessel_.volume);
}

}  // namespace gyro

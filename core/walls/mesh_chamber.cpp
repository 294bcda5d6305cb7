// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/mesh_chamber.hpp"

#include "core/base/errors.hpp"
#include "core/walls/radial_sections.hpp"
#include "core/walls/slice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

HeightRange heights_of(const TriangleMesh& mesh, double lift) {
  HeightRange range{1e300, -1e300};
  for (const Vec3d& v : mesh.vertices) range = {std::min(range.low, v.z + lift), std::max(range.high, v.z + lift)};
  return range;
}

HeightRange common_heights(const MeshLiners& liners) {
  const HeightRange a = heights_of(liners.concave, 0), b = heights_of(liners.mantle, liners.motion.lift);
  const HeightRange both{std::max(a.low, b.low), std::min(a.high, b.high)};
  if (!(both.low < both.high))
    throw BadInput("mantle and concave have no height in common; draw both meshes in their working position");
  return both;
}

constexpr double no_nip = std::numbers::pi / 4;  // liners at a larger angle do not nip rock

/// The centred chamber in half-planes; gaps are radial. It ends at the lowest level above its middle where the liners
/// begin to open by more than `no_nip`: at the mantle's head, or at an edge of the feed opening.
class SectionedChamber {
 public:
  explicit SectionedChamber(const MeshLiners& liners)
      : motion_(liners.motion),
        heights_(common_heights(liners)),
        concave_(liners.concave, 0, heights_, RadialSections::Face::innermost),
        mantle_(liners.mantle, liners.motion.lift, heights_, RadialSections::Face::outermost) {
    while (last_ < RadialSections::levels - 1 && mean_nip_angle(last_) <= no_nip) ++last_;
    heights_.high = level(last_);
  }

  double bottom() const { return heights_.low; }
  double height() const { return heights_.high - heights_.low; }
  int last() const { return last_; }  ///< level of the chamber's top
  double level(int k) const { return concave_.level(k); }
  double bridged() const { return std::max(concave_.bridged(), mantle_.bridged()); }

  /// Area of the annulus that one half-plane represents [m2].
  double area(int azimuth, double z) const {
    const double c = concave_.at(azimuth, z), m = mantle_.at(azimuth, z);
    return std::max(0.0, std::numbers::pi / RadialSections::azimuths * (c + m) * (c - m));
  }
  double closed_gap(int azimuth, double z) const { return gap(azimuth, z) - eccentricity(z); }
  double open_gap(int azimuth, double z) const { return gap(azimuth, z) + eccentricity(z); }

  /// Angle between the liners' chords from `half` below to `half` above, within the chamber, with the mantle leaning to
  /// that side.
  double nip_angle(int azimuth, double z, double half) const {
    const double low = std::max(z - half, heights_.low), high = std::min(z + half, heights_.high);
    const auto lean = [&](const RadialSections& liner) {
      return std::atan2(liner.at(azimuth, high) - liner.at(azimuth, low), high - low);
    };
    return lean(concave_) - lean(mantle_) + std::asin(motion_.eccentricity / motion_.pivot_height);
  }

 private:
  /// Volume between a level and the next, over all azimuths [m3].
  double mean_nip_angle(int k) const {
    const double middle = (level(k) + level(k + 1)) / 2, half = (level(k + 1) - level(k)) / 2;
    double sum = 0;
    for (int a = 0; a < RadialSections::azimuths; ++a) sum += nip_angle(a, middle, half);
    return sum / RadialSections::azimuths;
  }
  double gap(int azimuth, double z) const { return concave_.at(azimuth, z) - mantle_.at(azimuth, z); }
  double eccentricity(double z) const { return motion_.eccentricity * (1 - z / motion_.pivot_height); }

  GyrationMotion motion_;
  HeightRange heights_;
  RadialSections concave_, mantle_;
  int last_ = RadialSections::levels / 2;
};

double volume_of(const SectionedChamber& chamber) {
  const int last = chamber.last();
  double volume = 0;
  for (int k = 0; k <= last; ++k)
    for (int a = 0; a < RadialSections::azimuths; ++a)
      volume += (k == 0 || k == last ? 0.5 : 1.0) * chamber.area(a, chamber.level(k));
  return volume * chamber.height() / last;
}

void set_capacity(MeshReport& report, const SectionedChamber& chamber, double speed, double gravity) {
  const double half_turn = std::numbers::pi / speed, fall = gravity * half_turn * half_turn / 2;
  report.capacity = 0;
  report.choke_height = chamber.bottom();
  bool found = false;
  for (int k = 0; k <= chamber.last(); ++k) {
    const double z = chamber.level(k);
    double passed = 0, area = 0;  // per gyration; of the annulus
    for (int a = 0; a < RadialSections::azimuths; ++a) {
      const auto open_gap = [&](double height) { return chamber.open_gap(a, height); };
      const double here = chamber.area(a, z);
      passed += here * slice_drop(z, chamber.bottom(), fall, chamber.closed_gap(a, z), open_gap);
      area += here;
    }
    const double drop = area > 0 ? passed / area : 0, capacity = passed * speed / (2 * std::numbers::pi);
    if (z - drop < chamber.bottom() || (found && capacity >= report.capacity)) continue;
    report.capacity = capacity;
    report.choke_height = z;
    found = true;
  }
}

std::vector<MeshReport::NipAngle> nip_angles(const SectionedChamber& chamber) {
  constexpr int heights = 13;
  std::vector<MeshReport::NipAngle> angles;
  for (int k = 0; k < heights; ++k) {
    const double z = chamber.bottom() + chamber.height() * k / (heights - 1);
    MeshReport::NipAngle nip{z, 1e300, -1e300};
    for (int a = 0; a < RadialSections::azimuths; ++a) {
      const double angle = chamber.nip_angle(a, z, 0.01 * chamber.height());
      nip = {z, std::min(nip.minimum, angle), std::max(nip.largest, angle)};
    }
    angles.push_back(nip);
  }
  return angles;
}

}  // namespace

MeshReport measure(const MeshLiners& liners, double speed, double gravity) {
  if (!(speed > 0 && gravity > 0)) throw BadInput("the slice capacity needs a speed > 0 and a gravity > 0");
  MeshReport report;
  report.sides = MeshGap(liners.mantle, liners.concave, liners.motion).sides(liners.motion.lift);
  report.closed_side_setting = 1e300;
  report.open_side_setting = report.throw_at_discharge = 0;
  for (const SideOfMeshes& side : report.sides) {
    report.closed_side_setting = std::min(report.closed_side_setting, side.closed);
    report.open_side_setting = std::max(report.open_side_setting, side.open);
    report.throw_at_discharge += (side.open - side.closed) / double(report.sides.size());
  }
  const SectionedChamber chamber(liners);
  report.bottom = chamber.bottom();
  report.top = chamber.bottom() + chamber.height();
  report.volume = volume_of(chamber);
  report.nip_angle = nip_angles(chamber);
  report.bridged = chamber.bridged();
  set_capacity(report, chamber, speed, gravity);
  return report;
}

}  // namespace gyro

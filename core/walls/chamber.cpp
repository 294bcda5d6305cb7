// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/walls/liners.hpp"
#include "core/walls/slice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

/// Radius of one liner at a height: linear between the rows and beyond them; `shift` lifts the rows.
double radius_at(const std::vector<LinerRow>& rows, double LinerRow::*radius, double shift, double z) {
  std::size_t i = 1;
  while (i + 1 < rows.size() && rows[i].z + shift < z) ++i;
  const LinerRow &a = rows[i - 1], &b = rows[i];
  const double t = (z - shift - a.z) / (b.z - a.z);
  return a.*radius + t * (b.*radius - a.*radius);
}

/// The chamber with the mantle centred: heights that both liners have, radial gaps.
struct Chamber {
  const Liners& liners;

  double bottom() const { return liners.rows.front().z; }
  double top() const { return liners.rows.back().z + std::min(liners.motion.lift, 0.0); }
  double mantle(double z) const { return radius_at(liners.rows, &LinerRow::mantle_radius, liners.motion.lift, z); }
  double concave(double z) const { return radius_at(liners.rows, &LinerRow::concave_radius, 0, z); }
  double area(double z) const {
    const double c = concave(z), m = mantle(z);
    return std::numbers::pi * (c + m) * (c - m);
  }
  double eccentricity(double z) const { return liners.setting.eccentricity * (1 - z / liners.setting.pivot_height); }
  double closed_gap(double z) const { return concave(z) - mantle(z) - eccentricity(z); }
  double open_gap(double z) const { return concave(z) - mantle(z) + eccentricity(z); }
};

double volume_of(const Chamber& chamber) {
  std::vector<double> levels{chamber.bottom(), chamber.top()};
  for (const LinerRow& row : chamber.liners.rows)
    for (const double z : {row.z, row.z + chamber.liners.motion.lift})
      if (z > chamber.bottom() && z < chamber.top()) levels.push_back(z);
  std::sort(levels.begin(), levels.end());
  double volume = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {  // Simpson's rule is exact for a quadratic
    const double a = levels[i - 1], b = levels[i];
    volume += (b - a) / 6 * (chamber.area(a) + 4 * chamber.area((a + b) / 2) + chamber.area(b));
  }
  return volume;
}

/// Angle between the two liners, from row i to row i + 1 [rad].
double opening(const std::vector<LinerRow>& rows, std::size_t i) {
  const double height = rows[i + 1].z - rows[i].z;
  return std::atan2(rows[i + 1].concave_radius - rows[i].concave_radius, height) -
         std::atan2(rows[i + 1].mantle_radius - rows[i].mantle_radius, height);
}

std::vector<double> nip_angles(const Liners& liners) {
  const double tilt = std::asin(liners.setting.eccentricity / liners.setting.pivot_height);
  const std::size_t last = liners.rows.size() - 1;
  std::vector<double> angles;
  for (std::size_t i = 0; i <= last; ++i) {
    const double down = opening(liners.rows, i > 0 ? i - 1 : 0), up = opening(liners.rows, i < last ? i : last - 1);
    angles.push_back((down + up) / 2 + tilt);
  }
  return angles;
}

}  // namespace

LinerLevel slice_at(const Liners& liners, double z, double speed, double gravity) {
  const Chamber chamber{liners};
  const double half_turn = std::numbers::pi / speed;
  const double fall = gravity * half_turn * half_turn / 2, nipped = chamber.closed_gap(z);
  const double drop = slice_drop(z, chamber.bottom(), fall, nipped, [&](double at) { return chamber.open_gap(at); });
  const double area = chamber.area(z);
  return {z, area, drop, area * drop * speed / (2 * std::numbers::pi)};
}

LinerReport measure(const Liners& liners, double speed, double gravity) {
  if (!(speed > 0 && gravity > 0)) throw BadInput("the slice capacity needs a speed > 0 and a gravity > 0");
  const Chamber chamber{liners};
  LinerReport report;
  report.closed_side_setting = side_setting(liners, liners.motion.lift, true);
  report.open_side_setting = side_setting(liners, liners.motion.lift, false);
  report.throw_at_discharge = report.open_side_setting - report.closed_side_setting;
  report.volume = volume_of(chamber);
  report.nip_angle = nip_angles(liners);
  report.capacity = 0;
  report.choke_height = chamber.bottom();
  constexpr int levels = 2000;
  bool found = false;
  for (int i = 0; i <= levels; ++i) {
    const double z = chamber.bottom() + (chamber.top() - chamber.bottom()) * i / levels;
    const LinerLevel level = slice_at(liners, z, speed, gravity);
    if (z - level.drop < chamber.bottom() || (found && level.capacity >= report.capacity)) continue;
    report.capacity = level.capacity;
    report.choke_height = z;
    found = true;
  }
  return report;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/liners.hpp"

#include "core/base/errors.hpp"
#include "core/walls/section.hpp"

#include <algorithm>
#include <numbers>

namespace gyro {
namespace {

void require(bool good, const std::string& message) {
  if (!good) throw BadInput(message);
}

void check_rows(std::span<const LinerRow> rows) {
  require(rows.size() >= 2, "the liner profile has " + std::to_string(rows.size()) + " rows; at least 2 are needed");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LinerRow& row = rows[i];
    const std::string which = "row " + std::to_string(i + 1) + " of the liner profile: ";
    require(std::isfinite(row.z) && std::isfinite(row.mantle_radius) && std::isfinite(row.concave_radius),
            which + "every number must be finite");
    require(row.mantle_radius > 0 && row.concave_radius > row.mantle_radius,
            which + "the mantle must be inside the concave: 0 < mantle radius < concave radius");
    require(i == 0 || row.z > rows[i - 1].z, which + "z must be larger than in the row before");
  }
  require(rows.front().z <= 0 && rows.back().z > 0,
          "the liner profile must contain the discharge plane: its lowest z must be <= 0 and its highest > 0");
}

void check_setting(const LinerSetting& s, double top) {
  require(s.closed_side_setting > 0 && std::isfinite(s.closed_side_setting), "closed_side_setting must be > 0");
  require(s.eccentricity >= 0 && std::isfinite(s.eccentricity), "eccentricity must be >= 0");
  require(s.pivot_height > top && std::isfinite(s.pivot_height),
          "pivot_height must be above the liners, which end at " + std::to_string(top) +
              " m; pivot_height and profile are in metres: divide numbers in mm by 1000");
  require(s.collar >= 0 && std::isfinite(s.collar), "collar must be >= 0");
}

ProfileShape concave_of(std::span<const LinerRow> rows, double collar) {
  ProfileShape shape;
  for (const LinerRow& row : rows) shape.points.push_back({row.concave_radius, row.z});
  if (collar > 0) shape.points.push_back({rows.back().concave_radius, rows.back().z + collar});
  return shape;
}

/// The mantle's flank in its own frame, upwards. It begins where the lifted mantle meets the lowest
/// level: it is cut off there, or extended along its lowest piece.
Polyline flank(std::span<const LinerRow> rows, double lift) {
  const double begin = rows.front().z - lift;
  std::size_t next = 1;  // first row above the beginning, or the last row
  while (next + 1 < rows.size() && rows[next].z <= begin) ++next;
  const LinerRow &a = rows[next - 1], &b = rows[next];
  const double slope = (b.mantle_radius - a.mantle_radius) / (b.z - a.z);
  Polyline line{{a.mantle_radius + slope * (begin - a.z), begin}};
  for (std::size_t i = next; i < rows.size(); ++i) line.push_back({rows[i].mantle_radius, rows[i].z});
  return line;
}

ProfileShape mantle_of(std::span<const LinerRow> rows, double lift) {
  const Polyline line = flank(rows, lift);
  ProfileShape shape;
  shape.points.push_back({0, line.back().z + line.back().r});
  shape.points.insert(shape.points.end(), line.rbegin(), line.rend());
  shape.points.push_back({0, line.front().z});
  return shape;
}

/// The concave's lowest tenth above the discharge plane.
Polyline discharge_zone(const Liners& liners) {
  Polyline line;
  for (const LinerRow& row : liners.rows) line.push_back({row.concave_radius, row.z});
  return below(line, 0.1 * liners.rows.back().z);
}

/// The mantle's flank in the plane of both axes, tilted by the angle of sine s about the pivot.
/// s > 0: the side to which the lower end leans.
Polyline tilted_mantle(const Liners& liners, double lift, double s) {
  const double c = std::sqrt((1 - s) * (1 + s)), pivot = liners.setting.pivot_height;
  Polyline line;
  for (const ProfilePoint& p : flank(liners.rows, lift)) {
    const double along = p.z + lift - pivot;
    line.push_back({c * p.r - s * along, pivot + c * along + s * p.r});
  }
  return line;
}

}  // namespace

Liners make_liners(std::span<const LinerRow> rows, const LinerSetting& setting) {
  check_rows(rows);
  check_setting(setting, rows.back().z);
  Liners liners;
  liners.rows.assign(rows.begin(), rows.end());
  liners.setting = setting;
  liners.concave = concave_of(rows, setting.collar);
  liners.motion = {setting.eccentricity, setting.pivot_height, 0};
  liners.motion.lift = solve_lift(liners);
  liners.mantle = mantle_of(rows, liners.motion.lift);
  return liners;
}

double side_setting(const Liners& liners, double lift, bool closed_side) {
  const double s = liners.setting.eccentricity / liners.setting.pivot_height;
  const Polyline mantle = tilted_mantle(liners, lift, closed_side ? s : -s);
  const Polyline zone = discharge_zone(liners);
  return cross_each_other(mantle, zone) ? -1 : distance_between(mantle, zone);
}

double solve_lift(const Liners& liners) {
  const double wanted = liners.setting.closed_side_setting;
  const auto excess = [&](double lift) { return side_setting(liners, lift, true) - wanted; };
  // Widen a bracket [low, high] around 0: the gap is too wide at low, too narrow at high.
  const double maximum = (liners.rows.back().z - liners.rows.front().z) / 2;
  double low = 0, high = 0;
  for (double step = maximum / 64; step <= maximum && excess(low) < 0; step *= 2) low = -step;
  for (double step = maximum / 64; step <= maximum && excess(high) > 0; step *= 2) high = step;
  const double widest = side_setting(liners, low, true);
  require(widest > std::max(side_setting(liners, high, true), 0.0),
          "the mantle touches the concave at every height; use a narrower mantle or a smaller eccentricity");
  require(excess(low) >= 0 && excess(high) <= 0, "lifting the mantle gives no closed_side_setting of " +
                                                     std::to_string(wanted) + " m; it must be between " +
                                                     std::to_string(std::max(side_setting(liners, high, true), 0.0)) +
                                                     " and " + std::to_string(widest) + " m");
  while (high - low > 1e-12 * maximum) {
    const double middle = (low + high) / 2;
    (excess(middle) >= 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

TriangleMesh revolve(const ProfileShape& shape, int sectors) {
  require(sectors >= 3, "a surface of revolution needs at least 3 sectors, not " + std::to_string(sectors));
  TriangleMesh mesh;
  std::vector<Index> ring;  // first vertex of each profile point's ring
  for (const ProfilePoint& p : shape.points) {
    ring.push_back(static_cast<Index>(mesh.vertices.size()));
    const int count = p.r > 0 ? sectors : 1;
    for (int k = 0; k < count; ++k) {
      const double azimuth = 2 * std::numbers::pi * k / sectors;
      mesh.vertices.push_back({p.r * std::cos(azimuth), p.r * std::sin(azimuth), p.z});
    }
  }
  for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
    const bool from_axis = !(shape.points[i].r > 0), to_axis = !(shape.points[i + 1].r > 0);
    for (int k = 0; k < sectors; ++k) {
      const Index next = (k + 1) % sectors;
      const Index p0 = ring[i] + (from_axis ? 0 : k), p1 = ring[i] + (from_axis ? 0 : next);
      const Index q0 = ring[i + 1] + (to_axis ? 0 : k), q1 = ring[i + 1] + (to_axis ? 0 : next);
      if (!from_axis) mesh.triangles.push_back({p0, q0, p1});
      if (!to_axis) mesh.triangles.push_back({p1, q0, q1});
    }
  }
  return mesh;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/svg.hpp"
#include "app/report/text.hpp"
#include "app/report/view3d/encode.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

struct Point {
  double x, z;
};

/// Where the triangles of the walls cut the plane y = 0.
std::vector<std::pair<Point, Point>> outlines(const WallMesh& walls) {
  std::vector<std::pair<Point, Point>> lines;
  for (std::size_t t = 0; t + 2 < walls.corners.size(); t += 3) {
    std::vector<Point> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const float *a = &walls.positions[3 * walls.corners[t + k]],
                  *b = &walls.positions[3 * walls.corners[t + (k + 1) % 3]];
      if ((a[1] < 0) == (b[1] < 0)) continue;
      const double part = a[1] / (a[1] - b[1]);
      ends.push_back({a[0] + part * (b[0] - a[0]), a[2] + part * (b[2] - a[2])});
    }
    if (ends.size() == 2) lines.emplace_back(ends[0], ends[1]);
  }
  return lines;
}

/// The particles that the slice shows, from the farthest to the nearest.
std::vector<std::size_t> shown_particles(const ViewFrame& frame, double depth) {
  constexpr std::size_t most = 3000;
  std::vector<std::size_t> shown;
  const auto y = [&](std::size_t p) { return frame.spheres[4 * p + 1]; };
  for (std::size_t p = 0; p < frame.colours.size(); ++p)
    if (y(p) + frame.spheres[4 * p + 3] > 0 && y(p) < depth) shown.push_back(p);
  std::ranges::sort(shown, [&](std::size_t a, std::size_t b) { return y(a) > y(b); });
  if (shown.size() > most) shown.erase(shown.begin(), shown.end() - most);
  return shown;
}

}  // namespace

std::string slice_picture(const ViewFrame& frame) {
  constexpr double width = 560, height = 420, margin = 20;
  double low_x = INFINITY, high_x = -INFINITY, low_z = INFINITY, high_z = -INFINITY;
  const auto add = [&](double x, double z, double r) {
    low_x = std::min(low_x, x - r), high_x = std::max(high_x, x + r);
    low_z = std::min(low_z, z - r), high_z = std::max(high_z, z + r);
  };
  const auto lines = outlines(frame.walls);
  for (const auto& [a, b] : lines) add(a.x, a.z, 0), add(b.x, b.z, 0);
  if (lines.empty())
    for (std::size_t p = 0; p < frame.colours.size(); ++p)
      add(frame.spheres[4 * p], frame.spheres[4 * p + 2], frame.spheres[4 * p + 3]);
  if (!(high_x > low_x) || !(high_z > low_z)) return "";
  const double scale = std::min((width - 2 * margin) / (high_x - low_x), (height - 2 * margin) / (high_z - low_z));
  const auto x_at = [&](double x) { return width / 2 + scale * (x - (low_x + high_x) / 2); };
  const auto z_at = [&](double z) { return height / 2 - scale * (z - (low_z + high_z) / 2); };
  std::string svg;
  for (const std::size_t p : shown_particles(frame, 0.3 * std::max(high_x - low_x, high_z - low_z))) {
    const float* s = &frame.spheres[4 * p];
    svg += "<circle class=\"p p" + std::to_string(frame.colours[p]) + "\"" + attribute("cx", x_at(s[0])) +
           attribute("cy", z_at(s[2])) + attribute("r", scale * s[3]) + "/>";
  }
  std::string path;
  for (const auto& [a, b] : lines)
    path += "M" + place(x_at(a.x)) + " " + place(z_at(a.z)) + "L" + place(x_at(b.x)) + " " + place(z_at(b.z));
  svg += "<path class=\"wall\" d=\"" + path + "\"/>";
  return svg_picture(width, height, "Slice through the axis at " + quantity(frame.time, "s"), svg);
}

}  // namespace gyro::report

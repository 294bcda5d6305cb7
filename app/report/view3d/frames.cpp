// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/view3d/frames.hpp"

#include "core/base/errors.hpp"
#include "io/run/poly_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace gyro::report {
namespace {

namespace fs = std::filesystem;

template <class T>
const std::vector<T>* field(const std::vector<PolyArray>& fields, const char* name) {
  const auto found = std::ranges::find(fields, name, &PolyArray::name);
  return found == fields.end() ? nullptr : std::get_if<std::vector<T>>(&found->values);
}

/// The snapshots of particles in order.
std::vector<fs::path> snapshots_of(const fs::path& run) {
  std::vector<fs::path> files;
  const fs::path folder = run / "snapshots";
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("particles_") && name.ends_with(".vtp")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Colour of a fragment by its number. The numbers of neighbours differ by little: their bits are mixed.
std::uint8_t colour_of(std::uint32_t fragment) {
  constexpr std::uint32_t colours = 12;
  std::uint32_t h = fragment * 2654435761u;
  h ^= h >> 15;
  return static_cast<std::uint8_t>(1 + h % colours);
}

/// Order of particles: larger ones first, equal ones mixed, so that a part of them is an even sample.
std::vector<std::size_t> largest_first(const std::vector<float>& radius) {
  std::vector<std::size_t> order(radius.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    const auto mixed = [](std::size_t k) { return static_cast<std::uint32_t>(k) * 2654435761u; };
    return std::tuple(-radius[a], mixed(a)) < std::tuple(-radius[b], mixed(b));
  });
  return order;
}

void add_particles(const PolyData& data, std::size_t limit, const fs::path& file, ViewFrame& frame) {
  const auto* radius = field<float>(data.point_fields, "radius");
  const auto* fragment = field<std::uint32_t>(data.point_fields, "fragment");
  const std::size_t n = data.positions.size() / 3;
  if (!radius || !fragment || radius->size() != n || fragment->size() != n)
    throw BadInput(file.string() + ": has no radius or fragment of each particle; give a run of gyrosim");
  std::unordered_map<std::uint32_t, int> members;
  for (const std::uint32_t f : *fragment) ++members[f];
  frame.particles = n;
  std::vector<std::size_t> order = largest_first(*radius);
  if (order.size() > limit) order.resize(limit);
  for (const std::size_t p : order) {
    const float* at = &data.positions[3 * p];
    frame.spheres.insert(frame.spheres.end(), {at[0], at[1], at[2], (*radius)[p]});
    frame.colours.push_back(members[(*fragment)[p]] > 1 ? colour_of((*fragment)[p]) : std::uint8_t{0});
  }
}

/// Corners and triangles of one wall.
WallMesh wall_of(const PolyData& data, std::int32_t wall, const std::vector<std::int32_t>& wall_of_triangle) {
  WallMesh mesh;
  std::unordered_map<std::int32_t, std::uint32_t> places;
  const std::size_t corners = data.positions.size() / 3;
  for (std::size_t t = 0; t < wall_of_triangle.size(); ++t) {
    if (wall_of_triangle[t] != wall || 3 * t + 2 >= data.triangles.points.size()) continue;
    for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
      const std::int32_t corner = data.triangles.points[k];
      if (corner < 0 || static_cast<std::size_t>(corner) >= corners) throw BadInput("a triangle has no corner");
      const auto [place, added] = places.try_emplace(corner, static_cast<std::uint32_t>(mesh.positions.size() / 3));
      if (added)
        mesh.positions.insert(mesh.positions.end(), &data.positions[3 * static_cast<std::size_t>(corner)],
                              &data.positions[3 * static_cast<std::size_t>(corner)] + 3);
      mesh.corners.push_back(place->second);
    }
  }
  return mesh;
}

struct Box {
  std::array<float, 3> low{}, high{};
  bool empty = true;
  void add(const float* p, float radius) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = empty ? p[k] - radius : std::min(low[k], p[k] - radius);
      high[k] = empty ? p[k] + radius : std::max(high[k], p[k] + radius);
    }
    empty = false;
  }
  float extent() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
};

/// A plane has no end; a snapshot has a square of it that says nothing about the scene. Draws a square about the rock.
void fit_plane(WallMesh& mesh, const Box& rock) {
  if (rock.empty || mesh.positions.size() < 12) return;
  std::array<double, 3> a{}, b{}, corner{};
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = mesh.positions[k];
    a[k] = mesh.positions[3 + k] - corner[k];
    b[k] = mesh.positions[6 + k] - corner[k];
  }
  const auto dot = [](const auto& u, const auto& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  const double aa = dot(a, a), across = dot(a, b) / aa;
  for (std::size_t k = 0; k < 3; ++k) b[k] -= across * a[k];
  const double bb = dot(b, b), half = 0.6 * rock.extent();
  if (!(aa > 0) || !(bb > 0)) return;
  std::array<double, 3> middle{}, from{};
  for (std::size_t k = 0; k < 3; ++k) from[k] = (rock.low[k] + rock.high[k]) / 2 - corner[k];
  for (std::size_t k = 0; k < 3; ++k) middle[k] = corner[k] + dot(from, a) / aa * a[k] + dot(from, b) / bb * b[k];
  mesh = {};
  for (const auto& [i, j] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
    for (std::size_t k = 0; k < 3; ++k)
      mesh.positions.push_back(
          static_cast<float>(middle[k] + half * (i * a[k] / std::sqrt(aa) + j * b[k] / std::sqrt(bb))));
  mesh.corners = {0, 1, 2, 0, 2, 3};
}

double mean_distance(const WallMesh& mesh) {
  double sum = 0;
  for (std::size_t k = 0; k + 2 < mesh.positions.size(); k += 3)
    sum += std::hypot(mesh.positions[k], mesh.positions[k + 1]);
  return sum / std::max<double>(1, static_cast<double>(mesh.positions.size()) / 3);
}

void append(WallMesh& to, const WallMesh& mesh, bool cut) {
  const auto first = static_cast<std::uint32_t>(to.positions.size() / 3);
  to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const std::uint32_t corner : mesh.corners) to.corners.push_back(corner + first);
  to.cut.insert(to.cut.end(), mesh.positions.size() / 3, cut ? 1 : 0);
}

using Walls = std::map<std::int32_t, WallMesh>;

/// Adds the walls of a snapshot; a missing file has none.
void read_walls(const fs::path& file, Walls& walls) {
  if (!fs::exists(file)) return;
  const PolyData data = read_vtp(file);
  const auto* wall = field<std::int32_t>(data.cell_fields, "wall");
  if (!wall) return;
  std::vector<std::int32_t> names(*wall);
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  for (const std::int32_t name : names) walls[name] = wall_of(data, name, *wall);
}

/// The walls of a frame with few triangles. All but the innermost one around the axis, the mantle, are cut open.
WallMesh joined(Walls walls, const ViewFrame& frame, std::size_t cells) {
  constexpr std::size_t plane = 6;  // corners of its two triangles
  Box rock, machine;
  for (std::size_t p = 0; p + 3 < frame.spheres.size(); p += 4) rock.add(&frame.spheres[p], frame.spheres[p + 3]);
  std::int32_t inner = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (auto& [name, mesh] : walls) {
    if (mesh.corners.size() <= plane) {
      fit_plane(mesh, rock);
      continue;
    }
    if (const double distance = mean_distance(mesh); distance < nearest) nearest = distance, inner = name;
    for (std::size_t k = 0; k + 2 < mesh.positions.size(); k += 3) machine.add(&mesh.positions[k], 0);
  }
  WallMesh all;
  for (const auto& [name, mesh] : walls) {
    const bool large = mesh.corners.size() > 3000;
    append(all, large ? simplified(mesh, machine.extent() / static_cast<double>(cells)) : mesh,
           name != inner && mesh.corners.size() > plane);
  }
  return all;
}

}  // namespace

std::vector<std::size_t> chosen_frames(std::size_t frames, std::size_t limit) {
  std::vector<std::size_t> chosen;
  const std::size_t count = std::min(frames, limit);
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(count == 1 ? frames - 1 : k * (frames - 1) / (count - 1));
  return chosen;
}

WallMesh simplified(const WallMesh& mesh, double cell) {
  constexpr double sectors = 60;  // of a turn
  WallMesh few;
  std::map<std::tuple<long, long, long>, std::uint32_t> cells;
  std::vector<std::uint32_t> place;
  std::vector<double> sum, members;
  for (std::size_t k = 0; k + 2 < mesh.positions.size(); k += 3) {
    const float* p = &mesh.positions[k];
    const long sector = std::lround(std::atan2(p[1], p[0]) / (2 * std::numbers::pi) * sectors);
    const std::tuple key{std::lround(p[2] / cell), (sector + 60) % 60, std::lround(std::hypot(p[0], p[1]) / cell)};
    const auto [found, added] = cells.try_emplace(key, static_cast<std::uint32_t>(members.size()));
    if (added) sum.insert(sum.end(), {0, 0, 0}), members.push_back(0);
    for (std::size_t c = 0; c < 3; ++c) sum[3 * found->second + c] += p[c];
    ++members[found->second];
    place.push_back(found->second);
  }
  for (std::size_t k = 0; k < sum.size(); ++k) few.positions.push_back(static_cast<float>(sum[k] / members[k / 3]));
  for (std::size_t t = 0; t + 2 < mesh.corners.size(); t += 3) {
    const std::uint32_t a = place[mesh.corners[t]], b = place[mesh.corners[t + 1]], c = place[mesh.corners[t + 2]];
    if (a != b && b != c && c != a) few.corners.insert(few.corners.end(), {a, b, c});
  }
  return few;
}

std::vector<ViewFrame> read_frames(const fs::path& run, const ViewLimits& limits) {
  const std::vector<fs::path> files = snapshots_of(run);
  std::vector<ViewFrame> frames;
  Walls fixed;
  if (!files.empty()) read_walls(run / "snapshots" / "walls_fixed.vtp", fixed);
  for (const std::size_t k : chosen_frames(files.size(), limits.frames)) {
    const PolyData data = read_vtp(files[k]);
    ViewFrame frame;
    frame.time = data.time.value_or(0);
    add_particles(data, limits.particles, files[k], frame);
    Walls walls = fixed;
    const std::string number = files[k].filename().string().substr(std::string("particles").size());
    read_walls(run / "snapshots" / ("walls" + number), walls);
    frame.walls = joined(std::move(walls), frame, limits.wall_cells);
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace gyro::report

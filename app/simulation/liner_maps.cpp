// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/liner_maps.hpp"

#include <numbers>

namespace gyro {
namespace {

double friction_of(const Scene& scene, const Wall& wall) {
  const auto count = static_cast<Index>(scene.materials.size());
  return scene.pairs[static_cast<std::size_t>(scene.rock_material * count + wall.material)].friction;
}

std::vector<double> edges(double low, double high, int count) {
  std::vector<double> result;
  for (int k = 0; k <= count; ++k) result.push_back(low + (high - low) * k / count);
  return result;
}

/// Mean pressure from impulses: over an area and a time.
std::vector<double> pressure(const std::vector<double>& impulse, const std::vector<double>& area, double time) {
  std::vector<double> result(impulse.size(), 0.0);
  for (std::size_t k = 0; k < impulse.size(); ++k)
    if (area[k] > 0 && time > 0) result[k] = impulse[k] / (area[k] * time);
  return result;
}

}  // namespace

LinerMaps::LinerMaps(const Case& input, const Assembly& assembly) : asked_(input.output.liners) {
  if (!asked_) return;
  for (const WallPicture& picture : assembly.pictures) {
    const Scene& scene = assembly.setup.scene;
    const Wall& wall = scene.walls[static_cast<std::size_t>(picture.wall)];
    if (std::holds_alternative<PlaneShape>(wall.shape)) continue;
    maps_.push_back(
        {picture.wall, wall.name, friction_of(scene, wall), SurfaceMap(picture.mesh, asked_->rows, asked_->sectors)});
  }
}

std::vector<LinerMap> LinerMaps::content() const {
  std::vector<LinerMap> all;
  for (const Mapped& m : maps_) {
    const UnrolledGrid& grid = m.map.grid();
    LinerMap liner{m.name, grid.cells()};
    liner.heights = edges(grid.low, grid.high, grid.rows);
    liner.azimuths = edges(0, 2 * std::numbers::pi, grid.sectors);
    liner.area = m.map.cell_area();
    for (const WallTriangle& t : m.map.triangles())
      for (const Vec3d& corner : {t.a, t.b, t.c})
        liner.corners.insert(liner.corners.end(), {corner.x, corner.y, corner.z});
    liner.wear = asked_->wear_coefficient.has_value();
    all.push_back(std::move(liner));
  }
  return all;
}

void LinerMaps::take(const std::vector<WallImpulse>& impulses, double time, ResultsFile& results) {
  if (!asked_) return;
  for (const WallImpulse& impulse : impulses)
    for (Mapped& m : maps_)
      if (m.wall == impulse.wall) m.map.add(impulse);
  time_ = time;
  if (time_ - written_ >= asked_->interval * (1 - 1e-9)) write(results);
}

void LinerMaps::save(SavedState& to) const {
  if (!asked_) return;
  to.put("liners/times", std::vector<double>{time_, written_});
  for (const Mapped& m : maps_) {
    const std::string group = "liners/" + m.name;
    to.put(group + "/triangle_impulse", m.map.by_triangle().impulse);
    to.put(group + "/triangle_work", m.map.by_triangle().work);
    to.put(group + "/cell_impulse", m.map.cells().impulse);
    to.put(group + "/cell_work", m.map.cells().work);
  }
}

void LinerMaps::restore(const SavedState& from) {
  if (!asked_) return;
  const std::vector<double> times = from.get<double>("liners/times", 2);
  time_ = times[0];
  written_ = times[1];
  for (Mapped& m : maps_) {
    const std::string group = "liners/" + m.name;
    const auto sums = [&](const std::string& pieces, std::size_t count) {
      SurfaceSums found(count);
      found.impulse = from.get<double>(group + "/" + pieces + "_impulse", count);
      found.work = from.get<double>(group + "/" + pieces + "_work", count);
      return found;
    };
    m.map.restore(sums("triangle", m.map.by_triangle().impulse.size()), sums("cell", m.map.cells().impulse.size()));
  }
}

void LinerMaps::write(ResultsFile& results) {
  for (Mapped& m : maps_) {
    const SurfaceSums cells = m.map.take_cells();
    results.append_liner(m.name, time_, pressure(cells.impulse, m.map.cell_area(), time_ - written_), cells.work);
  }
  written_ = time_;
}

void LinerMaps::close(ResultsFile& results) {
  if (!asked_) return;
  if (time_ > written_) write(results);
  for (const Mapped& m : maps_) {
    const SurfaceSums& sums = m.map.by_triangle();
    std::vector<double> wear;
    for (std::size_t t = 0; t < sums.work.size() && asked_->wear_coefficient; ++t)
      wear.push_back(wear_depth(*asked_->wear_coefficient, sums.work[t], m.friction, m.map.triangle_area()[t]));
    results.append_triangles(m.name, time_, pressure(sums.impulse, m.map.triangle_area(), time_), sums.work, wear);
  }
}

}  // namespace gyro

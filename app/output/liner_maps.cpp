// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/liner_maps.hpp"

#include "core/base/errors.hpp"

#include <numbers>
#include <utility>

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

/// Mean pressure from impulses over an area and a time [Pa].
std::vector<double> pressure(const std::vector<double>& impulse, const std::vector<double>& area, double time) {
  std::vector<double> result(impulse.size(), 0.0);
  for (std::size_t k = 0; k < impulse.size(); ++k)
    if (area[k] > 0 && time > 0) result[k] = impulse[k] / (area[k] * time);
  return result;
}

/// Sums of a map, as a checkpoint keeps them.
struct SavedSums {
  std::vector<double> triangle_impulse, triangle_work, cell_impulse, cell_work;

  template <class F, class... S>
  static constexpr void for_each_field(F&& f, S&... s) {
    f("triangle_impulse", s.triangle_impulse...);
    f("triangle_work", s.triangle_work...);
    f("cell_impulse", s.cell_impulse...);
    f("cell_work", s.cell_work...);
  }
};

SurfaceSums sums_of(std::vector<double> impulse, std::vector<double> work, std::size_t pieces) {
  if (impulse.size() != pieces || work.size() != pieces)
    throw BadInput("has liner maps of another size; resume with the same output.liners");
  SurfaceSums sums(0);
  sums.impulse = std::move(impulse);
  sums.work = std::move(work);
  return sums;
}

LinerShape shape_of(const SurfaceMap& map) {
  const UnrolledGrid& grid = map.grid();
  LinerShape shape;
  shape.heights = edges(grid.low, grid.high, grid.rows);
  shape.azimuths = edges(0, 2 * std::numbers::pi, grid.sectors);
  shape.area = map.cell_area();
  for (const WallTriangle& t : map.triangles())
    for (const Vec3d& corner : {t.a, t.b, t.c})
      shape.corners.insert(shape.corners.end(), {corner.x, corner.y, corner.z});
  return shape;
}

}  // namespace

LinerMaps::LinerMaps(const Case& input, const Assembly& assembly) : asked_(input.output.liners) {
  if (!asked_) return;
  form_.liners = true;
  form_.wear = asked_->wear_coefficient.has_value();
  for (const WallPicture& picture : assembly.pictures) {
    const Scene& scene = assembly.setup.scene;
    const Wall& wall = scene.walls[static_cast<std::size_t>(picture.wall)];
    if (std::holds_alternative<PlaneShape>(wall.shape)) continue;
    SurfaceMap map(picture.mesh, asked_->rows, asked_->sectors);
    const auto table = [&](const Table<LinerReading>& maps, std::size_t pieces) {
      return TableWriter(maps, form_, pieces, fill_in(std::string(maps.group), "<wall>", wall.name));
    };
    TableWriter cells = table(liner_cells_table(), map.cell_area().size());
    TableWriter triangles = table(liner_triangles_table(), map.triangle_area().size());
    maps_.push_back(
        {picture.wall, wall.name, friction_of(scene, wall), std::move(map), std::move(cells), std::move(triangles)});
  }
}

void LinerMaps::declare(ResultsContent& content) const {
  for (const Mapped& m : maps_) {
    content.groups.push_back(m.cells.declaration());
    content.groups.push_back(m.triangles.declaration());
    for (FixedNumbers& fixed : fixed_numbers(liner_shape_table(), form_, shape_of(m.map), m.cells.declaration().name))
      content.fixed.push_back(std::move(fixed));
  }
}

void LinerMaps::take(const std::vector<WallImpulse>& impulses, double time, ResultsFile& results) {
  if (!asked_) return;
  for (const WallImpulse& impulse : impulses)
    for (Mapped& m : maps_)
      if (m.wall == impulse.wall) m.map.add(impulse);
  times_.now = time;
  if (times_.now - times_.written >= asked_->interval * (1 - 1e-9)) write(results);
}

void LinerMaps::save(SavedState& to) const {
  if (!asked_) return;
  to.put_one("liner_times", times_);
  for (const Mapped& m : maps_)
    to.put_one("liners/" + m.name, SavedSums{m.map.by_triangle().impulse, m.map.by_triangle().work,
                                             m.map.cells().impulse, m.map.cells().work});
}

void LinerMaps::restore(const SavedState& from) {
  if (!asked_) return;
  times_ = from.get_one<Times>("liner_times");
  for (Mapped& m : maps_) {
    auto saved = from.get_one<SavedSums>("liners/" + m.name);
    m.map.restore(
        sums_of(std::move(saved.triangle_impulse), std::move(saved.triangle_work), m.map.triangle_area().size()),
        sums_of(std::move(saved.cell_impulse), std::move(saved.cell_work), m.map.cell_area().size()));
  }
}

void LinerMaps::write(ResultsFile& results) {
  for (Mapped& m : maps_) {
    SurfaceSums cells = m.map.take_cells();
    m.cells.append(results, {.time = times_.now,
                             .pressure = pressure(cells.impulse, m.map.cell_area(), times_.now - times_.written),
                             .work = std::move(cells.work)});
  }
  times_.written = times_.now;
}

void LinerMaps::close(ResultsFile& results) {
  if (!asked_) return;
  if (times_.now > times_.written) write(results);
  for (Mapped& m : maps_) {
    WallLoads loads = loads_of(m);
    m.triangles.append(results,
                       {times_.now, std::move(loads.pressure), std::move(loads.sliding_work), std::move(loads.wear)});
  }
}

WallLoads LinerMaps::loads_of(const Mapped& m) const {
  const SurfaceSums& sums = m.map.by_triangle();
  WallLoads loads{pressure(sums.impulse, m.map.triangle_area(), times_.now), sums.work, {}};
  for (std::size_t t = 0; t < sums.work.size() && asked_->wear_coefficient; ++t)
    loads.wear.push_back(wear_depth(*asked_->wear_coefficient, sums.work[t], m.friction, m.map.triangle_area()[t]));
  return loads;
}

std::optional<WallLoads> LinerMaps::loads(Index wall) const {
  for (const Mapped& m : maps_)
    if (m.wall == wall) return loads_of(m);
  return {};
}

}  // namespace gyro

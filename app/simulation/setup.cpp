// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/setup.hpp"

#include "core/scene/wall_motion.hpp"

#include <cmath>

namespace gyro {
namespace {

void require(bool good, SetupPart part, const std::string& problem) {
  if (!good) throw BadSetup(part, problem);
}

void check_materials(const Scene& scene) {
  const std::size_t count = scene.materials.size();
  const auto known = [&](Index material) { return material >= 0 && static_cast<std::size_t>(material) < count; };
  require(known(scene.rock_material), SetupPart::scene, "rock_material is not one of the scene's materials; name one");
  require(scene.pairs.size() == count * count, SetupPart::scene,
          "the scene has " + std::to_string(count) + " materials and " + std::to_string(scene.pairs.size()) +
              " pairs; pairs must be a square table of " + std::to_string(count * count));
  for (const Material& m : scene.materials)
    require(
        m.density > 0 && m.shear_modulus > 0 && m.poisson_ratio > -1 && m.poisson_ratio <= 0.5, SetupPart::scene,
        "material " + m.name + " is out of range; density and shear modulus must be > 0, Poisson's ratio -1 to 0.5");
  for (const Wall& wall : scene.walls)
    require(known(wall.material), SetupPart::scene,
            "the material of wall " + wall.name + " is not one of the scene's; give its number");
}

}  // namespace

Index gyrating_wall(const Scene& scene) {
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    if (std::holds_alternative<GyrationMotion>(scene.walls[w].motion)) return static_cast<Index>(w);
  return none;
}

void check_scene(const Scene& scene) {
  check_materials(scene);
  try {
    for (const Wall& wall : scene.walls) check_motion(wall);
  } catch (const BadInput& problem) {
    throw BadSetup(SetupPart::scene, problem.what());
  }
}

void check_setup(const Setup& setup) {
  const Scene& scene = setup.scene;
  check_scene(scene);
  require(std::isfinite(scene.dt) && scene.dt > 0, SetupPart::step, "the time step is not > 0; set_step() chooses one");
  require(scene.substeps >= 1, SetupPart::step, "substeps is below 1; it must be at least 1");
  require(setup.steps_per_window >= 1, SetupPart::step, "steps_per_window is below 1; it must be at least 1");
  require(setup.inspection_interval >= 0, SetupPart::step, "inspection_interval is negative; it must be >= 0");
  require(setup.max_energy_residual > 0, SetupPart::step, "max_energy_residual is not > 0; a usual value is 0.05");
}

}  // namespace gyro

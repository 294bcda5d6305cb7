// SPDX-License-Identifier: GPL-3.0-or-later
// A bonded block between closing plates, compared with LAMMPS: cases/verification/pressed_block/README.md.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/groups/pressed_block_table.hpp"
#include "app/verify/verification.hpp"
#include "core/rocks/bonds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;

constexpr double radius = 0.01, bond_share = 0.5, gap = 0.15, speed = 1, dt = 5e-7;  // [m], [-], [-], [m/s], [s]

/// Spheres on a face-centred cubic lattice with random displacements of up to 0.05 R along each axis; on the lattice
/// neighbours are 2.15 R apart.
std::vector<Vec3d> centres() {
  constexpr Vec3<int> cells{6, 6, 8};
  constexpr Vec3d corners[] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  const double side = std::numbers::sqrt2 * 2.15 * radius;
  std::vector<Vec3d> found;
  for (int k = 0; k < cells.z; ++k)
    for (int j = 0; j < cells.y; ++j)
      for (int i = 0; i < cells.x; ++i)
        for (const Vec3d& corner : corners)
          found.push_back(side * (Vec3d{1.0 * i, 1.0 * j, 1.0 * k} + corner) +
                          0.05 * radius * random_vector(found.size(), 0));
  return found;
}

NewRock block() {
  const std::vector<Vec3d> places = centres();
  const std::vector<double> radii(places.size(), radius);
  std::vector<TemplateBond> bonds = make_bonds(places, radii, {gap, RelativeBondRadius{bond_share}});
  NewRock rock;
  rock.id = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
    rock.particles.push_back({static_cast<ParticleId>(k), places[k], {0, 0, 0}, {0, 0, 0}, radius, rock_density});
  rock.colour_begin = colour_bonds(bonds, static_cast<Index>(places.size()));
  for (const TemplateBond& b : bonds) rock.bonds.push_back({b.i, b.j, b.length, b.radius, 1});
  return rock;
}

/// Frictionless plates of the block's material that touch its outermost spheres. Bonds fail by tension and bending
/// only, because LAMMPS has the same criterion for these.
Scene between_plates(const NewRock& rock, double step) {
  const auto [low, high] = std::ranges::minmax_element(rock.particles, {}, [](const auto& p) { return p.position.z; });
  const Material stone = elastic(1.5039e9, 0.35, rock_density);
  Scene scene = scene_of(stone, stone, {0, 0.325, 0}, step);
  scene.bonds = paper_bonds();
  scene.bonds->tensile_strength = 50e6;
  scene.bonds->shear_strength = 1e15;
  scene.walls = {{"bottom", PlaneShape{{0, 0, low->position.z - radius}, {0, 0, 1}}, LinearMotion{{0, 0, speed}}, 1},
                 {"top", PlaneShape{{0, 0, high->position.z + radius}, {0, 0, -1}}, LinearMotion{{0, 0, -speed}}, 1}};
  return scene;
}

/// The quantities of the table, measured in the engine.
PressedBlock measured(Dem& dem, double time) {
  PressedBlock row{.time = time};
  const ParticleSnapshot s = dem.particles();
  for (std::size_t k = 0; k < s.size(); ++k) {
    row.translation += 0.5 * s.mass[k] * norm2(s.velocity[k]);
    row.rotation += 0.2 * s.mass[k] * s.radius[k] * s.radius[k] * norm2(s.angular_velocity[k]);
  }
  const double spring = BondStiffness(paper_bonds(), bond_share * radius).normal;
  for (const double force : dem.bonds().normal_force) row.stretch += 0.5 * force * force / spring;
  const std::vector<WallLoad> loads = dem.wall_loads();
  row.bottom = -loads[0].force.z;
  row.top = loads[1].force.z;
  row.bonds = static_cast<double>(dem.counts().bonds_intact);
  return row;
}

/// Relative tolerances of the two kinetic energies, and (load) of the energy of stretched bonds and the plate forces
/// [-].
struct Tolerances {
  double translation, rotation, load;
};

/// Tolerances while all bonds are intact, and after the first two have broken. Both programs take the same steps.
///
/// While all bonds are intact, the programs differ by at most 6e-5, and by 5e-5 at a quarter of the step. Afterwards
/// the differences depend on the step in which a bond breaks: they are up to 7.9e-4 (translation), 4.2e-3 (rotation)
/// and 2.2e-4 (load), and 2.7e-4, 9e-4 and 1.1e-4 at a quarter of the step.
constexpr Tolerances intact{2e-4, 2e-4, 2e-4}, broken{2e-3, 1e-2, 1e-3};

void record(Recorder& out, const PressedBlock& got, const PressedBlock& lammps, const Tolerances& tolerance) {
  const auto [translation, rotation, load] = tolerance;
  const std::string at = "at-" + std::to_string(std::lround(lammps.time * 1e6)) + "-us-", code = "LAMMPS 22Jul2025";
  out.relative(at + "translation", got.translation, lammps.translation, {translation, translation}, code);
  out.relative(at + "rotation", got.rotation, lammps.rotation, {rotation, rotation}, code);
  out.relative(at + "stretch", got.stretch, lammps.stretch, {load, load}, code);
  out.relative(at + "bottom-force", got.bottom, lammps.bottom, {load, load}, code);
  out.relative(at + "top-force", got.top, lammps.top, {load, load}, code);
  out.absolute(at + "bonds", got.bonds, lammps.bonds, {0, 0}, code);
}

/// Kinetic energies, energy of stretched bonds and forces on the plates, compared with the LAMMPS bond style
/// bpm/rotational.
void pressed(Recorder& out) {
  const NewRock rock = block();
  Stage stage(between_plates(rock, dt), out.precision());
  stage.insert({rock});
  double last = 0;
  for (const PressedBlock& row : pressed_block_table()) {
    stage.advance(static_cast<int>(std::llround((row.time - last) / dt)));
    last = row.time;
    const bool all = row.bonds == static_cast<double>(rock.bonds.size());
    record(out, measured(stage.dem(), row.time), row, all ? intact : broken);
  }
}

}  // namespace

std::vector<Verification> pressed_block_cases() {
  return {{"pressed-block/between-plates", pressed}};
}

}  // namespace gyro::verify

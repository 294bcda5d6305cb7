// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/assembly.hpp"

#include "app/simulation/bad_key.hpp"
#include "app/simulation/start_check.hpp"
#include "app/simulation/start_state.hpp"
#include "core/base/errors.hpp"
#include "io/mesh/mesh_file.hpp"
#include "io/rocks/library_cache.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gyro {
namespace {

constexpr int picture_sectors = 240;

TriangleMesh plane_picture(const PlaneShape& plane, double half) {
  const Vec3d helper = std::abs(plane.normal.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  const Vec3d a0 = cross(plane.normal, helper);
  const Vec3d a = (half / norm(a0)) * a0, b = cross(plane.normal, a);
  return {{plane.point - a - b, plane.point + a - b, plane.point + a + b, plane.point - a + b}, {{0, 1, 2}, {0, 2, 3}}};
}

/// Adds a wall's shape to the scene and its picture to the assembly.
void add_wall(Assembly& out, const CaseWall& wall) {
  Wall made;
  made.name = wall.name;
  made.motion = wall.motion;
  made.material = wall.material;
  const Index number = static_cast<Index>(out.scene.walls.size());
  if (const auto* plane = std::get_if<PlaneShape>(&wall.shape)) {
    made.shape = *plane;
    out.pictures.push_back({plane_picture(*plane, 0.5), number});
  } else if (const auto* file = std::get_if<MeshFile>(&wall.shape)) {
    RepairedMesh read = read_mesh(file->path.string());
    for (const std::string& note : read.notes) out.notes.push_back("wall " + wall.name + ": " + note);
    out.pictures.push_back({read.mesh, number});
    made.shape = std::move(read.mesh);
  } else {
    const bool mantle = std::get<ProfileLiner>(wall.shape).mantle;
    const ProfileShape& shape = mantle ? out.liners->mantle : out.liners->concave;
    made.shape = shape;
    if (std::holds_alternative<GyrationMotion>(made.motion)) made.motion = out.liners->motion;
    out.pictures.push_back({revolve(shape, picture_sectors), number});
  }
  if (std::holds_alternative<GyrationMotion>(made.motion) && out.gyrating == none) out.gyrating = number;
  out.scene.walls.push_back(std::move(made));
}

/// Liners given as meshes: lifts the gyrating ones so that the asked setting is met.
void set_meshes(Assembly& out, double closed_side_setting) {
  if (out.gyrating == none || out.liners) return;
  const std::optional<MeshLiners> liners = mesh_liners(out.scene);
  if (!liners) {
    out.notes.push_back(
        "no fixed mesh is called concave: closed_side_setting is not imposed, the mantle stays as drawn");
    return;
  }
  const MeshGap gap(liners->mantle, liners->concave, liners->motion);
  const double lift = gap.solve_lift(closed_side_setting);
  for (Wall& wall : out.scene.walls)
    if (auto* motion = std::get_if<GyrationMotion>(&wall.motion)) motion->lift = lift;
  const MeshSetting setting = gap.measure(lift);
  char note[160];
  std::snprintf(note, sizeof note, "mantle lifted by %.2f mm: closed side setting %.2f mm, open %.2f mm", lift * 1e3,
                setting.closed * 1e3, setting.open * 1e3);
  out.notes.push_back(note);
}

/// A drive that moves nothing is a mistake; a mantle that nothing drives may be meant.
void check_crusher(const Case& input, Assembly& out) {
  const bool driven = input.drivetrain || input.drivetrain_fmu;
  if (driven && out.gyrating == none)
    throw BadKey("drivetrain",
                 "the drive moves nothing, no wall gyrates; walls.mantle with motion: gyration is accepted, "
                 "or crusher.profile");
  if (input.crusher && !driven) out.notes.push_back("the case has no drivetrain: the mantle stands still");
}

/// Says what is not a whole number of windows: a run looks at itself at the ends of windows only.
void note_windows(Assembly& out, const Case& input) {
  const auto note = [&](const char* key, double time) {
    const double windows = time / input.coupling_interval;
    if (std::abs(windows - std::round(windows)) < 1e-6 * windows) return;
    char text[200];
    std::snprintf(text, sizeof text,
                  "%s of %g s is not a whole number of coupling intervals of %g s: taken at the end "
                  "of the interval in which it lies",
                  key, time, input.coupling_interval);
    out.notes.push_back(text);
  };
  note("time.duration", input.time.duration);
  note("output.series", input.output.series);
}

LibraryRecipe recipe_of(const Case& input, const Scene& scene) {
  const CaseRocks& rocks = *input.rocks;
  LibraryRecipe recipe;
  recipe.shapes = recipe_shapes(rocks.shapes);
  recipe.sizes = rocks.sizes;
  recipe.samples = rocks.samples;
  recipe.fill = rocks.fill;
  recipe.rock_density = scene.materials[static_cast<std::size_t>(scene.rock_material)].density;
  recipe.compensated = rocks.density_compensated;
  if (input.bonds) {
    recipe.bond_rule = input.bonds->rule;
    recipe.bond_parameters = *scene.bonds;
  }
  recipe.bed = bed_contacts(scene);
  recipe.seed = input.identity.seed;
  return recipe;
}

/// Twice the largest extent of a rock of the start state, by the box around it [m].
double twice_largest(std::span<const NewRock> rocks) {
  double largest = 0;
  for (const NewRock& rock : rocks)
    for (const NewParticle& p : rock.particles)
      largest = std::max(largest, norm(p.position - rock.particles.front().position) + 2 * p.radius);
  return 2 * largest;
}

double largest_rock(const RockLibrary& library) {
  double largest = 0;
  for (const RockTemplate& rock : library.rocks) largest = std::max(largest, 2 * rock.bounding_radius);
  return largest;
}

/// Where rock appears: the chamber for the initial charge, the opening above a wall for the rest.
void set_regions(FeedPlan& plan, const CaseFeed& feed, const Assembly& out) {
  if (feed.above == none) return;
  const Wall& outer = out.scene.walls[static_cast<std::size_t>(feed.above)];
  if (plan.initial > 0) {
    const RadiusByHeight radius(outer, RadiusByHeight::Side::outer);
    ChamberRegion chamber{feed.above, out.gyrating, std::max(0.0, radius.low()), radius.high()};
    if (feed.initial_top) chamber.high = *feed.initial_top;
    plan.charge = chamber;
  }
  if (plan.rate > 0 || plan.batch > 0) plan.entry = opening_above(outer, 2 * largest_rock(out.library));
}

FeedPlan feed_plan(const Case& input, const Assembly& out) {
  const CaseFeed& feed = *input.feed;
  FeedPlan plan;
  plan.initial = feed.initial;
  plan.batch = feed.mass.value_or(0);
  plan.rate = feed.rate;
  plan.start = feed.start;
  plan.seed = input.identity.seed;
  set_regions(plan, feed, out);
  Vec3d at = feed.at;
  for (int k = 0; k < feed.rocks; ++k) {
    const Index kind = static_cast<Index>(k % static_cast<int>(out.library.rocks.size()));
    plan.fixed.push_back({kind, at, {1, 0, 0, 0}});
    at.z += 2.1 * largest_rock(out.library) / 2;
  }
  for (const NewRock& rock : out.start) {
    plan.first_rock = std::max(plan.first_rock, static_cast<RockId>(rock.id + 1));
    for (const NewParticle& p : rock.particles) plan.first_particle = std::max(plan.first_particle, p.id + 1);
  }
  return plan;
}

}  // namespace

BondStrength bond_strength(const Case& input) {
  if (!input.bonds || !input.bonds->scatter) return {};
  return [scatter = *input.bonds->scatter, seed = input.identity.seed](RockId rock, ParticleId i, ParticleId j) {
    return strength_factor(scatter, seed, rock, i, j);
  };
}

Liners liners_of(const CaseCrusher& crusher) {
  return make_liners(crusher.liners, {crusher.closed_side_setting, crusher.eccentricity, crusher.pivot_height});
}

std::optional<MeshLiners> mesh_liners(const Scene& scene) {
  const TriangleMesh *concave = nullptr, *mantle = nullptr;
  const GyrationMotion* motion = nullptr;
  for (const Wall& wall : scene.walls) {
    const auto* shape = std::get_if<TriangleMesh>(&wall.shape);
    if (wall.name == "concave" && std::holds_alternative<Fixed>(wall.motion)) concave = shape;
    if (motion != nullptr) continue;
    motion = std::get_if<GyrationMotion>(&wall.motion);
    mantle = motion != nullptr ? shape : nullptr;
  }
  if (concave == nullptr || mantle == nullptr) return std::nullopt;
  return MeshLiners{*concave, *mantle, *motion};
}

Assembly assemble_walls(const Case& input) {
  Assembly out;
  out.scene.materials = input.materials;
  if (input.crusher) {
    const CaseCrusher& c = *input.crusher;
    out.pivot_height = c.pivot_height;
    if (!c.liners.empty()) out.liners = blaming("crusher", [&] { return liners_of(c); });
  }
  for (const CaseWall& wall : input.walls) blaming("walls." + wall.name, [&] { add_wall(out, wall); });
  if (input.crusher) blaming("crusher", [&] { set_meshes(out, input.crusher->closed_side_setting); });
  return out;
}

Assembly assemble(const Case& input) {
  if (input.output.hdf5)
    throw BadKey("output.formats", "snapshots in hdf5 are not available in this version; vtp is accepted");
  if (input.drivetrain) blaming("drivetrain", [&] { check_drivetrain(*input.drivetrain); });
  Assembly out = assemble_walls(input);
  check_crusher(input, out);
  Scene& scene = out.scene;
  scene.pairs = pair_table(input);
  scene.rock_material = input.rock_material;
  scene.gravity = input.gravity;
  scene.wall_impulses = input.output.liners.has_value();
  if (input.bonds) scene.bonds = bond_parameters(*input.bonds);
  if (input.rocks) {
    out.library = blaming("rocks", [&] { return cached_library(recipe_of(input, scene), default_cache_folder()); });
    out.notes.insert(out.notes.end(), out.library.notes.begin(), out.library.notes.end());
    out.removal_depth = 2 * largest_rock(out.library);
  }
  out.start = blaming("particles", [&] { return start_state(input); });
  blaming("particles", [&] { check_start(scene, out.start); });
  out.removal_depth = std::max(out.removal_depth, twice_largest(out.start));
  if (input.crusher && input.crusher->removal_depth) out.removal_depth = *input.crusher->removal_depth;
  out.step = choose_step(input, scene, out.library, out.start);
  note_windows(out, input);
  scene.dt = out.step.dt;
  scene.substeps = input.numerics.substeps;
  if (input.feed) out.feed = blaming("feed", [&] { return feed_plan(input, out); });
  return out;
}

}  // namespace gyro

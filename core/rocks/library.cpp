// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/library.hpp"

#include "core/base/errors.hpp"
#include "core/base/thread_team.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/rocks/recipe.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

namespace gyro {
namespace {

double cube(double x) {
  return x * x * x;
}

/// No rock is so long for its volume: spheres are searched within its reach, and a needle or a plate holds none.
void check_reach(const std::string& name, const RockShape& shape) {
  constexpr double farthest = 10;  // of the centre, in sides of the cube of equal volume
  double reach = 0;
  for (const Vec3d& v : shape.surface.vertices) reach = std::max(reach, norm(v));
  if (reach <= farthest) return;
  std::ostringstream times;
  times.precision(3);
  times << 2 * reach / std::cbrt(6 / std::numbers::pi);
  throw BadInput(
      name + ": the shape is a needle or a plate, " + times.str() +
      " times as long as the sphere of its volume; give the scan of a rock, or one whose axes have the same unit");
}

struct NamedMould {
  std::string name;
  Mould mould;
};

std::vector<NamedMould> make_moulds(const LibraryRecipe& recipe, std::vector<std::string>& notes) {
  std::vector<NamedMould> moulds;
  if (const auto* procedural = std::get_if<ProceduralShapes>(&recipe.shapes)) {
    const int used = std::min(procedural->count, recipe.samples);
    for (int k = 0; k < used; ++k) {
      moulds.push_back(
          {"procedural-" + std::to_string(k + 1), Mould(procedural_shape(recipe.seed, k, procedural->style))});
    }
    return moulds;
  }
  if (const auto* cylinder = std::get_if<CylinderSpecimen>(&recipe.shapes)) {
    moulds.push_back({"cylinder", Mould(cylinder_shape(cylinder->slenderness, cylinder->loading_angle))});
    return moulds;
  }
  const auto& given = std::get<GivenShapes>(recipe.shapes);
  for (const GivenShape& shape : given.shapes) {
    RepairedMesh solid = shape.load();
    if (given.corners > 0) solid.mesh = coarse_polyhedron(solid.mesh, given.corners);
    notes.insert(notes.end(), solid.notes.begin(), solid.notes.end());
    const RockShape made = make_shape(solid.mesh);
    check_reach(shape.name, made);
    moulds.push_back({shape.name, Mould(made)});
  }
  return moulds;
}

/// Measures how well the particles model the solid rock.
void measure(RockTemplate& rock, const RockShape& shape, double rock_density) {
  const double volume = sphere_volume(rock.radii), solid_mass = rock_density * rock.solid_volume;
  rock.packing_fraction = volume / rock.solid_volume;
  rock.coordination = 2 * static_cast<double>(rock.bonds.size()) / static_cast<double>(rock.centres.size());
  rock.mass_error = volume * rock.particle_density / solid_mass - 1;
  const Vec3d got = principal_axes(sphere_inertia(rock.centres, rock.radii, rock.particle_density)).moments;
  const Vec3d want = (solid_mass * std::pow(rock.solid_volume, 2.0 / 3)) * shape.inertia;
  rock.inertia_error =
      std::max({std::abs(got.x / want.x - 1), std::abs(got.y / want.y - 1), std::abs(got.z / want.z - 1)});
  for (std::size_t k = 0; k < rock.centres.size(); ++k) {
    rock.bounding_radius = std::max(rock.bounding_radius, norm(rock.centres[k]) + rock.radii[k]);
  }
}

RockTemplate make_rock(const LibraryRecipe& recipe, const NamedMould& source, double diameter, int number) {
  const Mould& mould = source.mould;
  RockTemplate rock;
  char size[40];
  std::snprintf(size, sizeof size, "-%.4gmm", 1000 * diameter);
  rock.name = source.name + size;
  rock.diameter = diameter;
  rock.solid_volume = std::numbers::pi / 6 * cube(diameter);
  const double scale = std::cbrt(rock.solid_volume);
  rock.sieve_size = scale * mould.shape.sieve_size;

  const Filling filling =
      fill(mould, recipe.fill, recipe.bond_rule, {diameter, recipe.seed, static_cast<std::uint64_t>(number)});
  const Vec3d middle = centre_of_mass(filling.centres, filling.radii);
  for (const Vec3d& c : filling.centres) rock.centres.push_back(scale * (c - middle));
  for (const double r : filling.radii) rock.radii.push_back(scale * r);
  const TriangleMesh surface = moved(mould.shape.preview, middle, scale);
  rock.centre_error = scale * norm(middle) / diameter;
  rock.hull_vertices = surface.vertices;
  rock.hull_faces = surface.triangles;

  rock.particle_density = recipe.rock_density;
  if (recipe.compensated) rock.particle_density *= rock.solid_volume / sphere_volume(rock.radii);
  rock.bonds = make_bonds(rock.centres, rock.radii, recipe.bond_rule);
  rock.colour_begin = colour_bonds(rock.bonds, static_cast<Index>(rock.centres.size()));
  measure(rock, mould.shape, recipe.rock_density);
  rock.critical_step = critical_step(rock, recipe.bond_parameters, recipe.bed);
  rock.bond_step = critical_step(rock, recipe.bond_parameters, BedContacts{});
  return rock;
}

/// Calls work(k) for k = count - 1, ..., 0 on all threads: the largest rocks first, so that the threads end together.
/// What comes after a failure is left out; the failure of the largest k is thrown, on any number of threads.
template <class Work>
void for_each_downwards(ThreadTeam& team, int count, const Work& work) {
  std::atomic<int> failed = -1;  // the largest k so far
  for_each_job(team, count, [&](int done) {
    const int k = count - 1 - done;
    if (k < failed) return;
    try {
      work(k);
    } catch (...) {
      for (int known = failed; known < k && !failed.compare_exchange_weak(known, k);) {
      }
      throw;
    }
  });
}

/// Makes the packings that the rocks will be cut from, so that no two rocks wait for the same one.
void make_packings(ThreadTeam& team, const RangeFill& range, const std::vector<double>& diameters) {
  std::set<Grading> gradings;
  for (const double diameter : diameters) gradings.insert(grading_of(range, diameter));
  const std::vector<Grading> list(gradings.begin(), gradings.end());
  for_each_downwards(team, static_cast<int>(list.size()), [&](int k) { rock_packing(list[k]); });
}

RockLibrary build(const LibraryRecipe& recipe, const SizeDistribution& sizes, ThreadTeam& team,
                  const LibraryProgress& progress) {
  RockLibrary library;
  const std::vector<NamedMould> moulds = make_moulds(recipe, library.notes);
  std::vector<double> diameters;
  for (int k = 0; k < recipe.samples; ++k) diameters.push_back(sizes.size_at((k + 0.5) / recipe.samples));
  if (const auto* range = std::get_if<RangeFill>(&recipe.fill)) make_packings(team, *range, diameters);
  library.rocks.resize(recipe.samples);
  std::atomic<int> made = 0;
  for_each_downwards(team, recipe.samples, [&](int k) {
    library.rocks[k] = make_rock(recipe, moulds[k % moulds.size()], diameters[k], k);
    if (progress) progress(++made, recipe.samples);
  });
  return library;
}

}  // namespace

RockLibrary make_library(const LibraryRecipe& recipe, int threads, const LibraryProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  check_recipe(recipe);
  ThreadTeam team(std::min(recipe.samples, threads > 0 ? threads : all_cores()));
  RockLibrary library = build(recipe, SizeDistribution(recipe.sizes), team, progress);
  library.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return library;
}

double cylinder_diameter(const CylinderSpecimen& specimen, double sphere) {
  // The flats remove two segments of the circle: section D^2/4 (pi - a + sin a), length slenderness D.
  const double angle = specimen.loading_angle;
  const double kept = 1 - (angle - std::sin(angle)) / std::numbers::pi;
  return sphere * std::cbrt(2 / (3 * specimen.slenderness * kept));
}

double swell_of_crumbled(const RockLibrary& library) {
  constexpr double loose_bed = 0.60;  // of equal spheres, poured; a range of sizes packs more densely
  double sum = 0;
  for (const RockTemplate& rock : library.rocks) sum += rock.packing_fraction;
  return library.rocks.empty() ? 0 : sum / static_cast<double>(library.rocks.size()) / loose_bed;
}

}  // namespace gyro

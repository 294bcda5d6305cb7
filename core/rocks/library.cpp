// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/library.hpp"

#include "core/geometry/stl_file.hpp"
#include "core/rocks/cache.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/recipe.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numbers>

namespace gyro {
namespace {

struct NamedMould {
  std::string name;
  Mould mould;
};

std::vector<NamedMould> make_moulds(const LibraryRecipe& recipe, std::vector<std::string>& notes) {
  std::vector<NamedMould> moulds;
  if (const auto* procedural = std::get_if<ProceduralShapes>(&recipe.shapes)) {
    const int used = std::min(procedural->count, recipe.samples);
    for (int k = 0; k < used; ++k) {
      moulds.push_back({"procedural-" + std::to_string(k + 1), Mould(procedural_shape(recipe.seed, k))});
    }
    return moulds;
  }
  for (const std::string& path : std::get<ShapeFiles>(recipe.shapes).paths) {
    ReadMesh read = read_solid(path);
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    moulds.push_back({std::filesystem::path(path).stem().string(), Mould(make_shape(read.mesh))});
  }
  return moulds;
}

double cube(double x) {
  return x * x * x;
}

/// Quantities that say how good a model of the solid rock the particles are.
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

  const Filling filling = fill_mono(mould, recipe.fill_ratio, recipe.bond_rule, recipe.seed, number);
  const Vec3d middle = centre_of_mass(filling.centres, filling.radii);
  for (const Vec3d& c : filling.centres) rock.centres.push_back(scale * (c - middle));
  for (const double r : filling.radii) rock.radii.push_back(scale * r);
  const TriangleMesh surface = moved(mould.shape.preview, middle, scale);
  rock.hull_vertices = surface.vertices;
  rock.hull_faces = surface.triangles;

  rock.particle_density = recipe.rock_density;
  if (recipe.compensated) rock.particle_density *= rock.solid_volume / sphere_volume(rock.radii);
  rock.bonds = make_bonds(rock.centres, rock.radii, recipe.bond_rule);
  rock.colour_begin = colour_bonds(rock.bonds, static_cast<Index>(rock.centres.size()));
  measure(rock, mould.shape, recipe.rock_density);
  rock.critical_step = critical_step(rock, recipe.bond_parameters, recipe.bed);
  return rock;
}

RockLibrary build(const LibraryRecipe& recipe, const SizeDistribution& sizes) {
  RockLibrary library;
  const std::vector<NamedMould> moulds = make_moulds(recipe, library.notes);
  library.rocks.resize(recipe.samples);
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < recipe.samples; ++k) {
    try {
      const double diameter = sizes.size_at((k + 0.5) / recipe.samples);
      library.rocks[k] = make_rock(recipe, moulds[k % moulds.size()], diameter, k);
    } catch (...) {
#pragma omp critical(gyro_library_failure)
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  return library;
}

}  // namespace

RockLibrary make_library(const LibraryRecipe& recipe, const std::string& cache_folder) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  check_recipe(recipe);
  const SizeDistribution sizes(recipe.sizes);
  const std::string text = recipe_text(recipe);
  std::optional<RockLibrary> library;
  if (!cache_folder.empty()) library = read_cached(cache_folder, text);
  if (!library) {
    library = build(recipe, sizes);
    if (!cache_folder.empty()) write_cached(cache_folder, text, *library);
  }
  library->seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return std::move(*library);
}

std::string default_cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache && *cache) return std::string(cache) + "/gyrosim";
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.cache/gyrosim" : std::string();
}

}  // namespace gyro

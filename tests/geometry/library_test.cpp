// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/library.hpp"
#include "core/base/errors.hpp"
#include "core/geometry/stl_file.hpp"
#include "core/rocks/cache.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/recipe.hpp"
#include "tests/catch.hpp"
#include "tests/geometry/meshes.hpp"

#include <omp.h>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

LibraryRecipe small_recipe() {
  LibraryRecipe recipe;
  recipe.shapes = ProceduralShapes{3};
  recipe.sizes = PassingTable{{{0.05, 0}, {0.5, 1}}};
  recipe.samples = 5;
  recipe.fill = MonoFill{4};
  recipe.rock_density = 2600;
  recipe.bond_parameters = {1.67e12, 6.67e11, 36e6, 24e6, 0.05};
  recipe.bed = {6, 5e8, 4e8, 0.3, 0.3};
  recipe.seed = 42;
  return recipe;
}

std::string bytes_of(RockLibrary library) {
  library.seconds = 0;
  return pack_library(library, "x");
}

std::filesystem::path only_file(const TemporaryFolder& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path)) files.push_back(entry.path());
  REQUIRE(files.size() == 1);
  return files[0];
}

}  // namespace

TEST_CASE("A library has the sizes, masses and frames it promises") {
  LibraryRecipe recipe = small_recipe();
  recipe.fill = MonoFill{6};
  recipe.samples = 8;
  const RockLibrary library = make_library(recipe, "");
  REQUIRE(library.rocks.size() == 8);
  CHECK_FALSE(library.from_cache);
  for (int k = 0; k < 8; ++k) {
    const RockTemplate& rock = library.rocks[k];
    CAPTURE(rock.name, rock.inertia_error, rock.coordination);
    CHECK(rock.diameter == Approx(0.05 + 0.45 * (k + 0.5) / 8));
    CHECK(rock.radii[0] == Approx(rock.diameter / 12));
    CHECK(std::abs(rock.mass_error) < 1e-12);
    const double mass = rock.particle_density * sphere_volume(rock.radii);
    CHECK(mass == Approx(2600 * std::numbers::pi / 6 * std::pow(rock.diameter, 3)));
    CHECK(rock.inertia_error < 0.06);
    CHECK(rock.centre_error > 0);
    // Independent random points in a ball would be off by sqrt(3/20) diameters over the root of their number.
    CHECK(rock.centre_error < std::sqrt(0.15 / static_cast<double>(rock.centres.size())));
    CHECK(norm(centre_of_mass(rock.centres, rock.radii)) < 1e-12 * rock.diameter);
    CHECK(rock.packing_fraction > 0.58);
    CHECK(rock.packing_fraction < 0.66);
    CHECK(rock.coordination > 4.5);
    CHECK(rock.coordination < 6.5);
    CHECK(rock.sieve_size > 0.7 * rock.diameter);
    CHECK(rock.sieve_size < 1.1 * rock.diameter);
    CHECK(rock.critical_step > 1e-6);
    CHECK(rock.critical_step < 3e-5);
    CHECK(mass_properties({rock.hull_vertices, rock.hull_faces}).volume == Approx(rock.solid_volume));
    for (std::size_t p = 0; p < rock.centres.size(); ++p) {
      CHECK(norm(rock.centres[p]) + rock.radii[p] <= rock.bounding_radius * (1 + 1e-15));
    }
    CHECK(largest_piece(rock.bonds, static_cast<Index>(rock.centres.size())).size() == rock.centres.size());
    CHECK(rock.colour_begin.back() == static_cast<Index>(rock.bonds.size()));
    for (const TemplateBond& b : rock.bonds) {
      CHECK(b.i < b.j);
      CHECK(b.length == Approx(norm(rock.centres[b.i] - rock.centres[b.j])));
      CHECK(b.radius == Approx(0.5 * rock.radii[0]));
    }
  }
}

TEST_CASE("Plain density weighs what the spheres weigh") {
  LibraryRecipe recipe = small_recipe();
  recipe.compensated = false;
  for (const RockTemplate& rock : make_library(recipe, "").rocks) {
    CHECK(rock.particle_density == 2600);
    CHECK(rock.mass_error == Approx(rock.packing_fraction - 1));
  }
}

TEST_CASE("The library is the same for any number of threads") {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const std::string one = bytes_of(make_library(small_recipe(), ""));
  omp_set_num_threads(3);
  const std::string three = bytes_of(make_library(small_recipe(), ""));
  omp_set_num_threads(threads);
  CHECK((one == three));  // in brackets: not to print the bytes
}

TEST_CASE("A cached library is the one that was made") {
  const TemporaryFolder folder("cache");
  const RockLibrary made = make_library(small_recipe(), folder.path.string());
  const RockLibrary read = make_library(small_recipe(), folder.path.string());
  CHECK_FALSE(made.from_cache);
  CHECK(read.from_cache);
  CHECK((bytes_of(made) == bytes_of(read)));

  SECTION("another recipe is another file") {
    LibraryRecipe other = small_recipe();
    other.bond_parameters.damping = 0.06;
    CHECK_FALSE(make_library(other, folder.path.string()).from_cache);
  }
  SECTION("a damaged file is made again without a word") {
    const std::string path = only_file(folder).string();
    const std::string good = read_bytes(path);
    const int kind = GENERATE(0, 1, 2, 3);
    std::string bad = good;
    if (kind == 0) bad[bad.size() / 2] = static_cast<char>(bad[bad.size() / 2] ^ 1);
    if (kind == 1) bad.resize(bad.size() / 3);
    if (kind == 2) bad.clear();
    if (kind == 3) bad[22] = static_cast<char>(bad[22] + 1);  // version
    std::ofstream(path, std::ios::binary) << bad;
    const RockLibrary again = make_library(small_recipe(), folder.path.string());
    CHECK_FALSE(again.from_cache);
    CHECK((bytes_of(again) == bytes_of(made)));
    CHECK((read_bytes(only_file(folder).string()) == good));
  }
}

TEST_CASE("A cache that cannot be written is no error") {
  const TemporaryFolder folder("blocked");
  const std::string file = folder.write("file", "not a folder");
  LibraryRecipe recipe = small_recipe();
  recipe.samples = 1;
  CHECK(make_library(recipe, file + "/below").rocks.size() == 1);
}

TEST_CASE("Rocks from files, also ones that are not convex, and the cache sees their content") {
  const TemporaryFolder folder("shapes"), cache("shape-cache");
  LibraryRecipe recipe = small_recipe();
  const std::string corner = (folder.path / "corner.stl").string();
  write_stl(corner, corner_piece());
  recipe.shapes = ShapeFiles{{corner}};
  recipe.samples = 2;
  recipe.fill = MonoFill{6};
  const RockLibrary library = make_library(recipe, cache.path.string());
  for (const RockTemplate& rock : library.rocks) {
    CHECK_THAT(rock.name, Contains("corner"));
    CHECK(rock.centres.size() > 115);
    CHECK(rock.centres.size() < 150);
    // Three unit cubes: through a square of side 2, along one of the long edges.
    CHECK(rock.sieve_size == Approx(2 * std::cbrt(rock.solid_volume / 3)).epsilon(1e-5));
  }
  CHECK(make_library(recipe, cache.path.string()).from_cache);
  TriangleMesh inverted = block({1, 1, 2});
  for (auto& t : inverted.triangles) std::swap(t.x, t.y);
  write_stl(corner, inverted);
  const RockLibrary changed = make_library(recipe, cache.path.string());
  CHECK_FALSE(changed.from_cache);
  REQUIRE(changed.notes.size() == 1);
  CHECK(make_library(recipe, cache.path.string()).notes == changed.notes);
}

TEST_CASE("An error in the parallel part arrives") {
  const TemporaryFolder folder("plate");
  LibraryRecipe recipe = small_recipe();
  const std::string plate = (folder.path / "plate.stl").string();
  write_stl(plate, block({10, 10, 0.1}));
  recipe.shapes = ShapeFiles{{plate}};
  CHECK_THROWS_AS(make_library(recipe, ""), BadInput);
}

TEST_CASE("Recipes out of range are refused") {
  const auto refused = [](auto change) {
    LibraryRecipe recipe = small_recipe();
    change(recipe);
    CHECK_THROWS_AS(make_library(recipe, ""), BadInput);
  };
  refused([](LibraryRecipe& r) { r.samples = 0; });
  refused([](LibraryRecipe& r) { r.shapes = ProceduralShapes{0}; });
  refused([](LibraryRecipe& r) { r.shapes = ShapeFiles{}; });
  refused([](LibraryRecipe& r) { r.shapes = ShapeFiles{{"/nowhere/rock.stl"}}; });
  refused([](LibraryRecipe& r) { r.shapes = CylinderSpecimen{2, 1.5}; });
  refused([](LibraryRecipe& r) { r.fill = MonoFill{1}; });
  refused([](LibraryRecipe& r) { r.rock_density = 0; });
  refused([](LibraryRecipe& r) { r.sizes = PassingTable{}; });
  refused([](LibraryRecipe& r) { r.bond_rule.gap = -1; });
  refused([](LibraryRecipe& r) { r.bond_parameters.damping = NAN; });
  refused([](LibraryRecipe& r) { r.bed.number = -1; });
}

TEST_CASE("The hash is FNV-1a") {
  // Published test vectors of draft-eastlake-fnv.
  CHECK(fnv1a_128("") == "6c62272e07bb014262b821756295c58d");
  CHECK(fnv1a_128("a") == "d228cb696f1a8caf78912b704e4a8964");
  CHECK(fnv1a_128("foobar") == "343e1662793c64bf6f0d3597ba446f18");
}

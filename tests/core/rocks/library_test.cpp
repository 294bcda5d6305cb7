// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/library.hpp"
#include "core/base/errors.hpp"
#include "core/geometry/mesh.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/recipe.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"
#include "tests/core/rocks/libraries.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <set>
#include <stdexcept>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

GivenShape given(const std::string& name, const TriangleMesh& mesh) {
  return {name, name, [mesh, name] { return RepairedMesh{mesh, {"a note about " + name}}; }};
}

}  // namespace

TEST_CASE("A library has the specified sizes, masses and frames") {
  LibraryRecipe recipe = small_recipe();
  recipe.fill = MonoFill{6};
  recipe.samples = 8;
  const RockLibrary library = make_library(recipe);
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

TEST_CASE("Without compensation a rock has the mass of its spheres") {
  LibraryRecipe recipe = small_recipe();
  recipe.compensated = false;
  for (const RockTemplate& rock : make_library(recipe).rocks) {
    CHECK(rock.particle_density == 2600);
    CHECK(rock.mass_error == Approx(rock.packing_fraction - 1));
  }
}

TEST_CASE("The library is the same for any number of threads") {
  const RockLibrary one = make_library(small_recipe(), 1);
  const RockLibrary three = make_library(small_recipe(), 3);
  REQUIRE(one.rocks.size() == 5);
  REQUIRE(three.rocks.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) CHECK(same_rock(one.rocks[k], three.rocks[k]));
}

TEST_CASE("Rocks are made of given shapes, also of one that is not convex") {
  LibraryRecipe recipe = small_recipe();
  recipe.shapes = GivenShapes{{given("corner", corner_piece()), given("brick", block({1, 1, 2}))}};
  recipe.samples = 3;
  recipe.fill = MonoFill{6};
  const RockLibrary library = make_library(recipe);
  CHECK(library.notes == std::vector<std::string>{"a note about corner", "a note about brick"});
  CHECK_THAT(library.rocks[1].name, Contains("brick"));
  for (const std::size_t k : {0, 2}) {
    const RockTemplate& rock = library.rocks[k];
    CHECK_THAT(rock.name, Contains("corner"));
    CHECK(rock.centres.size() > 115);
    CHECK(rock.centres.size() < 150);
    // Three unit cubes: through a square of side 2, along one of the long edges.
    CHECK(rock.sieve_size == Approx(2 * std::cbrt(rock.solid_volume / 3)).epsilon(1e-5));
  }
}

TEST_CASE("The text of a recipe names everything that a library depends on, shapes by their content") {
  const std::string text = recipe_text(small_recipe());
  CHECK(recipe_text(small_recipe()) == text);
  const auto differs = [&](auto change) {
    LibraryRecipe recipe = small_recipe();
    change(recipe);
    CHECK(recipe_text(recipe) != text);
  };
  differs([](LibraryRecipe& r) { r.seed = 43; });
  differs([](LibraryRecipe& r) { r.samples = 6; });
  differs([](LibraryRecipe& r) { r.shapes = ProceduralShapes{4}; });
  differs([](LibraryRecipe& r) { std::get<ProceduralShapes>(r.shapes).style.roughness = 0.1; });
  differs([](LibraryRecipe& r) { std::get<PassingTable>(r.sizes).points[1].size = std::nextafter(0.5, 1.0); });
  differs([](LibraryRecipe& r) { r.fill = MonoFill{4, MonoFill::Surface::smooth}; });
  differs([](LibraryRecipe& r) { r.fill = MonoFill{4, MonoFill::Surface::cut, 0.02}; });
  differs([](LibraryRecipe& r) { r.rock_density = 2601; });
  differs([](LibraryRecipe& r) { r.compensated = false; });
  differs([](LibraryRecipe& r) { r.bond_rule.gap = 0.06; });
  differs([](LibraryRecipe& r) { r.bond_rule.radius = AbsoluteBondRadius{0.5}; });
  differs([](LibraryRecipe& r) { r.bond_parameters.damping = 0.06; });
  differs([](LibraryRecipe& r) { r.bed.number = 7; });
  differs([](LibraryRecipe& r) { r.bed.damping_cap = 0.5; });

  const auto text_of = [](const GivenShape& shape) {
    LibraryRecipe recipe = small_recipe();
    recipe.shapes = GivenShapes{{shape}};
    return recipe_text(recipe);
  };
  const auto never = []() -> RepairedMesh { throw std::logic_error("loaded for its text"); };
  CHECK(text_of({"a", "content", never}) == text_of({"a", "content", never}));
  CHECK(text_of({"a", "content", never}) != text_of({"a", "other content", never}));
  CHECK(text_of({"a", "content", never}) != text_of({"b", "content", never}));
}

TEST_CASE("An error in the parallel part is thrown to the caller") {
  LibraryRecipe recipe = small_recipe();
  recipe.shapes = GivenShapes{{given("plate", block({10, 10, 0.1}))}};
  CHECK_THROWS_AS(make_library(recipe), BadInput);
}

TEST_CASE("The progress of a library counts its rocks, and ends with the first failure") {
  LibraryRecipe recipe = small_recipe();
  std::mutex mutex;
  std::set<int> told;
  const LibraryProgress progress = [&](int made, int of) {
    const std::lock_guard lock(mutex);
    CHECK(of == recipe.samples);
    told.insert(made);
  };
  make_library(recipe, 2, progress);
  CHECK(static_cast<int>(told.size()) == recipe.samples);
  CHECK(*told.rbegin() == recipe.samples);
  recipe.shapes = GivenShapes{{given("good", block({1, 1, 1})), given("plate", block({10, 10, 0.1}))}};
  recipe.samples = 1000;  // takes minutes
  told.clear();
  CHECK_THROWS_WITH(make_library(recipe, 2, progress), Contains("do not hold together"));
  CHECK(told.size() < 10);
}

TEST_CASE("A needle or a plate is refused with its name") {
  LibraryRecipe recipe = small_recipe();
  recipe.shapes = GivenShapes{{given("scan", block({10, 1e-3, 1e-3}))}};
  CHECK_THROWS_WITH(make_library(recipe), Contains("scan: the shape is a needle or a plate"));
}

TEST_CASE("An error of a given shape is thrown to the caller") {
  LibraryRecipe recipe = small_recipe();
  recipe.shapes = GivenShapes{{{"lost", "lost", []() -> RepairedMesh { throw BadInput("no such shape"); }}}};
  CHECK_THROWS_WITH(make_library(recipe), Contains("no such shape"));
}

TEST_CASE("Recipes out of range are refused") {
  const auto refused = [](auto change) {
    LibraryRecipe recipe = small_recipe();
    change(recipe);
    CHECK_THROWS_AS(make_library(recipe), BadInput);
  };
  refused([](LibraryRecipe& r) { r.samples = 0; });
  refused([](LibraryRecipe& r) { r.shapes = ProceduralShapes{0}; });
  refused([](LibraryRecipe& r) { r.shapes = GivenShapes{}; });
  refused([](LibraryRecipe& r) { r.shapes = GivenShapes{{given("brick", block({1, 1, 2}))}, 7}; });
  refused([](LibraryRecipe& r) { r.shapes = CylinderSpecimen{2, 1.5}; });
  refused([](LibraryRecipe& r) { r.fill = MonoFill{1}; });
  refused([](LibraryRecipe& r) { r.rock_density = 0; });
  refused([](LibraryRecipe& r) { r.sizes = PassingTable{}; });
  refused([](LibraryRecipe& r) { r.bond_rule.gap = -1; });
  refused([](LibraryRecipe& r) { r.bond_parameters.damping = NAN; });
  refused([](LibraryRecipe& r) { r.bed.number = -1; });
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/shape_files.hpp"
#include "core/base/errors.hpp"
#include "io/mesh/stl.hpp"
#include "io/rocks/library_cache.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"
#include "tests/core/rocks/libraries.hpp"
#include "tests/io/mesh/written.hpp"

using namespace gyro;
using Catch::Matchers::Contains;

TEST_CASE("Rocks are made from mesh files, and the cache depends on the content of the files") {
  const ScratchDirectory folder, cache;
  const std::string corner = (folder.path() / "corner.stl").string();
  const auto library_of_file = [&] {
    LibraryRecipe recipe = small_recipe();
    recipe.shapes = recipe_shapes(ShapeFiles{{corner}});
    recipe.samples = 2;
    recipe.fill = MonoFill{6};
    return cached_library(recipe, cache.path());
  };
  write_stl(corner, corner_piece());
  for (const RockTemplate& rock : library_of_file().rocks) {
    CHECK_THAT(rock.name, Contains("corner"));
    // The shape is three unit cubes: it passes a square of side 2, along one of its long edges.
    CHECK(rock.sieve_size == Approx(2 * std::cbrt(rock.solid_volume / 3)).epsilon(1e-5));
  }
  CHECK(library_of_file().from_cache);
  TriangleMesh inverted = block({1, 1, 2});
  for (auto& t : inverted.triangles) std::swap(t.x, t.y);
  write_stl(corner, inverted);
  const RockLibrary changed = library_of_file();
  CHECK_FALSE(changed.from_cache);
  REQUIRE(changed.notes.size() == 1);
  CHECK_THAT(changed.notes[0], Contains("corner.stl: 12 triangles flipped"));
  const RockLibrary read = library_of_file();
  CHECK(read.from_cache);
  CHECK(read.notes == changed.notes);
}

TEST_CASE("A shape file is parsed only if the library has to be made") {
  const ScratchDirectory folder;
  const std::string path = written(folder, "rock.stl", "solid of nothing");
  const RockShapes shapes = recipe_shapes(ShapeFiles{{path}});
  CHECK_THROWS_WITH(std::get<GivenShapes>(shapes).shapes.at(0).load(), Contains("rock.stl"));
}

TEST_CASE("Shape files that cannot be read are refused at once, and so is an empty list of files") {
  CHECK_THROWS_WITH(recipe_shapes(ShapeFiles{{"/nowhere/rock.stl"}}), Contains("/nowhere/rock.stl: no such file"));
  LibraryRecipe recipe = small_recipe();
  recipe.shapes = recipe_shapes(ShapeFiles{});
  CHECK_THROWS_AS(cached_library(recipe, ""), BadInput);
}

TEST_CASE("Shapes that do not come from files are passed on unchanged") {
  CHECK(std::get<ProceduralShapes>(recipe_shapes(ProceduralShapes{7})).count == 7);
  CHECK(std::get<CylinderSpecimen>(recipe_shapes(CylinderSpecimen{3})).slenderness == 3);
}

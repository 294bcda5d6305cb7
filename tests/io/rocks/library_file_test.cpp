// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/library_file.hpp"
#include "core/base/errors.hpp"
#include "core/rocks/recipe.hpp"
#include "io/files/seal.hpp"
#include "io/hdf5/hdf5.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/libraries.hpp"
#include "tests/io/mesh/written.hpp"

#include <limits>

using namespace gyro;
using Catch::Matchers::Contains;

TEST_CASE("A library reads back from its file to the bit") {
  const ScratchDirectory folder;
  RockLibrary library = make_library(small_recipe());
  library.notes = {"scan.stl: 1 hole closed", ""};
  library.rocks[1].critical_step = std::numeric_limits<double>::infinity();
  library.rocks[2].bonds.clear();  // like a rock of one particle
  library.rocks[2].colour_begin = {0};
  write_library(library, folder.path() / "library.h5", "a recipe\nof two lines");
  const StoredLibrary stored = read_library(folder.path() / "library.h5");
  CHECK(stored.recipe == "a recipe\nof two lines");
  CHECK(stored.library.rocks.size() == 5);
  CHECK(same_library(stored.library, library));
}

TEST_CASE("Rocks with the same name keep their own data and their order") {
  const ScratchDirectory folder;
  RockLibrary library = make_library(small_recipe());
  library.rocks.resize(4);
  for (RockTemplate& rock : library.rocks) rock.name = "cylinder-100mm";
  library.rocks[3].name = "cylinder-100mm#2";
  write_library(library, folder.path() / "library.h5");
  CHECK(same_library(read_library(folder.path() / "library.h5").library, library));
  CHECK(hdf5::File::open(folder.path() / "library.h5").children("/rocks") ==
        std::vector<std::string>{"cylinder-100mm", "cylinder-100mm#2", "cylinder-100mm#2#2", "cylinder-100mm#3"});
}

TEST_CASE("A file that is not a library is refused with its path") {
  const ScratchDirectory folder;
  const auto refused = [&](const std::filesystem::path& path, const std::string& reason) {
    CHECK_THROWS_AS(read_library(path), BadInput);
    CHECK_THROWS_WITH(read_library(path), Contains(path.string()) && Contains(reason));
  };
  refused(folder.path() / "none.h5", "not a library");
  refused(written(folder, "text.h5", "not HDF5"), "not a library");
  const std::filesystem::path newer = folder.path() / "newer.h5";
  write_library(make_library(small_recipe()), newer);
  {
    hdf5::File file = hdf5::File::modify(newer);
    file.set_attribute("/", "format", std::uint64_t{99});
    file.close();
  }
  seal(newer);
  refused(newer, "has format 99");
}

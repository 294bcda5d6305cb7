// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/library_cache.hpp"
#include "core/rocks/recipe.hpp"
#include "io/files/digest.hpp"
#include "io/mesh/mesh_file.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/libraries.hpp"
#include "tests/io/mesh/written.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <cstdlib>
#include <vector>

using namespace gyro;

namespace {

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

std::filesystem::path only_file(const ScratchDirectory& folder) {
  const auto files = files_in(folder.path());
  REQUIRE(files.size() == 1);
  return files[0];
}

}  // namespace

TEST_CASE("A library from the cache is identical to the one that was made") {
  const ScratchDirectory folder;
  const RockLibrary made = cached_library(small_recipe(), folder.path());
  const RockLibrary read = cached_library(small_recipe(), folder.path());
  CHECK_FALSE(made.from_cache);
  CHECK(read.from_cache);
  CHECK(same_library(made, read));
  CHECK(same_library(made, make_library(small_recipe())));

  SECTION("another recipe has another file") {
    LibraryRecipe other = small_recipe();
    other.bond_parameters.damping = 0.06;
    CHECK_FALSE(cached_library(other, folder.path()).from_cache);
    CHECK(files_in(folder.path()).size() == 2);
  }
  SECTION("a file with the text of another recipe is not used") {
    write_cached(folder.path(), "another recipe", made);
    const auto file = folder.path() / ("rocks-" + digest_of("another recipe") + ".h5");
    REQUIRE(std::filesystem::exists(file));
    std::filesystem::rename(file, folder.path() / ("rocks-" + digest_of(recipe_text(small_recipe())) + ".h5"));
    CHECK_FALSE(cached_library(small_recipe(), folder.path()).from_cache);
  }
  SECTION("a damaged file is ignored and written again") {
    const std::string path = only_file(folder).string();
    const std::string good = read_bytes(path);
    const int kind = GENERATE(0, 1, 2, 3);
    std::string bad = good;
    if (kind == 0) bad[bad.size() / 2] = static_cast<char>(bad[bad.size() / 2] ^ 1);
    if (kind == 1) bad.resize(bad.size() / 3);
    if (kind == 2) bad.clear();
    if (kind == 3) bad[0] = 'x';  // no longer HDF5
    written(folder, only_file(folder).filename(), bad);
    const RockLibrary again = cached_library(small_recipe(), folder.path());
    CHECK_FALSE(again.from_cache);
    CHECK(same_library(again, made));
    CHECK((read_bytes(only_file(folder).string()) == good));
  }
}

TEST_CASE("A cache file with a flipped bit is never used") {
  const ScratchDirectory folder;
  LibraryRecipe recipe = small_recipe();
  recipe.samples = 2;
  RockLibrary library = make_library(recipe);
  library.notes = {"scan.stl: 1 hole closed"};
  const std::string text = recipe_text(recipe);
  write_cached(folder.path(), text, library);
  const std::string good = read_bytes(only_file(folder).string());
  std::size_t refused = 0;
  for (std::size_t at = 0; at < good.size(); at += 7) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ (1 << (at % 8)));
    written(folder, only_file(folder).filename(), bad);
    const std::optional<RockLibrary> read = read_cached(folder.path(), text);
    if (read) FAIL("a flipped bit at byte " << at << " is not detected");
    ++refused;
  }
  CHECK(refused == (good.size() + 6) / 7);
}

TEST_CASE("Processes that share a cache never see an incomplete library and leave no other files") {
  const ScratchDirectory folder;
  const RockLibrary library = make_library(small_recipe());
  const std::string text = recipe_text(small_recipe());
  std::vector<pid_t> writers;
  for (int k = 0; k < 3; ++k) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      for (int write = 0; write < 30; ++write) write_cached(folder.path(), text, library);
      ::_exit(0);
    }
    writers.push_back(child);
  }
  int found = 0;
  bool intact = true;
  for (int read = 0; read < 2000 && found < 200; ++read) {
    const std::optional<RockLibrary> cached = read_cached(folder.path(), text);
    if (!cached) {
      intact = intact && found == 0;  // after a library has been found once, there must always be one
      continue;
    }
    ++found;
    intact = intact && same_library(*cached, library);
  }
  for (const pid_t writer : writers) {
    int status = -1;
    ::waitpid(writer, &status, 0);
    CHECK(status == 0);
  }
  CHECK(intact);
  CHECK(read_cached(folder.path(), text).has_value());
  CHECK(files_in(folder.path()).size() == 1);
}

TEST_CASE("A cache that cannot be written is not an error") {
  const ScratchDirectory folder;
  const std::string file = written(folder, "file", "not a folder");
  LibraryRecipe recipe = small_recipe();
  recipe.samples = 1;
  CHECK(cached_library(recipe, file + "/below").rocks.size() == 1);
  CHECK(cached_library(recipe, "").rocks.size() == 1);
}

TEST_CASE("The cache is in XDG_CACHE_HOME or in the home directory") {
  const auto with = [](const char* cache, const char* home) {
    cache ? ::setenv("XDG_CACHE_HOME", cache, 1) : ::unsetenv("XDG_CACHE_HOME");
    home ? ::setenv("HOME", home, 1) : ::unsetenv("HOME");
    return default_cache_folder();
  };
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  const std::string kept_cache = cache ? cache : "", kept_home = home ? home : "";
  CHECK(with("/c", "/h") == "/c/gyrosim");
  CHECK(with("", "/h") == "/h/.cache/gyrosim");
  CHECK(with(nullptr, nullptr).empty());
  with(cache ? kept_cache.c_str() : nullptr, home ? kept_home.c_str() : nullptr);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/library_cache.hpp"

#include "core/rocks/recipe.hpp"
#include "io/files/digest.hpp"
#include "io/rocks/library_file.hpp"

#include <unistd.h>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>

namespace gyro {
namespace {

namespace fs = std::filesystem;

/// File of a recipe in the cache. The file also contains the recipe, so that two recipes with the same digest do not
/// share a library.
fs::path cache_file(const fs::path& folder, const std::string& recipe) {
  return folder / ("rocks-" + digest_of(recipe) + ".h5");
}

}  // namespace

RockLibrary cached_library(const LibraryRecipe& recipe, const fs::path& folder, int threads,
                           const LibraryProgress& progress) {
  using Clock = std::chrono::steady_clock;
  if (folder.empty()) return make_library(recipe, threads, progress);
  const auto begin = Clock::now();
  check_recipe(recipe);
  const std::string text = recipe_text(recipe);
  std::optional<RockLibrary> library = read_cached(folder, text);
  if (!library) {
    library = make_library(recipe, threads, progress);
    write_cached(folder, text, *library);
  }
  library->seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return std::move(*library);
}

fs::path default_cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache && *cache) return fs::path(cache) / "gyrosim";
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) / ".cache/gyrosim" : fs::path();
}

std::optional<RockLibrary> read_cached(const fs::path& folder, const std::string& recipe) {
  try {
    const fs::path file = cache_file(folder, recipe);
    StoredLibrary stored = read_library(file);
    if (stored.recipe != recipe) return {};
    stored.library.from_cache = true;
    return std::move(stored.library);
  } catch (const std::exception&) {  // no such file, or a damaged one
    return {};
  }
}

void write_cached(const fs::path& folder, const std::string& recipe, const RockLibrary& library) {
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  const fs::path file = cache_file(folder, recipe);
  fs::path part = file;  // each process writes its own file
  part += '.';
  part += std::to_string(::getpid());
  try {
    write_library(library, part, recipe);
    fs::rename(part, file);
  } catch (const std::exception&) {
    fs::remove(part, ignored);
  }
}

}  // namespace gyro

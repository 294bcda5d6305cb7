// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace gyro {

/// Makes the library of a recipe, or reads it from `folder` if it was made before from the same recipe, contents of
/// shape files included. Any number of processes may share the folder. A file of the cache that is damaged is ignored
/// and written again; a folder that cannot be read or written costs time and is no error.
/// @param folder  empty: no cache
/// @throws BadInput as make_library
RockLibrary cached_library(const LibraryRecipe& recipe, const std::filesystem::path& folder, int threads = 0,
                           const LibraryProgress& progress = {});

/// $XDG_CACHE_HOME/gyrosim, or $HOME/.cache/gyrosim, or empty if neither is set.
std::filesystem::path default_cache_folder();

/// The library that the folder holds for this recipe_text; none if there is none, or its file is damaged.
std::optional<RockLibrary> read_cached(const std::filesystem::path& folder, const std::string& recipe);

/// Puts a library into the folder, whole or not at all: written beside its place, then renamed. Does nothing if that
/// fails.
void write_cached(const std::filesystem::path& folder, const std::string& recipe, const RockLibrary& library);

}  // namespace gyro

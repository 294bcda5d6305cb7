// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace gyro {

/// Makes the library of a recipe, or reads it from `folder` if it was made before from the same recipe and the same
/// contents of shape files. Any number of processes may share the folder. A damaged file of the cache is ignored and
/// written again. A folder that cannot be read or written is not an error; the library is then made.
/// @param folder  empty: no cache
/// @throws BadInput for the reasons of make_library
RockLibrary cached_library(const LibraryRecipe& recipe, const std::filesystem::path& folder, int threads = 0,
                           const LibraryProgress& progress = {});

/// $XDG_CACHE_HOME/gyrosim, or $HOME/.cache/gyrosim, or empty if neither is set.
std::filesystem::path default_cache_folder();

/// The library of this recipe_text in the folder; empty if there is none or its file is damaged.
std::optional<RockLibrary> read_cached(const std::filesystem::path& folder, const std::string& recipe);

/// Writes a library into the folder, completely or not at all: it is written under another name and then renamed.
/// Failures are ignored.
void write_cached(const std::filesystem::path& folder, const std::string& recipe, const RockLibrary& library);

}  // namespace gyro

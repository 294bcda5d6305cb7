// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace gyro {

/// A library as bytes: mark, version, recipe text, notes, rocks, checksum. In this machine's byte
/// order: a cache does not travel.
std::string pack_library(const RockLibrary& library, const std::string& recipe);

/// The way back. None if the bytes are damaged, of another version or of another recipe.
std::optional<RockLibrary> unpack_library(std::string_view bytes, const std::string& recipe);

/// The library of this recipe from the folder, or none.
std::optional<RockLibrary> read_cached(const std::string& folder, const std::string& recipe);

/// Puts a library into the folder, whole or not at all; gives up without a word if that fails.
void write_cached(const std::string& folder, const std::string& recipe, const RockLibrary& library);

}  // namespace gyro

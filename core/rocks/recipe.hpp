// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <string>

namespace gyro {

/// @throws BadInput if a number is out of range
void check_recipe(const LibraryRecipe& recipe);

/// Everything that a library depends on, one line each, numbers to the last bit, given shapes by their `content`. Equal
/// texts mean equal libraries, so the text is the key of a cache.
std::string recipe_text(const LibraryRecipe& recipe);

}  // namespace gyro

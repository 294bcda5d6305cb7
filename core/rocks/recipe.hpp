// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <string>

namespace gyro {

/// @throws BadInput a number is out of range
void check_recipe(const LibraryRecipe& recipe);

/// Everything that decides a library, one line each, numbers to the last bit, shape files by content.
/// @throws BadInput a shape file cannot be read
std::string recipe_text(const LibraryRecipe& recipe);

/// 128-bit FNV-1a hash, 32 hexadecimal digits.
std::string fnv1a_128(std::string_view bytes);

}  // namespace gyro

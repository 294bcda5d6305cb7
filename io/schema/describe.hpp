// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace gyro {

/// Documentation of a key and of all keys below it, or of the whole case file for an empty key. For each key it gives
/// type, unit, range, default and one sentence.
/// @throws BadInput for an unknown key, with a suggestion
std::string describe(const std::string& key = {});

/// JSON Schema (draft-07) of the case file, for editors.
std::string json_schema();

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace gyro {

/// Documentation of a key (type, unit, default, range, one line), of all keys below a section, or
/// of the whole file for an empty key.
/// @throws BadInput for an unknown key, with a suggestion
std::string describe(const std::string& key = {});

/// JSON Schema (draft-07) of the case file, for editors.
std::string json_schema();

}  // namespace gyro

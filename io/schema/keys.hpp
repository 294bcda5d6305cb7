// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/schema/schema.hpp"

#include <vector>

// For use in io/schema only: the parts of the table of keys that schema_keys() puts together.

namespace gyro {

constexpr Range positive{.low = 0, .low_open = true};
constexpr Range not_negative{.low = 0};

/// The keys of the section `drivetrain`.
const std::vector<Key>& drivetrain_keys();

}  // namespace gyro

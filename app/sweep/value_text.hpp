// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/yaml/yaml_tree.hpp"

#include <string>

namespace gyro {

/// A value of a sweep file as YAML on one line, which reads back to the same value.
std::string value_text(const YamlNode& node);

}  // namespace gyro

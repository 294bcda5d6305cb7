// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace gyro {

/// 128-bit FNV-1a hash, as 32 hexadecimal digits.
std::string fnv1a_128(std::string_view bytes);

}  // namespace gyro

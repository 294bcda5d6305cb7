// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gyro {

/// Bytes as text of A to Z, a to z, 0 to 9, + and /, filled up with = (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// The bytes of such a text. Nothing if base64() would not have given the text: white space, another character, = too
/// many or too few, or bits that belong to no byte.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace gyro

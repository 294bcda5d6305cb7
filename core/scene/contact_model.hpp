// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace gyro {

/// Normal force law of a pair of materials, with the words of a case in the same order; the laws are in
/// core/laws/contact.
enum class NormalModel : std::int32_t { hertz, hysteretic };
inline constexpr const char* normal_model_words = "hertz|hysteretic";

/// Law of rolling resistance of a pair of materials. `off`, which no case names, is taken where the coefficient is
/// zero.
enum class RollingModel : std::int32_t { constant, spring_dashpot, off };
inline constexpr const char* rolling_model_words = "constant|spring_dashpot";

/// Contact law of a pair of materials.
struct ContactModel {
  NormalModel normal = NormalModel::hertz;
  RollingModel rolling = RollingModel::constant;

  friend bool operator==(const ContactModel&, const ContactModel&) = default;
};

}  // namespace gyro

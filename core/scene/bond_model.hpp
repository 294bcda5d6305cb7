// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace gyro {

/// Failure criterion of the bonds, with the words of a case in the same order; the criteria are in
/// core/laws/bond/failure.hpp.
enum class BondFailure : std::int32_t { constant, mohr_coulomb };
inline constexpr const char* bond_failure_words = "constant|mohr_coulomb";

/// Law of all bonds of a scene.
struct BondModel {
  BondFailure failure = BondFailure::constant;

  friend bool operator==(const BondModel&, const BondModel&) = default;
};

}  // namespace gyro

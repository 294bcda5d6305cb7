// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/ceiling/bond_loop.hpp"
#include "app/bench/ceiling/unit_rates.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <vector>

namespace gyro::bench {

/// Times of both precisions.
struct UnitTimes {
  OperationTimes of_double, of_float;
};

/// Least time for the arithmetic of one bond [ns].
struct ArithmeticTime {
  double sums;       ///< additions and multiplications
  double quotients;  ///< divisions and roots, which a unit of their own does meanwhile
  double least() const { return sums > quotients ? sums : quotients; }
};
ArithmeticTime arithmetic_time(const BondOperations& operations, const UnitTimes& times);

/// Cost of the bonds of a rock in cache beside the least time that their arithmetic takes on this machine.
struct BondCeiling {
  Precision precision;
  BondOperations operations;    ///< of one bond
  UnitTimes times;              ///< in packs that fill a vector register
  double measured, one_by_one;  ///< time of a bond in the kernel, in packs and alone [ns]

  ArithmeticTime ceiling() const { return arithmetic_time(operations, times); }
  double ratio() const { return measured / ceiling().least(); }
};

/// Measures all in turn, `rounds` times, and keeps the shortest times: other programs only make them longer.
std::vector<BondCeiling> measure_bond_ceiling(std::span<const Precision> precisions, int rounds = 100);

void print(std::span<const BondCeiling> ceilings);
nlohmann::ordered_json to_json(const BondCeiling& ceiling);

}  // namespace gyro::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/ceiling/traced.hpp"
#include "core/scene/precision.hpp"

#include <functional>

namespace gyro::bench {

/// What the evaluation of one intact bond takes: the kernel of the bonds runs on traced numbers.
struct BondOperations {
  OperationCounts in_double, in_single;
};
BondOperations bond_operations(Precision precision);

/// The bonds of one rock of 136 particles, evaluated again and again by the kernel of the solver. The particles do not
/// move, so that all of it stays in the caches next to the core.
struct BondLoop {
  int bonds;  ///< of a pass
  /// Evaluates all bonds so many times, in packs as the solver does, or one by one.
  std::function<void(int passes)> in_packs, one_by_one;
};
BondLoop bond_loop(Precision precision);

/// Processor time of this thread that `work` takes [s].
double seconds_of(const std::function<void()>& work);

}  // namespace gyro::bench

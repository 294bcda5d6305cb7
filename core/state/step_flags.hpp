// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

namespace gyro {

/// What kernels report without a reduction: flags, and the number of failed bonds.
struct StepFlags {
  std::int32_t moved_too_far;    ///< a particle left the bound for which the list of pairs holds
  std::int32_t block_cracked;    ///< the first bond of a rock failed whose bonded pairs are not listed
  std::int32_t failures;         ///< bonds that have failed in this window
  std::int32_t limit_exceeded;   ///< a step passed one of Scene::limits
  std::int32_t rock_overloaded;  ///< the bonds of a rigid rock must be evaluated again
  std::int32_t rows_lacking;     ///< particles of rigid rocks are loaded that have no rows of a load table
};

/// How far a device has come that takes steps while the host does not look.
struct StepProgress {
  std::int32_t step;    ///< of the window, the last whose positions are known; 0: before the first
  std::int32_t halted;  ///< 1: the host must act on the flags before the contact forces of that step
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/check.hpp"

// Cases of the group `generic` that need many spheres and minutes.

namespace gyro::verify {

/// Outflow of silos.
void silo(Recorder& out);
/// Heaps that a lifted cylinder leaves.
void repose(Recorder& out);

}  // namespace gyro::verify

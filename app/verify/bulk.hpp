// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/check.hpp"

// Cases of the group `generic` that need thousands of spheres and minutes.

namespace gyro::verify {

/// Outflow of silos against Beverloo's law.
void silo(Recorder& out);
/// Angle of repose of heaps under a lifted cylinder: no closed form; recorded, and monotone in both frictions.
void repose(Recorder& out);

}  // namespace gyro::verify

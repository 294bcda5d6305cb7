// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem.hpp"

#include <memory>

namespace gyro {

/// Number type of the loads; positions, turns and velocities are double in both.
enum class Loads { single, double_ };

/// A scene on the CPU.
/// @param threads  at least 1; results do not depend on it
/// @throws BadInput for walls that cannot be used
std::unique_ptr<Dem> make_cpu_dem(const Scene& scene, Loads loads, int threads);

}  // namespace gyro

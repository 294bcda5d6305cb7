// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"
#include "core/scene/precision.hpp"

#include <memory>

namespace gyro {

/// A scene on the CPU.
/// @param threads  at least 1; results do not depend on it
/// @throws BadInput for walls that cannot be used
std::unique_ptr<Dem> make_cpu_dem(const Scene& scene, Precision precision, int threads);

}  // namespace gyro

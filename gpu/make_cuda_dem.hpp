// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/make_dem.hpp"

#include <string>

namespace gyro {

/// A scene on the first CUDA device; the same bits as make_cpu_dem gives.
/// @throws NoDevice with the driver's reason when there is no device to use; BadInput as make_cpu_dem
std::unique_ptr<Dem> make_cuda_dem(const Scene& scene, Precision precision);

/// Whether there is a device and a driver for it. Never throws.
bool cuda_device_is_there();

/// One line on devices, driver and toolkit, for `info` and the log. Never throws.
std::string cuda_device_report();

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/make_dem.hpp"

#include <memory>
#include <string>

namespace gyro {

/// Where a run computes.
struct Device {
  bool cuda = false;
  int threads = 1;   ///< of the CPU engine
  std::string name;  ///< for records: "cpu" or the GPU's name
};

/// @param asked    auto, cpu or cuda; auto takes a CUDA device where there is one: the bits are those of the CPU
/// @param threads  0: all cores
/// @throws NoDevice when cuda is asked for and not there
Device choose_device(const std::string& asked, int threads);

std::unique_ptr<Dem> make_dem(const Device& device, const Scene& scene, Precision precision);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/device.hpp"
#include "app/simulation/simulation.hpp"
#include "io/case/case.hpp"

#include <string>
#include <vector>

namespace gyro {

/// The small crusher of cases/crush.yaml in this process, on one CPU thread with single loads.
struct SmallCrusher {
  /// @param set  as `--set`
  explicit SmallCrusher(const std::vector<std::string>& set)
      : input(load_case(GYRO_APP_CASES "/crush.yaml", set).loaded.value()),
        assembly(assemble(input)),
        simulation(input, assembly, make_dem(Device{}, assembly.scene, Precision::mixed)) {}

  Case input;
  Assembly assembly;
  Simulation simulation;
};

}  // namespace gyro

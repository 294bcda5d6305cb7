// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/simulation/device.hpp"
#include "io/case/case.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// The small crusher of cases/crush.yaml in this process, on one CPU thread with single loads.
struct SmallCrusher {
  /// @param set  as `--set`
  explicit SmallCrusher(const std::vector<std::string>& set)
      : input(load_case(GYRO_APP_CASES "/crush.yaml", set).loaded.value()),
        assembly(assemble(input)),
        empty(make_dem(Device{}, assembly.setup.scene, Precision::mixed)),
        dem(*empty),
        made(make_simulation(input, assembly.setup, std::move(empty))),
        simulation(*made) {}

  Case input;
  Assembly assembly;
  std::unique_ptr<Dem> empty;  ///< given to the simulation
  Dem& dem;                    ///< owned by the simulation; for tests that disturb it
  std::unique_ptr<Simulation> made;
  Simulation& simulation;
};

}  // namespace gyro

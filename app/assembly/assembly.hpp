// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/expected_counts.hpp"
#include "app/assembly/resolution.hpp"
#include "app/assembly/walls.hpp"
#include "app/simulation/simulation.hpp"
#include "app/simulation/time_step.hpp"
#include "io/case/case.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// The setup of a case and data for its output. Only app/assembly knows both cases and setups.
struct Assembly {
  Setup setup;
  StepChoice step;
  std::optional<Liners> liners;  ///< of a crusher given by its profile
  std::vector<WallPicture> pictures;
  ExpectedCounts expected;
  std::optional<Resolution> resolution;  ///< of a crusher's product; none without rock that can break
  double start_mass = 0;                 ///< of start state and filling, with a feed; less of it may find room [kg]
  std::vector<std::string> notes;        ///< repairs of input files and other remarks, for the log
};

/// How a case is assembled.
struct AssemblyRequest {
  int threads = 0;                     ///< that make the library of rocks; 0: all cores
  std::optional<double> until = {};    ///< end of the run in place of time.duration [s]
  LibraryProgress library_progress{};  ///< empty, or told of each rock of the library
};

/// Makes the setup of a case.
/// @throws BadKey for files that cannot be used, a library that cannot be made, a step above its limit, more
/// rock or steps than can be run; BadInput for an impossible `until`
Assembly assemble(const Case& input, const AssemblyRequest& request = {});

/// Sieves of product and hold-up: those of the case, or else the default series; increasing [m].
const std::vector<double>& sieves_of(const Case& input);

/// The simulation of an assembled case; opens its drive.
/// @param dem    empty scene made from setup.scene
/// @param saved  see Simulation
/// @throws BadKey if drive, start state or feed cannot be made; BadInput for the saved state of another run
std::unique_ptr<Simulation> make_simulation(const Case& input, Setup setup, std::unique_ptr<Dem> dem,
                                            const SavedState* saved = nullptr);

}  // namespace gyro

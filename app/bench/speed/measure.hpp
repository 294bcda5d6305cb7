// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/precision.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace gyro::bench {

/// One run of a scene.
struct SpeedRun {
  std::filesystem::path file;  ///< case
  std::vector<std::string> overrides = {};
  int threads = 1;
  Precision precision = Precision::mixed;
  int warm_up = 0, timed = 0;  ///< steps, or windows
  bool whole_windows = false;  ///< count windows in place of steps: their ends have a cost of their own
};

/// What was measured in the timed steps of a run.
struct SpeedMeasurement {
  std::int64_t particles = 0, bonds = 0;  ///< bonds: intact at the end
  std::int64_t steps = 0;                 ///< timed
  int substeps = 1;                       ///< most of a rock in a step
  double time_step = 0;                   ///< [s]
  double wall_seconds = 0, cpu_seconds = 0;
  double setup_seconds = 0;                            ///< wall time from the case file to the first step
  std::int64_t bytes = 0;                              ///< by which the process grew at its peak, set-up included
  std::int64_t bond_steps = 0;                         ///< intact bonds, added up over the steps
  std::int64_t contacts = 0;                           ///< pairs and walls that touch at the end
  std::int64_t rebuilds = 0;                           ///< of the neighbour lists
  double kinetic = 0, rotation = 0;                    ///< energies at the end, of translation and of rotation [J]
  std::vector<std::pair<std::string, double>> phases;  ///< wall seconds

  template <class F, class... M>
  static constexpr void for_each_field(F&& f, M&... m) {
    f("particles", m.particles...);
    f("bonds", m.bonds...);
    f("steps", m.steps...);
    f("substeps", m.substeps...);
    f("time_step", m.time_step...);
    f("wall_seconds", m.wall_seconds...);
    f("cpu_seconds", m.cpu_seconds...);
    f("setup_seconds", m.setup_seconds...);
    f("bytes", m.bytes...);
    f("bond_steps", m.bond_steps...);
    f("contacts", m.contacts...);
    f("rebuilds", m.rebuilds...);
    f("kinetic", m.kinetic...);
    f("rotation", m.rotation...);
    f("phases", m.phases...);
  }
};

nlohmann::json to_json(const SpeedMeasurement& measurement);
SpeedMeasurement measurement_of(const nlohmann::json& j);

/// Does a run in this process, which has done nothing large before, so that its peak of memory belongs to the run.
/// @throws BadInput for a case that cannot be used; StoppedByGuard when the guard ends the run
SpeedMeasurement measure_speed(const SpeedRun& run);

}  // namespace gyro::bench

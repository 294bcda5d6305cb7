// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/speed/start_state.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro::bench {

/// A scene of `bench speed`.
struct SpeedScene {
  std::string name;
  std::string title;
  std::string file;                                  ///< case, in the folder of the cases
  std::vector<std::string> overrides = {};           ///< of the case
  StartState (*make)(const StartRecipe&) = nullptr;  ///< null: the case has all that it needs
  StartRecipe recipe = {};                           ///< unless the command line asks for another
  int warm_up = 0;                                   ///< steps before the clock starts; windows without a start state
  int timed = 0;                                     ///< steps, or windows, while it runs
  bool asked_only = false;                           ///< too long for a run of all scenes
};

/// S1, S2, S2r, S3, Q, C and F.
std::span<const SpeedScene> speed_scenes();

/// @throws BadInput, with the names that there are, for another name
SpeedScene scene_named(const std::string& name);

}  // namespace gyro::bench

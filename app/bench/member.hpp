// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/knobs.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace gyro::bench {

/// One run of an ensemble: a scene, a setting, a seed.
struct Member {
  const AccuracyScene* scene;
  std::filesystem::path folder;  ///< of the scenes
  KnobSetting setting;
  int seed;
};

/// What came of it.
struct MemberResult {
  std::map<std::string, double> values;  ///< by metric; not a number where there was nothing to measure
  double cpu_seconds = 0;                ///< of the one thread, stepping only: no set-up, no look at fragments
  double simulated_seconds = 0;
  double time_step = 0, time_step_limit = 0;  ///< [s]
  std::optional<std::string> stopped;         ///< by the guard, and why
};

/// Runs a member on the calling thread.
/// @throws BadInput for a bad case or setting
MemberResult run_member(const Member& member);

/// Why a case may not ask for a setting; empty if it may.
std::string refusal(const Member& member);

/// Text that tells whether a scene is still the one that a reference was made with: of its case and
/// the tables it names, comments and blanks at the ends of lines apart. FNV-1a, 64 bits, in hexadecimal.
std::string fingerprint(const AccuracyScene& scene, const std::filesystem::path& folder);

}  // namespace gyro::bench

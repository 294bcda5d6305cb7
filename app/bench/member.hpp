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

/// Results of a member.
struct MemberResult {
  std::map<std::string, double> values;  ///< by metric; NaN if there was nothing to measure
  double cpu_seconds = 0;                ///< of its one thread for stepping, without set-up and evaluation of fragments
  double simulated_seconds = 0;
  double time_step = 0, time_step_limit = 0;  ///< [s]
  std::optional<std::string> stopped;         ///< reason, if the guard stopped it
};

/// Runs a member on the calling thread.
/// @throws BadInput for a bad case or setting
MemberResult run_member(const Member& member);

/// Reason why a case may not use this setting; empty if it may.
std::string refusal(const Member& member);

/// Hash of a scene's case and tables without comments and blanks at the ends of lines; shows whether the scene has
/// changed since a reference was made. FNV-1a, 64 bits, in hexadecimal.
std::string fingerprint(const AccuracyScene& scene, const std::filesystem::path& folder);

}  // namespace gyro::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/run_data.hpp"

#include <string>
#include <vector>

namespace gyro::report {

/// What can be said of a run in words, for readers who have never seen the program.
struct Verdict {
  enum class Tone { good, caution, bad };

  Tone tone = Tone::good;
  std::string headline;            ///< "Start-up of 3.8 gyrations: no steady figures"
  std::string lead;                ///< one or two sentences
  std::vector<std::string> trust;  ///< sentences on what can be trusted, the weightiest first
};

Verdict verdict(const RunData& run);

}  // namespace gyro::report

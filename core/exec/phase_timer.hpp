// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// Wall time by phase of a step. Labels are string literals; a run has about twenty.
class PhaseTimer {
 public:
  using Clock = std::chrono::steady_clock;
  struct Mark {
    std::size_t phase;
    Clock::time_point since;
  };

  Mark begin(const char* label) {
    std::size_t k = 0;
    while (k < count_ && phases_[k].label != label && std::strcmp(phases_[k].label, label) != 0) ++k;
    if (k == count_ && count_ + 1 < phases_.size()) phases_[count_++] = {label, 0};
    return {k, Clock::now()};
  }
  void end(const Mark& mark) {
    phases_[mark.phase].seconds += std::chrono::duration<double>(Clock::now() - mark.since).count();
  }

  /// Label and seconds of each phase, in order of first use.
  std::vector<std::pair<std::string, double>> seconds() const {
    std::vector<std::pair<std::string, double>> out;
    for (std::size_t k = 0; k < count_; ++k) out.emplace_back(phases_[k].label, phases_[k].seconds);
    return out;
  }

 private:
  struct Phase {
    const char* label = "";
    double seconds = 0;
  };
  std::array<Phase, 64> phases_;
  std::size_t count_ = 0;
};

}  // namespace gyro

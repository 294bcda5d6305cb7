// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/first_break.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro::bench {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double name_of(const Breakage& b) {
  const auto [low, high] = std::minmax(b.i, b.j);
  return std::ldexp(static_cast<double>(low), 26) + static_cast<double>(high);
}

}  // namespace

FirstBreak::FirstBreak() : time_(unknown), force_(unknown), bond_(unknown), before_(unknown), last_(unknown) {}

void FirstBreak::see(const Window& window, double force, const std::vector<Breakage>& breakages) {
  if (seen_) return;
  if (breakages.empty()) {
    before_ = last_;
    last_ = force;
    return;
  }
  seen_ = true;
  time_ = breakages.front().time;
  bond_ = name_of(breakages.front());
  // The means are the forces in the middle of their windows; extrapolate to the time of the break.
  const double since_last = time_ - (window.begin() - 0.5 * window.length());
  force_ = last_ + (last_ - before_) * since_last / window.length();
}

}  // namespace gyro::bench

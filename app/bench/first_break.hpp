// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"

#include <vector>

namespace gyro::bench {

/// Finds the first bond that breaks, and the force of the tool at that moment.
class FirstBreak {
 public:
  FirstBreak();
  /// Adds a window; call it for all windows in their order.
  /// @param force       of the tool, mean over the window [N]
  /// @param breakages   of the window, by time
  void see(const Window& window, double force, const std::vector<Breakage>& breakages);

  bool seen() const { return seen_; }
  // NaN until the first bond breaks.
  double time() const { return time_; }  ///< [s]
  double force() const {
    return force_;
  }                                      ///< the means of the last two whole windows before, drawn out to the break [N]
  double bond() const { return bond_; }  ///< identifies the bond: i 2^26 + j with particle ids i < j

 private:
  bool seen_ = false;
  double time_, force_, bond_;
  double before_, last_;  ///< means of the two windows before the present one [N]
};

}  // namespace gyro::bench

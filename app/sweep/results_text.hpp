// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/results.hpp"

#include <string>

namespace gyro {

/// Means and standard errors of the headline figures over the seeds of each setting, as a table for the terminal. The
/// figures of the steady part are shown if all points that are done have become steady, otherwise those of the whole
/// runs.
std::string results_text(const SweepResults& results);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/run_output.hpp"
#include "app/simulation/simulation.hpp"
#include "io/run/summary.hpp"

namespace gyro {

/// Adds what the run has come to so far: counts, residuals, and the figures of product and drive where there are such.
/// The series must have been taken up to now.
void add_figures(Summary& summary, const Case& input, const Assembly& assembly, const Simulation& simulation,
                 const RunOutput& output);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/run_output.hpp"
#include "app/simulation/simulation.hpp"
#include "io/run/summary.hpp"

namespace gyro {

/// Adds the results of the run so far: counts, residuals, and the figures of product and drive if it has them.
/// All windows so far must have been added to the output.
void add_figures(Summary& summary, const Case& input, const Assembly& assembly, const Simulation& simulation,
                 const RunOutput& output);

}  // namespace gyro

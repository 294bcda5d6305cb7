// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/output/tables/tables.hpp"
#include "app/simulation/simulation.hpp"

#include <span>

namespace gyro {

/// Which outputs a run has.
OutputForm output_form(const Case& input, const Assembly& assembly);

/// The window that the simulation has just completed.
WindowReading read_window(const WindowResult& result, const Simulation& simulation);

/// Whether all that the window gives to the tables is finite; a guard stops the run where it is not.
bool is_finite(const WindowResult& result, const Simulation& simulation);

/// The present state of the simulation, without interval, mass discharged before and wall clock, which the caller sets.
/// @param probes  ids of output.probes
SeriesReading read_series(const Simulation& simulation, std::span<const std::uint32_t> probes);
LedgerReading read_ledger(const Simulation& simulation);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"
#include "core/rocks/stability.hpp"

#include <optional>
#include <string>

namespace gyro {

/// What the time step has to satisfy.
struct StepRequest {
  double window = 0.5e-3;           ///< length of the longest window, a whole number of steps [s]
  std::optional<double> step = {};  ///< largest step [s]; none: safety x limit
  double safety = 0.7;              ///< step / stability limit [-]
};

/// A time step and what limits it.
struct StepChoice {
  double dt = 0;     ///< [s]
  double limit = 0;  ///< stability limit of the damped step map, before the safety factor; infinite without rock [s]
  std::string limited_by;    ///< rock, particle or wall that sets the limit
  double contact_limit = 0;  ///< of contacts of the smallest loose particle, infinite without one [s]
  int steps_per_window = 0;  ///< a multiple of scene.substeps
};

/// Contacts that a particle may collect in a dense bed: six, each with an overlap of 5 % of the radius. That is more
/// than a bed of stable runs shows, and bounds wall contacts, which are stiffer but fewer. Stiffnesses by Hertz and
/// Mindlin.
BedContacts bed_contacts(const Scene& scene);

/// Of the particles of library and start; infinite if there is none [m].
double smallest_radius(const RockLibrary& library, std::span<const NewRock> start);

/// Chooses the step: `safety` times the smallest limit of all rocks of library and start and of the smallest loose
/// particle, made to divide the window; or the step that is asked for. No wall of given motion may move by more than
/// scene.limits.speed_ratio of the smallest radius in a step; walls that a drivetrain moves are checked by the ledger.
/// @throws BadInput for a step that is asked for and above its limit
StepChoice choose_step(const Setup& setup, const StepRequest& request = {});

/// Held contact forces are a leapfrog of the contacts with a step of the whole hold, which must stay below half of the
/// limit of contacts. @throws BadInput otherwise
void check_hold(const StepChoice& choice, int substeps);

/// choose_step and check_hold, and puts the choice into the setup. @throws BadInput as they do
StepChoice set_step(Setup& setup, const StepRequest& request = {});
/// Puts a choice into the setup.
void set_step(Setup& setup, const StepChoice& choice);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"
#include "core/base/errors.hpp"
#include "core/rocks/stability.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// How often contact and wall forces are evaluated, and bonds.
struct Rates {
  enum class Kind {
    uniform,    ///< all rocks take `substeps` steps of their bonds in a step of the scene
    automatic,  ///< the step of the scene from the limit of contacts, that of each rock from the limit of its bonds
    given,      ///< the same, with a given step of the scene
  };
  Kind kind = Kind::uniform;
  int substeps = 1;  ///< of uniform
  double hold = 0;   ///< of given: largest step of the scene [s]
  /// Largest step of the scene / undamped stability limit of contacts, where rocks have sub-steps; at most 0.35 for
  /// bonds with less than 1 % of critical damping.
  double share = 0.5;
};

/// What the time steps have to satisfy.
struct StepRequest {
  double window = 0.5e-3;           ///< length of the longest window, a whole number of steps [s]
  std::optional<double> step = {};  ///< largest step of bonds [s]; none: safety x limit
  double safety = 0.7;              ///< step / stability limit [-]
  Rates rates = {};
};

/// Time steps and what limits them.
struct StepChoice {
  double dt = 0;           ///< of the scene: contact and wall forces are evaluated once in it [s]
  double bond_step = 0;    ///< the smallest of a rock's bonds; dt without sub-steps [s]
  double limit = 0;        ///< stability limit of bond_step, before the safety factor; infinite without rock [s]
  std::string limited_by;  ///< rock, particle or wall that sets it
  /// Undamped, of contacts of the smallest loose particle, infinite without one [s].
  double contact_limit = 0;
  std::string hold_limited_by;  ///< particle or wall that sets dt, if rocks have sub-steps
  int steps_per_window = 0;
  std::vector<int> of_library, of_start;   ///< sub-steps of each rock of library and start
  int min_substeps = 1, max_substeps = 1;  ///< of all rocks with bonds
};

/// Contacts that a particle may collect in a dense bed: six, each with an overlap of 5 % of the radius. That is more
/// than a bed of stable runs shows, and bounds wall contacts, which are stiffer but fewer. Stiffnesses by Hertz and
/// Mindlin.
BedContacts bed_contacts(const Scene& scene);

/// Of the particles of library and start; infinite if there is none [m].
double smallest_radius(const RockLibrary& library, std::span<const NewRock> start);

/// Chooses the steps so that they divide the window.
///
/// Rates::uniform with k sub-steps: the step of bonds is `safety` times the smallest limit of all rocks of library and
/// start, with their bonds and with what they touch, and of the smallest loose particle. That of the scene is k times
/// as long, and at most Rates::share of the undamped limit of contacts if k > 1.
///
/// Rates::automatic: the step of the scene is Rates::share of the undamped limit of contacts of the smallest loose
/// particle; a rock has as many sub-steps as `safety` times the limit of its bonds alone asks for. A half, because
/// forces that are held act as a leapfrog of contacts with the longer step, and their dashpots are capped
/// (core/laws/contact/dashpots.hpp).
///
/// `safety` below its default reduces that share in proportion. A scene without bonded rock has the steps of
/// Rates::uniform, and a given step of the scene is then the largest of all.
///
/// No wall of given motion may move by more than scene.limits.speed_ratio of the smallest radius in a step of the
/// scene; walls that a drivetrain moves are checked by the ledger.
/// @throws BadInput for steps that are asked for and above their limits, BadHold if that is the step of the scene
StepChoice choose_step(const Setup& setup, const StepRequest& request = {});

/// The step of the scene that was asked for, or follows from the sub-steps asked for, is above its limit.
struct BadHold : BadInput {
  using BadInput::BadInput;
};

/// choose_step, and puts the choice into the setup. @throws BadInput as it does
StepChoice set_step(Setup& setup, const StepRequest& request = {});
/// Puts a choice into the setup.
void set_step(Setup& setup, const StepChoice& choice);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"
#include "core/rocks/stability.hpp"
#include "core/scene/dem.hpp"
#include "io/case/case.hpp"

#include <span>
#include <string>

namespace gyro {

/// The time step of a run and where it comes from.
struct StepChoice {
  double dt = 0;           ///< [s]; a whole number of them is a coupling interval
  double limit = 0;        ///< stability limit of the damped step map, before the safety factor [s]
  std::string limited_by;  ///< rock, particle or wall that sets the limit
  int per_window = 0;      ///< steps in a coupling interval
};

/// Contacts that a particle may collect in a dense bed: six, each pressed in by 5 % of the radius.
/// That is more than a bed of stable runs shows and bounds wall contacts, which are stiffer but fewer.
BedContacts bed_contacts(const Scene& scene);

/// Bond parameters of the law from a case.
BondParameters bond_parameters(const CaseBonds& bonds);

/// A rock of a start state in the form of a template, for its critical step.
RockTemplate as_template(const NewRock& rock, const std::string& name);

/// Chooses the step: `safety` times the least limit of all rocks and of the smallest loose particle,
/// made to divide the coupling interval; or the step that the case gives. No wall whose motion the case gives may
/// move by more than 0.2 of the smallest radius in a step; of walls that a drivetrain moves the ledger sees it.
/// @throws BadKey for a given step above `safety` times its limit
StepChoice choose_step(const Case& input, const Scene& scene, const RockLibrary& library,
                       std::span<const NewRock> start);

}  // namespace gyro

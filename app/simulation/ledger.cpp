// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace gyro {

void Ledger::open(const EnergyTerms& before) {
  state_.potential_before = before.potential;
  note_energy(before);
}

std::optional<std::string> Ledger::close(double time, const EnergyTerms& after, const Extremes& extremes) {
  State& s = state_;
  const double fallen = s.potential_before - after.potential;
  s.gravity_turnover += std::abs(fallen);
  s.energy = after;
  extremes_ = extremes;
  power_ = time > s.time ? std::abs(work() - s.work_before) / (time - s.time) : 0;
  s.time = time;
  s.work_before = work();
  s.overlap_ratio = extremes.overlap_ratio;
  s.worst_overlap = std::max(s.worst_overlap, extremes.overlap_ratio);
  note_energy(after);
  return verdict(time);
}

void Ledger::note_energy(const EnergyTerms& now) {
  state_.largest_state = std::max(state_.largest_state, now.kinetic + now.contact_elastic + now.bond_elastic);
}

double Ledger::work() const {
  return std::abs(state_.energy.wall_work) + state_.gravity_turnover;
}

double Ledger::residual_fraction() const {
  const double measure = scale();  // not a number where an energy is not
  return measure == 0 ? 0 : state_.energy.residual() / measure;
}

double Ledger::scale() const {
  return std::max(work(), state_.largest_state);
}

std::string Ledger::wall_name(Index wall) const {
  const auto k = static_cast<std::size_t>(wall);
  return "wall " + (k < walls_.size() ? walls_[k] : "number " + std::to_string(wall + 1));
}

/// Which limit of a single step was passed; empty if none.
std::string Ledger::passed_limit() const {
  const Extremes& x = extremes_;
  const StepLimits& maximum = limits_.step;
  std::ostringstream why;
  why.precision(4);
  if (!x.finite) {
    why << "particle " << x.culprit
        << " has a position or velocity that is not finite; reduce time.safety, or check the start state around it";
  } else if (x.overlap_ratio > maximum.overlap_ratio) {
    why << "a contact of particle " << x.culprit << " with ";
    if (x.wall == none)
      why << "particle " << x.partner;
    else
      why << wall_name(x.wall);
    why << " overlaps by " << x.overlap_ratio << " of the radius; at most " << maximum.overlap_ratio
        << ". The material is too soft for this load: raise its shear_modulus, or reduce speeds";
  } else if (x.speed_ratio > maximum.speed_ratio) {
    why << "particle " << x.fastest << " moves by " << x.speed_ratio << " of its radius in a step; at most "
        << maximum.speed_ratio << ". Reduce time.safety, or its speed";
  } else if (x.wall_step > maximum.speed_ratio) {
    why << wall_name(x.fast_wall) << " moves by " << x.wall_step << " of the smallest radius in a step; at most "
        << maximum.speed_ratio << ". Reduce time.safety, or the speed of the wall";
  } else if (x.rotation > maximum.rotation) {
    why << "particle " << x.fastest_rotating << " rotates by " << x.rotation << " rad in a step; at most "
        << maximum.rotation << ". Reduce time.safety, or its angular velocity";
  } else if (x.contact_step > maximum.contact_step) {
    why << "the step is " << x.contact_step << " times the stability limit of the " << x.crowd
        << " contacts of particle " << x.crowded
        << ": it is pressed harder than the choice of the step assumes. Reduce numerics.hold or time.safety";
  } else if (x.bond_rotation > maximum.bond_rotation) {
    why << "a bond of particle " << x.twisted << " is bent by " << x.bond_rotation << " rad without failing; at most "
        << maximum.bond_rotation
        << ". The bonds are too soft for their strength: raise their stiffness, or lower their "
        << "strength";
  }
  return why.str();
}

std::string stopped_at(double time, const std::string& why) {
  return "stopped at t = " + std::to_string(time) + " s: " + why;
}

std::optional<std::string> Ledger::verdict(double time) const {
  std::ostringstream why;
  why.precision(4);
  if (const std::string passed = passed_limit(); !passed.empty()) {
    why << passed;
  } else {
    const double lag = limits_.lag_steps * limits_.contact_step * power_;
    // Written so that a residual that is not a number does not pass.
    if (std::abs(state_.energy.residual()) <= limits_.energy_fraction * scale() + lag) return {};
    why << "the energy balance is off by " << state_.energy.residual() << " J, " << 100 * residual_fraction()
        << " % of the " << (work() < state_.largest_state ? "largest energy seen" : "work done") << "; at most "
        << 100 * limits_.energy_fraction << " %. Reduce time.safety to see whether the step is the cause";
  }
  return stopped_at(time, why.str());
}

void Ledger::restore(const State& state) {
  state_ = state;
  extremes_ = {};
  extremes_.overlap_ratio = state.overlap_ratio;
}

}  // namespace gyro

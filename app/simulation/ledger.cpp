// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace gyro {

std::optional<std::string> Ledger::close(double time, const EnergyTerms& after, const Extremes& extremes) {
  const double fallen = potential_before_ - after.potential;
  gravity_work_ += fallen;
  gravity_turnover_ += std::abs(fallen);
  energy_ = after;
  extremes_ = extremes;
  power_ = time > time_ ? std::abs(work() - work_before_) / (time - time_) : 0;
  time_ = time;
  work_before_ = work();
  worst_overlap_ = std::max(worst_overlap_, extremes.overlap_ratio);
  largest_state_ = std::max(largest_state_, after.kinetic + after.contact_elastic + after.bond_elastic);
  return verdict(time);
}

double Ledger::work() const {
  return std::abs(energy_.wall_work) + gravity_turnover_;
}

double Ledger::residual_fraction() const {
  return work() > 0 ? energy_.residual() / work() : 0;
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
    why << "particle " << x.culprit << " has a place or velocity that is not finite";
  } else if (x.overlap_ratio > maximum.overlap_ratio) {
    why << "a contact of particle " << x.culprit << " with ";
    if (x.wall == none)
      why << "particle " << x.partner;
    else
      why << wall_name(x.wall);
    why << " overlaps by " << x.overlap_ratio << " of the radius; at most " << maximum.overlap_ratio;
  } else if (x.speed_ratio > maximum.speed_ratio) {
    why << "particle " << x.fastest << " moves by " << x.speed_ratio << " of its radius in a step; at most "
        << maximum.speed_ratio;
  } else if (x.wall_step > maximum.speed_ratio) {
    why << wall_name(x.fast_wall) << " moves by " << x.wall_step << " of the smallest radius in a step; at most "
        << maximum.speed_ratio;
  } else if (x.rotation > maximum.rotation) {
    why << "particle " << x.fastest_rotating << " turns by " << x.rotation << " rad in a step; at most "
        << maximum.rotation;
  } else if (x.bond_rotation > maximum.bond_rotation) {
    why << "a bond of particle " << x.twisted << " is turned by " << x.bond_rotation << " rad without failing; at most "
        << maximum.bond_rotation;
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
    const bool little = work() < largest_state_;
    const double scale = little ? largest_state_ : work();
    const double lag = limits_.lag_steps * limits_.contact_step * power_;
    // A balance that is not a number must not pass for one that is small.
    if (std::abs(energy_.residual()) <= limits_.energy_fraction * scale + lag) return {};
    why << "the energy balance is off by " << energy_.residual() << " J, " << 100 * energy_.residual() / scale
        << " % of the " << (little ? "largest energy seen" : "work done") << "; at most "
        << 100 * limits_.energy_fraction << " %";
  }
  return stopped_at(time, why.str());
}

void Ledger::save(SavedState& to) const {
  const Extremes& x = extremes_;
  to.put_one("ledger/energy", energy_);
  to.put("ledger/extremes",
         std::vector<double>{double(x.finite), double(x.culprit), x.overlap_ratio, x.speed_ratio, x.rotation});
  to.put("ledger/sums", std::vector<double>{potential_before_, gravity_work_, gravity_turnover_, largest_state_,
                                            worst_overlap_, time_, work_before_});
}

void Ledger::restore(const SavedState& from) {
  energy_ = from.get_one<EnergyTerms>("ledger/energy");
  const std::vector<double> x = from.get<double>("ledger/extremes", 5), sums = from.get<double>("ledger/sums", 7);
  extremes_.finite = x[0] != 0;
  extremes_.culprit = static_cast<ParticleId>(x[1]);
  extremes_.overlap_ratio = x[2];
  extremes_.speed_ratio = x[3];
  extremes_.rotation = x[4];
  potential_before_ = sums[0];
  gravity_work_ = sums[1];
  gravity_turnover_ = sums[2];
  largest_state_ = sums[3];
  worst_overlap_ = sums[4];
  time_ = sums[5];
  work_before_ = sums[6];
}

}  // namespace gyro

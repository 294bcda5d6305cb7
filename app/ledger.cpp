// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ledger.hpp"

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
  worst_overlap_ = std::max(worst_overlap_, extremes.overlap_ratio);
  largest_state_ = std::max(largest_state_, after.kinetic + after.contact_elastic + after.bond_elastic);
  return verdict(time);
}

double Ledger::residual_fraction() const {
  const double work = std::abs(energy_.wall_work) + gravity_turnover_;
  return work > 0 ? energy_.residual() / work : 0;
}

std::optional<std::string> Ledger::verdict(double time) const {
  std::ostringstream why;
  why.precision(4);
  const auto id = extremes_.culprit;
  if (!extremes_.finite) {
    why << "particle " << id << " has a place or velocity that is not finite";
  } else if (extremes_.overlap_ratio > limits_.overlap_ratio) {
    why << "a contact of particle " << id << " overlaps by " << extremes_.overlap_ratio << " of the radius; at most "
        << limits_.overlap_ratio;
  } else if (extremes_.speed_ratio > limits_.speed_ratio) {
    why << "a particle moves by " << extremes_.speed_ratio << " of its radius in a step; at most "
        << limits_.speed_ratio;
  } else if (extremes_.turn > limits_.turn) {
    why << "a particle turns by " << extremes_.turn << " rad in a step; at most " << limits_.turn;
  } else {
    const double work = std::abs(energy_.wall_work) + gravity_turnover_;
    const bool little = work <= limits_.energy_floor * largest_state_ || work == 0;
    // A balance that is not a number must not pass for one that is small.
    if (std::isfinite(energy_.residual()) && (little || std::abs(residual_fraction()) <= limits_.energy_fraction))
      return {};
    why << "the energy balance is off by " << energy_.residual() << " J, " << 100 * residual_fraction()
        << " % of the work done; at most " << 100 * limits_.energy_fraction << " %";
  }
  return "stopped at t = " + std::to_string(time) + " s: " + why.str();
}

void Ledger::save(SavedState& to) const {
  const Extremes& x = extremes_;
  to.put_one("ledger/energy", energy_);
  to.put("ledger/extremes",
         std::vector<double>{double(x.finite), double(x.culprit), x.overlap_ratio, x.speed_ratio, x.turn});
  to.put("ledger/sums",
         std::vector<double>{potential_before_, gravity_work_, gravity_turnover_, largest_state_, worst_overlap_});
}

void Ledger::restore(const SavedState& from) {
  energy_ = from.get_one<EnergyTerms>("ledger/energy");
  const std::vector<double> x = from.get<double>("ledger/extremes", 5), sums = from.get<double>("ledger/sums", 5);
  extremes_ = {x[0] != 0, static_cast<ParticleId>(x[1]), x[2], x[3], x[4]};
  potential_before_ = sums[0];
  gravity_work_ = sums[1];
  gravity_turnover_ = sums[2];
  largest_state_ = sums[3];
  worst_overlap_ = sums[4];
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/check.hpp"

#include <cmath>

namespace gyro::verify {

void Recorder::record(const std::string& quantity, double measured, double reference, double error, double tolerance,
                      const std::string& source) {
  checks_.push_back({case_ + "/" + quantity, to_string(precision_), measured, reference, error, tolerance, source});
}

void Recorder::relative(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                        const std::string& source) {
  record(quantity, measured, reference, std::abs(measured / reference - 1),
         precision_ == Precision::mixed ? tolerance.in_mixed : tolerance.in_double, source);
}

void Recorder::absolute(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                        const std::string& source) {
  record(quantity, measured, reference, std::abs(measured - reference),
         precision_ == Precision::mixed ? tolerance.in_mixed : tolerance.in_double, source);
}

void Recorder::within(const std::string& quantity, double measured, double low, double high,
                      const std::string& source) {
  const double middle = 0.5 * (low + high);
  record(quantity, measured, middle, std::abs(measured - middle), 0.5 * (high - low), source);
}

std::vector<Case> all_cases() {
  using Group = std::span<const Case> (*)();
  constexpr Group groups[] = {
      hertz_cases,     restitution_cases, oblique_cases,     spin_cases,        rolling_cases, slip_cases,
      mesh_flat_cases, mesh_edge_cases,   mesh_motion_cases, mesh_tiling_cases, bond_cases,    beam_cases,
      wave_cases,      objectivity_cases, flight_cases,      modulus_cases,     energy_cases,  fragments_cases,
      strength_cases,  drivetrain_cases,  coupling_cases,    generic_cases,
  };
  std::vector<Case> all;
  for (const Group group : groups) {
    const std::span<const Case> cases = group();
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

std::vector<Check> run(const Case& verification) {
  std::vector<Check> checks;
  const auto in = [&](Precision precision) {
    Recorder recorder(verification.name, precision);
    verification.run(recorder);
    checks.insert(checks.end(), recorder.checks().begin(), recorder.checks().end());
  };
  if (verification.precisions != Case::Precisions::mixed) in(Precision::double_);
  if (verification.precisions != Case::Precisions::one) in(Precision::mixed);
  return checks;
}

}  // namespace gyro::verify

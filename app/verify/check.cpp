// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/check.hpp"

#include <cmath>

namespace gyro::verify {

void Recorder::record(const std::string& quantity, double measured, double reference, double error, double tolerance,
                      const std::string& source) {
  checks_.push_back({case_ + "/" + quantity, to_string(precision_), measured, reference, error, tolerance, source});
}

double Recorder::chosen(Tolerance tolerance) const {
  return precision_ == Precision::mixed ? tolerance.in_mixed : tolerance.in_double;
}

void Recorder::relative(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                        const std::string& source) {
  record(quantity, measured, reference, std::abs(measured / reference - 1), chosen(tolerance), source);
}

void Recorder::absolute(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                        const std::string& source) {
  record(quantity, measured, reference, std::abs(measured - reference), chosen(tolerance), source);
}

void Recorder::within(const std::string& quantity, double measured, double low, double high,
                      const std::string& source) {
  const double middle = 0.5 * (low + high);
  record(quantity, measured, middle, std::abs(measured - middle), 0.5 * (high - low), source);
}

}  // namespace gyro::verify

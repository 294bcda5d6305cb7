// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/steady_goal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gyro {
namespace {

/// Infinite for a figure of zero and for an error that no number of blocks gives.
double relative(const Estimate& e) {
  const double error = e.error / std::abs(e.value);
  return std::isfinite(error) ? error : SteadyProgress::unknown;
}

std::string percent(double error) {
  char text[40];
  if (!std::isfinite(error)) return "not known";
  std::snprintf(text, sizeof text, "%.2g %%", 100 * error);
  return text;
}

}  // namespace

double SteadyProgress::worst() const {
  return std::max({throughput, power, p80});
}

SteadyProgress steady_progress(const GyrationRecord& record, const std::vector<double>& sieves) {
  SteadyProgress progress;
  const std::optional<SteadyState> steady = steady_state(record, {}, {}, sieves);
  if (!steady) {
    progress.not_steady = unsteady_reason(record);
    return progress;
  }
  progress.from = steady->from;
  progress.gyrations = steady->gyrations;
  progress.throughput = relative(steady->throughput);
  progress.power = relative(steady->power);
  if (steady->p80) progress.p80 = relative(*steady->p80);
  return progress;
}

bool is_known(const SteadyProgress& progress, double error) {
  return progress.gyrations >= gyrations_of_errors && progress.worst() <= error;
}

std::string to_text(const SteadyProgress& p) {
  if (!p.not_steady.empty()) return p.not_steady;
  return "throughput " + percent(p.throughput) + ", crushing power " + percent(p.power) + ", P80 " + percent(p.p80);
}

}  // namespace gyro

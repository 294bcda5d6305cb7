// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/verification.hpp"

namespace gyro::verify {

std::vector<Check> run(const Verification& verification) {
  std::vector<Check> checks;
  const auto run_in = [&](Precision precision) {
    Recorder recorder(verification.name, precision);
    verification.run(recorder);
    checks.insert(checks.end(), recorder.checks().begin(), recorder.checks().end());
  };
  if (verification.precisions != Precisions::mixed_only) run_in(Precision::double_);
  if (verification.precisions != Precisions::double_only) run_in(Precision::mixed);
  return checks;
}

}  // namespace gyro::verify

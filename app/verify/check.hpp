// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/precision.hpp"

#include <string>
#include <vector>

namespace gyro::verify {

/// One line of `gyrosim verify`: a number measured in the engine, and the number from theory.
struct Check {
  std::string name;  ///< group/case/quantity, lower case
  std::string precision;
  double measured = 0, reference = 0;
  double error = 0;      ///< |measured - reference|, divided by |reference| if the check is relative
  double tolerance = 0;  ///< largest error that passes
  std::string source;    ///< of the reference
  bool pass() const { return error <= tolerance; }  // false if the error is NaN
};

/// Tolerances of a quantity in the two precisions.
struct Tolerance {
  double in_double, in_mixed;
};

/// Collects the checks of one case in one precision.
class Recorder {
 public:
  /// @param case_name  group/case
  Recorder(std::string case_name, Precision precision) : case_(std::move(case_name)), precision_(precision) {}

  Precision precision() const { return precision_; }

  /// |measured/reference - 1| <= tolerance.
  void relative(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                const std::string& source);
  /// |measured - reference| <= tolerance, in the quantity's own unit.
  void absolute(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                const std::string& source);
  /// low <= measured <= high; the reference is the middle.
  void within(const std::string& quantity, double measured, double low, double high, const std::string& source);

  const std::vector<Check>& checks() const { return checks_; }

 private:
  void record(const std::string& quantity, double measured, double reference, double error, double tolerance,
              const std::string& source);
  double chosen(Tolerance tolerance) const;

  std::string case_;
  Precision precision_;
  std::vector<Check> checks_;
};

}  // namespace gyro::verify

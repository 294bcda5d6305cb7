// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/make_dem.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro::verify {

/// One line of `gyrosim verify`: a number that the engine gave beside the number of theory.
struct Check {
  std::string name;  ///< group/case/quantity, lower case
  std::string precision;
  double measured = 0, reference = 0;
  double error = 0;      ///< |measured - reference|, over |reference| where the check is relative
  double tolerance = 0;  ///< of the error
  std::string source;    ///< of the reference
  bool pass() const { return error <= tolerance; }  // not a number passes nothing
};

/// Tolerances of a quantity in the two precisions.
struct Tolerance {
  double in_double, in_mixed;
};

/// Takes up the checks of one case in one precision.
class Recorder {
 public:
  Recorder(std::string case_name, Precision precision) : case_(std::move(case_name)), precision_(precision) {}

  Precision precision() const { return precision_; }

  /// |measured/reference - 1| <= tolerance.
  void relative(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                const std::string& source);
  /// |measured - reference| <= tolerance, in the quantity's own unit.
  void absolute(const std::string& quantity, double measured, double reference, Tolerance tolerance,
                const std::string& source);
  /// measured lies in [low, high]; the reference is the middle.
  void within(const std::string& quantity, double measured, double low, double high, const std::string& source);

  const std::vector<Check>& checks() const { return checks_; }

 private:
  void record(const std::string& quantity, double measured, double reference, double error, double tolerance,
              const std::string& source);

  std::string case_;
  Precision precision_;
  std::vector<Check> checks_;
};

/// A set-up whose answer is known: it runs the engine that runs crushers and records what came out.
struct Case {
  enum class When { always, nightly };
  /// one: nothing in it depends on the type of the loads, or double is enough; mixed: only in that, for its time.
  enum class Precisions { both, one, mixed };

  std::string name;  ///< group/case
  void (*run)(Recorder&);
  Precisions precisions = Precisions::both;
  When when = When::always;
};

// One function a group, in the file of its name; the group `mesh` has four.
std::span<const Case> hertz_cases();
std::span<const Case> restitution_cases();
std::span<const Case> bond_cases();
std::span<const Case> beam_cases();
std::span<const Case> wave_cases();
std::span<const Case> objectivity_cases();
std::span<const Case> flight_cases();
std::span<const Case> modulus_cases();
std::span<const Case> energy_cases();
std::span<const Case> fragments_cases();
std::span<const Case> strength_cases();
std::span<const Case> drivetrain_cases();
std::span<const Case> coupling_cases();
std::span<const Case> generic_cases();
std::span<const Case> oblique_cases();
std::span<const Case> spin_cases();
std::span<const Case> rolling_cases();
std::span<const Case> slip_cases();
std::span<const Case> mesh_flat_cases();
std::span<const Case> mesh_edge_cases();
std::span<const Case> mesh_motion_cases();
std::span<const Case> mesh_tiling_cases();

/// All cases in the order of the groups.
std::vector<Case> all_cases();

/// Runs a case in the precisions that it has.
std::vector<Check> run(const Case& verification);

}  // namespace gyro::verify

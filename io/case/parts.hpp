// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/case/case.hpp"
#include "io/schema/schema.hpp"

// The steps of load_case(), in their order: complete_settings, read_tables, check_settings, and build_case if no
// problem was found.

namespace gyro {

/// Collects problems and sorts them: first those of the case file, then those of the tables that it names, then those
/// of overrides.
class CaseProblems {
 public:
  explicit CaseProblems(std::string case_file) : case_file_(std::move(case_file)) {}
  void add(const Mark& mark, std::string message);
  void add_in_file(const std::filesystem::path& file, int line, int column, std::string message);
  bool empty() const { return problems_.empty(); }
  std::vector<CaseProblem> sorted() const;

 private:
  std::string case_file_;
  std::vector<CaseProblem> problems_;
};

/// The tables that a case names. A table that could not be read is empty.
struct CaseTables {
  std::vector<LinerRow> liners;
  std::vector<PassingPoint> sieves;
  CurveMotor motor;
  VoltageInput voltage;
  std::optional<CaseFmu> fmu;
  std::vector<StartParticle> particles;
  std::vector<StartBond> bonds;
};

/// Applies overrides `key.path=value` to a document's tree, in their order.
void apply_overrides(YamlNode& root, const std::vector<std::string>& overrides, CaseProblems& problems);

/// Makes paths absolute, reports missing files, and fills in the defaults that depend on other keys: the title, the
/// walls of a profile, motions, rocks.fill.exponent, feed.above, intervals of output.
void complete_settings(Setting& root, const std::filesystem::path& case_file, CaseProblems& problems);

/// Lengthens the intervals of `output` that are not given to a longer coupling.interval.
void complete_intervals(Setting& root);

/// Reads profile, sieves, motor curve, voltage, FMU, particles and bonds, and checks each of them by itself.
CaseTables read_tables(const Setting& root, CaseProblems& problems);

/// Reads the start state of `particles`.
void read_start_state(const Setting& particles, CaseTables& tables, CaseProblems& problems);

/// Reads the existing file of `drivetrain.fmu`: its description, and the variables and parameters that the case names.
void read_drive_fmu(const Setting& root, CaseTables& tables, CaseProblems& problems);

/// Checks the conditions between keys. Keys that have already been reported may be missing.
void check_settings(const Setting& root, CaseProblems& problems);

/// The part of check_settings() that compares the intervals of `output` with coupling.interval, at whose ends a run
/// writes.
void check_intervals(const Setting& root, CaseProblems& problems);

/// The part of build_case() for `drivetrain`.
/// @throws BadInput for a name plate that no motor can have
DrivetrainParameters build_drivetrain(const Setting& section, const CaseTables& tables, const CaseCrusher& crusher);

/// One line for each file that the settings name: digest of its content, path. Files that cannot be read become
/// problems.
std::string input_digests(const Setting& setting, CaseProblems& problems);

/// Builds the case from settings without problems.
Case build_case(const Setting& root, const CaseTables& tables);

}  // namespace gyro

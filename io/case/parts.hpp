// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/case/case.hpp"
#include "io/schema/schema.hpp"

// The steps of load_case(), in their order: complete_settings, read_tables, check_settings, and
// build_case when nothing was wrong.

namespace gyro {

/// Collects problems and sorts them: those of the case file, of the tables it names, of overrides.
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

/// The tables that a case names. What could not be read stays empty.
struct CaseTables {
  std::vector<LinerRow> liners;
  std::vector<PassingPoint> sieves;
  CurveMotor motor;
  VoltageInput voltage;
  std::optional<CaseFmu> fmu;
  std::vector<StartParticle> particles;
  std::vector<StartBond> bonds;
};

/// Puts overrides `key.path=value` into a document's tree, in their order.
void apply_overrides(YamlNode& root, const std::vector<std::string>& overrides, CaseProblems& problems);

/// Makes paths absolute, says which files are missing, and fills in the defaults that depend on
/// other keys: the title, the walls of a profile, motions, feed.above, intervals of output.
void complete_settings(Setting& root, const std::filesystem::path& case_file, CaseProblems& problems);

/// Lengthens the intervals of `output` that are not given to a longer coupling.interval.
void complete_intervals(Setting& root);

/// Reads profile, sieves, motor curve, particles and bonds, and checks each table by itself.
CaseTables read_tables(const Setting& root, CaseProblems& problems);

/// The start state of `particles`.
void read_start_state(const Setting& particles, CaseTables& tables, CaseProblems& problems);

/// `drivetrain.fmu`, which is there: its description, and the variables and parameters that the case names.
void read_drive_fmu(const Setting& root, CaseTables& tables, CaseProblems& problems);

/// Checks what concerns more than one key. Keys with problems of their own may be missing.
void check_settings(const Setting& root, CaseProblems& problems);

/// The part of check_settings() that compares the intervals of `output` with coupling.interval, at whose ends a run
/// writes.
void check_intervals(const Setting& root, CaseProblems& problems);

/// The part of build_case() that is `drivetrain`.
/// @throws BadInput for a name plate that no motor has
DrivetrainParameters build_drivetrain(const Setting& section, const CaseTables& tables, const CaseCrusher& crusher);

/// One line a file that the settings name: digest of its content, path. Files that cannot be read are problems.
std::string input_digests(const Setting& setting, CaseProblems& problems);

/// The case of settings without problems.
Case build_case(const Setting& root, const CaseTables& tables);

}  // namespace gyro

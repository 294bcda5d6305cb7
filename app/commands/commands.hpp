// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/bad_key.hpp"
#include "app/run/exit_codes.hpp"
#include "io/case/case.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// A case and how it is changed from the command line.
struct CaseArguments {
  std::filesystem::path file;
  std::vector<std::string> set;
  bool json = false;
  int threads = 0;  ///< that make the rocks and try the run; 0: all cores. RunArguments has its own
};

struct RunArguments {
  CaseArguments input;
  std::optional<std::filesystem::path> out;
  std::string device = "auto";  ///< auto, cpu or cuda
  int threads = 0;              ///< 0: all cores
  bool resume = false, overwrite = false, quiet = false, json_progress = false;
  std::optional<double> until, max_walltime;  ///< [s]
  std::optional<double> steady;               ///< --until steady: relative standard error at which the run ends [-]
};

struct SweepArguments {
  std::filesystem::path file;
  std::optional<std::filesystem::path> out;  ///< none: runs/<sweep>
  std::string engine = "local";              ///< local or slurm
  int jobs = 0;                              ///< of the local engine; 0: cores / threads of a point
  bool retry = false, collect = false, dry_run = false, quiet = false;
};

struct DescribeArguments {
  std::string key;                      ///< of a case, or "outputs"; empty: all keys
  bool json_schema = false;             ///< the keys as JSON Schema
  bool json = false, markdown = false;  ///< the outputs as JSON, as a page
};

struct ExportArguments {
  std::filesystem::path run;
  std::string table = "series";  ///< group of results.h5
  std::optional<std::filesystem::path> out;
};

struct ReportArguments {
  std::vector<std::filesystem::path> runs;
  std::optional<std::filesystem::path> out;  ///< the page; none: the summaries as text
};

struct VerifyArguments {
  std::string filter;    ///< regular expression searched in the names of checks; empty: all
  bool nightly = false;  ///< the long cases as well
  bool json = false;
};

struct BenchAccuracyArguments {
  std::string scene, knob;                      ///< empty: all
  std::optional<std::filesystem::path> folder;  ///< of scenes and reference; none: that of the sources of this build
  int threads = 1;                              ///< runs side by side, each on one thread
  bool quick = false, make_reference = false, json = false;
};

struct BenchSpeedArguments {
  std::vector<std::string> scenes;      ///< empty: all but those that must be asked for
  std::vector<int> threads;             ///< empty: 1 and 2
  std::vector<std::string> precisions;  ///< empty: both
  std::vector<std::string> set;         ///< overrides of all cases
  int repeat = 1;
  std::optional<std::uint64_t> seed;            ///< of the start states that the program makes; none: the scene's own
  std::optional<int> particles;                 ///< likewise
  std::optional<int> warm_up, timed;            ///< steps; none: the scene's own
  std::optional<std::filesystem::path> states;  ///< folder that keeps start states; none: a temporary one
  bool ceiling = false;                         ///< of bonds; no scenes but those that are named
  bool growth = false;                          ///< of the cost of S2r with its size, up to `particles`; likewise
  bool states_only = false, json = false;
};

/// Each command returns an exit code; bad input and failures come as exceptions of core/base/errors.hpp.
int run_command(const RunArguments& arguments);
/// Runs the points of a sweep that are not done, or hands them to Slurm, and collects the results.
int sweep_command(const SweepArguments& arguments);
int check_command(const CaseArguments& arguments);
int describe_command(const DescribeArguments& arguments);
int liners_command(const CaseArguments& arguments, const std::filesystem::path& out);
int library_command(const CaseArguments& arguments, const std::optional<std::filesystem::path>& out);
int verify_command(const VerifyArguments& arguments);
int bench_accuracy_command(const BenchAccuracyArguments& arguments);
int bench_speed_command(const BenchSpeedArguments& arguments);
/// The summaries of runs as they were printed at their ends, or one HTML page about the runs (app/report).
int report_command(const ReportArguments& arguments);
/// A table of a run as CSV, to a file or standard output; names carry the unit.
int export_command(const ExportArguments& arguments);
/// The drivetrain of a case, or of the case of a run, as an FMI 2.0 co-simulation FMU.
/// @param out  default: the case's name with .fmu, in the working directory
int export_fmu_command(const CaseArguments& arguments, const std::optional<std::filesystem::path>& out);
int init_command(const std::string& name);
int info_command(bool json);

/// Does `work` on a case; a BadKey becomes a message with the place of the key in the file. @throws BadInput
template <class Work>
auto located(const CaseArguments& arguments, Work&& work) {
  try {
    return work();
  } catch (const BadKey& bad) {
    throw BadInput(to_string(problem_at(arguments.file, arguments.set, bad.key, bad.what())));
  }
}

/// Makes a directory to write into, with those above it. @throws OutputError
void make_directory(const std::filesystem::path& path);

/// Loads a case; prints every problem to standard error, one a line, and returns nothing if there is one.
std::optional<Case> load_or_complain(const CaseArguments& arguments);

}  // namespace gyro

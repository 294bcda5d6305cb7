// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/run/stop_request.hpp"
#include "app/sweep/local_engine.hpp"
#include "app/sweep/results_files.hpp"
#include "app/sweep/results_text.hpp"
#include "app/sweep/shell_text.hpp"
#include "app/sweep/slurm_job.hpp"
#include "app/sweep/slurm_queue.hpp"
#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/run/replace_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace gyro {
namespace {

namespace fs = std::filesystem;

bool complain(const std::vector<CaseProblem>& problems) {
  for (const CaseProblem& problem : problems) std::cerr << to_string(problem) << "\n";
  return !problems.empty();
}

/// Refuses a directory in which a sweep would write over something else.
void require_sweep_directory(const fs::path& directory) {
  if (directory.empty()) throw BadInput("--out is empty; give a directory");
  if (fs::exists(directory) && !fs::is_directory(directory))
    throw BadInput(directory.string() + " is a file; give a directory, which may be new");
  if (fs::exists(points_file(directory)) && !read_file(points_file(directory)).starts_with("name,"))
    throw BadInput(points_file(directory).string() + " is not of a sweep; give another directory with --out");
  if (fs::exists(points_file(directory))) return;
  for (const char* name : {"results.h5", "results.csv", "case.yaml", "summary.json", "job.sh", "slurm-jobs.csv"})
    if (fs::exists(directory / name))
      throw BadInput(directory.string() + " holds " + name +
                     ", which is not of a sweep; give another directory with --out");
}

/// Makes a file that only a shell reads executable by its owner and those who may read it.
void write_script(const fs::path& file, const std::string& text) {
  replace_file(file, text, true);
  std::error_code none;
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add,
                  none);
}

/// Other sweeps on the directory wait while it exists, so that two never write the same file.
class Turn {
 public:
  explicit Turn(const fs::path& directory)
      : file_(::open((directory / "sweep.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ >= 0) ::flock(file_, LOCK_EX);
  }
  ~Turn() {
    if (file_ >= 0) ::close(file_);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  int file_;  ///< negative where it cannot be made, as on a file system that is read-only
};

void prepare(const fs::path& directory, const CheckedSweep& sweep) {
  make_directory(directory / "logs");
  const Turn turn(directory);
  const std::vector<std::string> former = former_points(directory, sweep);
  if (!former.empty())
    std::cerr << former.size() << " points of an earlier call, as " << former.front()
              << ", are not in the sweep file any more; their directories stay, and the results leave them out\n";
  replace_file(points_file(directory), points_table(sweep), true);
}

void write_results(const fs::path& directory, const CheckedSweep& sweep, bool quiet) {
  const Turn turn(directory);
  const SweepResults results = collect(directory, sweep);
  replace_file(directory / "results.csv", results_csv(results), true);
  write_results_h5(results, directory / "results.h5");
  if (quiet) return;
  std::cout << results_text(results) << "  output              " << directory.string()
            << ": points.csv, results.csv, results.h5\n";
}

void list_points(const fs::path& directory, const CheckedSweep& sweep) {
  std::map<std::string, int> counts;
  for (const CheckedPoint& point : sweep.points) {
    const char* state = to_string(state_of(directory, sweep, point));
    ++counts[state];
    std::cout << point.name << "  " << state << "\n";
  }
  std::cout << sweep.points.size() << " points:";
  for (const auto& [state, count] : counts) std::cout << " " << count << " " << state;
  std::cout << "\n";
}

/// The command that continues a sweep.
std::string again(const SweepArguments& arguments, const fs::path& directory) {
  std::vector<std::string> words{"gyrosim", "sweep", arguments.file.string()};
  if (arguments.out) words.insert(words.end(), {"--out", directory.string()});
  if (arguments.jobs > 0) words.insert(words.end(), {"--jobs", std::to_string(arguments.jobs)});
  return shell_line(words);
}

int run_here(const SweepArguments& arguments, const fs::path& directory, const CheckedSweep& sweep) {
  LocalOptions options{.retry = arguments.retry, .quiet = arguments.quiet};
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1, cores / sweep.file.threads);
  const LocalOutcome outcome = run_locally(directory, sweep, options);
  write_results(directory, sweep, arguments.quiet);
  if (arguments.quiet) return exit_code(outcome);
  std::cerr << outcome.done << " done, " << outcome.stopped << " stopped by a guard, " << outcome.failed << " failed, "
            << outcome.interrupted << " interrupted or waiting, " << outcome.elsewhere << " being run elsewhere\n";
  if (exit_code(outcome) == exit_interrupted) std::cerr << "continue with: " << again(arguments, directory) << "\n";
  return exit_code(outcome);
}

/// The points that a job is made of: those that are due and have no task in the queue.
std::vector<const CheckedPoint*> points_for_slurm(const fs::path& directory, const CheckedSweep& sweep, bool retry) {
  const std::set<std::string> queued = points_in_queue(directory);
  if (!queued.empty()) std::cerr << queued.size() << " points are in the queue already\n";
  std::vector<const CheckedPoint*> points;
  for (const CheckedPoint& point : sweep.points) {
    const PointState state = state_of(directory, sweep, point);
    if (is_due(state, retry) && !queued.contains(point.name)) points.push_back(&point);
    if (state == PointState::stopped || state == PointState::failed)
      std::cerr << to_string(state) << ": " << point.name << (retry ? "" : "; --retry runs it again") << "\n";
  }
  return points;
}

int hand_to_slurm(const SweepArguments& arguments, const fs::path& directory, const CheckedSweep& sweep) {
  std::vector<const CheckedPoint*> points = points_for_slurm(directory, sweep, arguments.retry);
  const std::size_t due = points.size();
  points.resize(std::min(due, max_tasks));
  if (!points.empty()) {
    const fs::path absolute = fs::absolute(directory).lexically_normal();
    write_script(directory / "job.sh", slurm_script(fs::read_symlink("/proc/self/exe"), absolute, sweep, points));
  }
  write_results(directory, sweep, arguments.quiet);
  if (points.empty()) {
    std::cerr << "no points to submit\n";
    return exit_done;
  }
  if (arguments.dry_run) {
    std::cerr << (directory / "job.sh").string() << " has " << points.size() << " tasks; nothing is submitted\n";
    return exit_done;
  }
  std::cerr << "job " << submit(directory, points) << " has " << points.size()
            << " points; results when it has ended: " << again(arguments, directory) << " --collect\n";
  if (due > points.size())
    std::cerr << due - points.size() << " points are left, because an array has at most " << max_tasks
              << " tasks: repeat the command to submit them\n";
  return exit_done;
}

}  // namespace

int sweep_command(const SweepArguments& arguments) {
  catch_stop_signals(exit_interrupted);  // until the points run
  if (arguments.jobs > 0 && arguments.engine == "slurm")
    throw BadInput("--jobs belongs to --engine local; with slurm, give `at_once` below `slurm` of the sweep file");
  const SweepReport report = load_sweep(arguments.file);
  if (complain(report.problems)) return exit_bad_input;
  const CheckedSweep sweep = check_points(*report.loaded);
  if (complain(sweep.problems)) return exit_bad_input;
  const fs::path directory = arguments.out.value_or(fs::path("runs") / arguments.file.stem());
  require_sweep_directory(directory);
  if (complain(changed_points(directory, sweep))) return exit_bad_input;
  if (arguments.collect && !fs::exists(points_file(directory)))
    throw BadInput(directory.string() + " holds no sweep; run it first, or give its directory with --out");
  if (arguments.dry_run && arguments.engine == "local") {
    list_points(directory, sweep);
    return exit_done;
  }
  prepare(directory, sweep);
  if (arguments.collect) {
    write_results(directory, sweep, arguments.quiet);
    return exit_done;
  }
  return arguments.engine == "slurm" ? hand_to_slurm(arguments, directory, sweep)
                                     : run_here(arguments, directory, sweep);
}

}  // namespace gyro

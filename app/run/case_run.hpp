// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/output/run_output.hpp"
#include "app/run/checkpoint.hpp"
#include "app/run/run_log.hpp"
#include "app/simulation/device.hpp"
#include "io/run/progress.hpp"
#include "io/run/run_directory.hpp"
#include "io/run/summary.hpp"

#include <chrono>
#include <memory>
#include <optional>

namespace gyro {

/// How a case is run.
struct RunOptions {
  Device device;
  RunDirectoryRequest directory;
  double end = 0;                         ///< simulated [s]
  std::optional<double> until = {};       ///< the end, if it was given in place of time.duration [s]
  std::optional<double> steady = {};      ///< ends once the figures are known to this relative standard error [-]
  std::optional<double> max_walltime;     ///< [s]
  LibraryProgress library_progress = {};  ///< empty, or told of each rock of the library
  bool quiet = false;                     ///< prints neither progress nor summary
  bool json_progress = false;             ///< progress as JSON
};

/// One run of a case, from its first to its last window: the loop, with output, checkpoints, log and summary.
class CaseRun {
 public:
  /// Writes nothing before all checks of the case have passed.
  /// @param input  kept by reference
  /// @param saved  state of an earlier part of the run, from which to continue; otherwise null
  /// @throws BadKey for a case that cannot be run; BadInput for a state that does not fit; NoDevice; OutputError
  CaseRun(const Case& input, const RunOptions& options, const SavedState* saved);

  /// Runs to the end, a stop of the guard or a request to stop, and writes everything.
  RunStatus run();
  const std::filesystem::path& directory() const { return directory_.path; }

 private:
  std::unique_ptr<Simulation> simulation_of(const SavedState* saved);
  CaseRecord record() const;
  void guarded_loop(Summary& summary);
  void loop(Summary& summary);
  /// Whether the run may end because its figures are known, as options.steady asks; says so in the summary. Judged at
  /// the ends of gyrations only, from what checkpoints keep, so that a run in parts ends at the same time.
  bool is_steady(Summary& summary);
  void note_unsteady(Summary& summary);
  /// Whether the window must be given up: somebody asks to stop and its end is far. @param share_done  of its steps
  bool must_give_up(double share_done) const;
  void give_up(Summary& summary);
  /// @throws OutputError if another run has taken the directory; also for the thread that writes snapshots
  void require_own_directory() const;
  /// Reason why the run must stop before its end; null if there is none.
  const char* stop_reason() const;
  ProgressState progress_state() const;
  double seconds_so_far() const;  ///< wall clock, with the run's earlier parts
  Summary base_summary() const;
  void finish(Summary& summary);
  void mark_unfinished() const;
  void fail(Summary& summary, const std::string& reason) const;

  using Clock = std::chrono::steady_clock;
  const Case& input_;
  RunOptions options_;
  bool resumed_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point window_begin_ = start_;
  bool given_up_ = false;  ///< the last window, so that particles are where no row expects them
  Assembly assembly_;
  std::unique_ptr<Simulation> simulation_;
  RunDirectory directory_;
  RunLog log_;
  RunOutput output_;
  CheckpointKeeper checkpoints_;
};

}  // namespace gyro

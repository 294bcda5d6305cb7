// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/commands/stop_request.hpp"
#include "app/simulation/assembly.hpp"
#include "app/simulation/checkpoint.hpp"
#include "app/simulation/device.hpp"
#include "app/simulation/laboratory.hpp"
#include "app/simulation/run_figures.hpp"
#include "app/simulation/run_output.hpp"
#include "app/simulation/simulation.hpp"
#include "app/version.hpp"
#include "core/base/errors.hpp"
#include "io/run/log.hpp"
#include "io/run/progress.hpp"
#include "io/run/replace_file.hpp"
#include "io/run/run_directory.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace gyro {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double hertz_overlap = 0.3;  // overlap / radius beyond which forces are Hertz's in name only

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A run between its first and last line.
class Run {
 public:
  /// Nothing is written before the case is known to be sound.
  /// @param saved  state to go on with, else null
  Run(const RunArguments& arguments, const Case& input, const RunDirectoryRequest& request, const SavedState* saved)
      : arguments_(arguments),
        input_(input),
        device_(choose_device(arguments.device, arguments.threads)),
        assembly_(assemble(input)),
        simulation_(made_simulation(saved)),
        directory_(open_run_directory(request)),
        log_(directory_.path / "log.txt"),
        output_(input, assembly_, record(), directory_.path, saved),
        checkpoints_(directory_.path, input) {
    if (saved) log_resumption(*saved);
    for (const std::string& note : assembly_.notes) log_.info(note);
    replace_file(directory_.path / "case.yaml", input.resolved);
  }

  int run() {
    start_log();
    if (resumed_) mark_unfinished();
    int code = exit_done;
    Summary summary = base_summary();
    try {
      code = guarded_steps(summary);
      output_.close(simulation_);
    } catch (const std::exception& failure) {
      fail(summary, failure.what());
      throw;
    }
    finish(summary);
    return code;
  }

 private:
  Simulation made_simulation(const SavedState* saved) const {
    auto dem = make_dem(device_, assembly_.scene, input_.numerics.precision);
    if (!saved) return Simulation(input_, assembly_, std::move(dem));
    try {
      return Simulation(input_, assembly_, std::move(dem), *saved);
    } catch (const BadKey&) {
      throw;
    } catch (const BadInput& problem) {
      throw BadInput(checkpoint_file(*arguments_.out).string() + " " + problem.what());
    }
  }

  CaseRecord record() const {
    CaseRecord r;
    r.title = input_.identity.title;
    r.resolved_yaml = input_.resolved;
    r.version = version::number;
    r.git_hash = version::git;
    r.device = device_.name;
    r.precision = to_string(input_.numerics.precision);
    r.seed = input_.identity.seed;
    return r;
  }

  double end() const { return arguments_.until.value_or(input_.time.duration); }

  int guarded_steps(Summary& summary) {
    try {
      return steps(summary);
    } catch (const StoppedByGuard& stop) {
      summary.status = RunStatus::stopped;
      summary.reason = stop.what();
      log_.error(stop.what());
      checkpoints_.write_last_good(output_);
      return exit_stopped;
    }
  }

  int steps(Summary& summary) {
    Progress progress(simulation_.time(), end(), ProgressStyle::for_stderr(arguments_.quiet));
    if (!resumed_) output_.begin(simulation_);
    checkpoints_.look_at(simulation_, output_);
    const double rounding = 1e-6 * assembly_.step.per_window * assembly_.step.dt;
    while (simulation_.time() < end() - rounding) {
      output_.take(simulation_.advance(), simulation_);
      log_drive_events();
      simulation_.require_sound();
      checkpoints_.look_at(simulation_, output_);
      progress.update(progress_state());
      const bool late = arguments_.max_walltime && seconds_since(start_) > *arguments_.max_walltime;
      if (stop_request() == StopRequest::keep_going && !late) continue;
      summary.status = RunStatus::interrupted;
      summary.reason = late ? "--max-walltime is over" : "a signal asked to stop";
      progress.finish(progress_state());
      checkpoints_.write(simulation_, output_);
      return exit_interrupted;
    }
    progress.finish(progress_state());
    checkpoints_.write(simulation_, output_);
    summary.status = RunStatus::done;
    return exit_done;
  }

  void log_drive_events() {
    for (const std::string& note : simulation_.take_drive_notes()) log_.warning(note);
    if (!simulation_.drivetrain() || simulation_.drivetrain()->state().events == drive_events_logged_) return;
    const std::vector<DriveEvent> events = simulation_.drivetrain()->events();
    for (auto k = static_cast<std::size_t>(drive_events_logged_); k < events.size(); ++k)
      log_.warning("drive: " + to_string(events[k].kind) + " at t = " + std::to_string(events[k].time) + " s");
    drive_events_logged_ = simulation_.drivetrain()->state().events;
  }

  ProgressState progress_state() const {
    ProgressState s;
    const Counts counts = simulation_.dem().counts();
    s.time = simulation_.time();
    s.particle_steps = counts.particle_steps;
    s.particles = counts.particles;
    if (input_.bonds) s.bonds_broken = counts.broken_tension + counts.broken_shear;
    if (simulation_.drivetrain()) {
      s.eccentric_speed = simulation_.drivetrain()->state().speed;
      s.crushing_power = simulation_.drivetrain()->means().crushing_power;
    }
    return s;
  }

  void start_log() {
    char line[400];
    std::snprintf(line, sizeof line,
                  "gyrosim %s (%s), %s, %d threads, step %.4g us (limit %.4g us: %s), %lld particles, %lld bonds",
                  version::number, version::git, device_.name.c_str(), device_.threads, assembly_.step.dt * 1e6,
                  assembly_.step.limit * 1e6, assembly_.step.limited_by.c_str(),
                  static_cast<long long>(simulation_.dem().counts().particles),
                  static_cast<long long>(simulation_.dem().counts().bonds_intact));
    log_.info(line);
    log_drive_fmu();
    if (!arguments_.quiet) std::cerr << line << "\nresults in " << directory_.path.string() << "\n";
  }

  void log_drive_fmu() {
    if (!input_.drivetrain_fmu) return;
    const DriveFmu& fmu = *input_.drivetrain_fmu;
    log_.warning("the drivetrain is native code of " + fmu.file.string() + " (" + fmu.model_name +
                 (fmu.generation_tool.empty() ? "" : ", " + fmu.generation_tool) +
                 "), which runs with the rights of this program");
    if (fmu.needs_tool) log_.warning(fmu.file.filename().string() + " says that it needs another program beside it");
    if (const std::string reason = simulation_.unsaveable(); !reason.empty())
      log_.warning("this run has no checkpoints: " + reason + "; --resume starts it anew");
  }

  void log_resumption(const SavedState& saved) {
    resumed_ = true;
    if (simulation_.drivetrain()) drive_events_logged_ = simulation_.drivetrain()->state().events;
    const std::string writer = writer_of(saved), here = this_program();
    log_.info("goes on at t = " + std::to_string(simulation_.time()) + " s from checkpoint.h5");
    if (writer != here)
      log_.warning("checkpoint.h5 was written by gyrosim " + writer + ", this is " + here +
                   ": the same bits as without interruption are not certain");
  }

  Summary base_summary() const {
    Summary s;
    s.title = input_.identity.title;
    s.version = version::number;
    s.git_hash = version::git;
    s.device = device_.name;
    s.precision = record().precision;
    s.threads = device_.threads;
    s.time_step = assembly_.step.dt;
    s.time_step_limit = assembly_.step.limit;
    return s;
  }

  void finish(Summary& s) {
    s.wall_seconds = output_.earlier_seconds() + seconds_since(start_);
    add_figures(s, input_, assembly_, simulation_, output_);
    if (input_.laboratory) s.laboratory = write_laboratory(input_, assembly_, directory_.path);
    if (*s.max_overlap_ratio > hertz_overlap) warn_of_overlap(*s.max_overlap_ratio);
    write_summary(s, directory_.path);
    for (const auto& [phase, seconds] : simulation_.dem().phase_seconds())
      log_.info("phase " + phase + ": " + std::to_string(seconds) + " s");
    log_.info("status " + to_string(s.status));
    if (!arguments_.quiet) std::cout << to_text(s, directory_.path) << std::flush;
  }

  void warn_of_overlap(double ratio) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "contacts were pressed in by up to %.2f of the radius, far beyond Hertz's small overlaps; "
                  "a larger materials.rock.shear_modulus is nearer to real rock",
                  ratio);
    log_.warning(line);
  }

  /// Until it ends again, a run that goes on is none that is done, whatever becomes of this process.
  void mark_unfinished() const {
    Summary s = base_summary();
    s.status = RunStatus::interrupted;
    s.reason = "goes on from its checkpoint";
    s.simulated_seconds = simulation_.time();
    s.wall_seconds = output_.earlier_seconds();
    write_summary(s, directory_.path);
  }

  /// Leaves a word in the directory, if that can still be written.
  void fail(Summary& s, const std::string& reason) const {
    s.status = RunStatus::failed;
    s.reason = reason;
    s.simulated_seconds = simulation_.time();
    s.wall_seconds = output_.earlier_seconds() + seconds_since(start_);
    try {
      write_summary(s, directory_.path);
    } catch (const OutputError&) {  // the failure itself is reported
    }
  }

  const RunArguments& arguments_;
  const Case& input_;
  Clock::time_point start_ = Clock::now();
  Device device_;
  Assembly assembly_;
  Simulation simulation_;
  RunDirectory directory_;
  Log log_;
  RunOutput output_;
  double drive_events_logged_ = 0;
  CheckpointKeeper checkpoints_;
  bool resumed_ = false;
};

/// The state to go on with, if a run is there that can go on.
std::optional<SavedState> state_to_go_on_with(const Case& input, const RunDirectory& directory) {
  if (directory.state == RunDirectory::State::fresh) return {};
  if (directory.state == RunDirectory::State::finished || std::filesystem::exists(checkpoint_file(directory.path)))
    return read_checkpoint(directory.path, input);
  // It ended before its first checkpoint: nothing is lost when the same case starts again.
  require_same_case(directory.path, input);
  std::cerr << directory.path.string() << " holds no checkpoint yet; the run starts at its beginning\n";
  return {};
}

}  // namespace

int run_command(const RunArguments& arguments) {
  catch_stop_signals();
  const std::optional<Case> input = load_or_complain(arguments.input);
  if (!input) return exit_bad_input;
  const RunDirectoryRequest request{arguments.out, arguments.input.file.stem().string(), arguments.resume,
                                    arguments.overwrite};
  const RunDirectory directory = find_run_directory(request);
  const double end = arguments.until.value_or(input->time.duration), later = end - directory.simulated_seconds;
  if (directory.state == RunDirectory::State::finished &&
      (!arguments.resume || later < 1e-6 * input->coupling_interval)) {
    located(arguments.input, [&] { require_same_case(directory.path, *input); });
    std::cerr << directory.path.string() << " holds a run that is finished at t = " << directory.simulated_seconds
              << " s; " << (later > 0 && !arguments.resume ? "--resume goes on to the later end" : "nothing to do")
              << "\n";
    return exit_done;
  }
  std::optional<Run> run;
  located(arguments.input, [&] {
    const std::optional<SavedState> saved = state_to_go_on_with(*input, directory);
    run.emplace(arguments, *input, request, saved ? &*saved : nullptr);
  });
  return run->run();
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/case_run.hpp"

#include "app/assembly/bad_key.hpp"
#include "app/output/laboratory.hpp"
#include "app/output/run_figures.hpp"
#include "app/output/steady_goal.hpp"
#include "app/run/stop_request.hpp"
#include "app/version.hpp"
#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"

#include <cstdio>
#include <iostream>
#include <utility>

namespace gyro {
namespace {

constexpr double longest_wait = 5;  // for the end of a window after a request to stop [s]

}  // namespace

CaseRun::CaseRun(const Case& input, const RunOptions& options, const SavedState* saved)
    : input_(input),
      options_(options),
      resumed_(saved != nullptr),
      assembly_(assemble(input, {options.device.threads, options.until, options.library_progress})),
      simulation_(simulation_of(saved)),
      directory_(open_run_directory(options.directory)),
      log_(directory_.path, options.quiet),
      output_(
          input, assembly_, record(), directory_.path, [this] { require_own_directory(); }, saved),
      checkpoints_(directory_.path, input) {
  if (saved != nullptr) log_.resumed(*simulation_, writer_of(*saved));
  log_.notes(assembly_.notes);
  replace_file(directory_.path / "case.yaml", input.resolved);
}

std::unique_ptr<Simulation> CaseRun::simulation_of(const SavedState* saved) {
  auto dem = make_dem(options_.device, assembly_.setup.scene, input_.numerics.precision);
  try {
    std::vector<NewRock> start = std::exchange(assembly_.setup.start, {});  // once is enough: it is the largest part
    std::vector<Piece> pieces;
    if (assembly_.setup.filling) pieces = std::exchange(assembly_.setup.filling->pieces, {});
    Setup setup = assembly_.setup;
    setup.start = std::move(start);
    if (setup.filling) setup.filling->pieces = std::move(pieces);
    return make_simulation(input_, std::move(setup), std::move(dem), saved);
  } catch (const BadKey&) {
    throw;
  } catch (const BadInput& problem) {
    if (saved == nullptr) throw;
    throw BadInput(checkpoint_file(*options_.directory.out).string() + " " + problem.what());
  }
}

CaseRecord CaseRun::record() const {
  CaseRecord r;
  r.title = input_.identity.title;
  r.resolved_yaml = input_.resolved;
  r.version = version::number;
  r.git_hash = version::git;
  r.device = options_.device.name;
  r.precision = to_string(input_.numerics.precision);
  r.seed = input_.identity.seed;
  return r;
}

RunStatus CaseRun::run() {
  stop_after_window();
  log_.started(options_.device, assembly_.step, *simulation_);
  if (simulation_->filled()) log_.filled(*simulation_->filled());
  if (input_.drivetrain_fmu) log_.drive_fmu(*input_.drivetrain_fmu, simulation_->unsaveable());
  if (resumed_) mark_unfinished();
  Summary summary = base_summary();
  try {
    guarded_loop(summary);
    if (given_up_) {  // the scene is in the middle of the window
      output_.close();
    } else {
      if (output_.lost(*simulation_))
        log_.lost_rows();
      else
        simulation_->inspect();  // for the row of an interval that is not complete
      output_.close(*simulation_);
    }
  } catch (const std::exception& failure) {
    fail(summary, failure.what());
    throw;
  }
  finish(summary);
  return summary.status;
}

void CaseRun::guarded_loop(Summary& summary) {
  try {
    loop(summary);
  } catch (const StoppedByGuard& stop) {
    summary.status = RunStatus::stopped;
    summary.reason = stop.what();
    log_.stopped(stop.what());
    checkpoints_.write_last_good(output_);
  } catch (const WindowGivenUp&) {
    give_up(summary);
  }
}

void CaseRun::give_up(Summary& summary) {
  given_up_ = true;
  summary.status = RunStatus::interrupted;
  char text[300];
  const std::chrono::duration<double> spent = Clock::now() - window_begin_;
  std::snprintf(
      text, sizeof text,
      "%s; the coupling window from t = %.6g s on was given up after %.3g s, since its end was more than %.0f s "
      "away; shorter windows (coupling.interval) are finished",
      stop_reason(), simulation_->time(), spent.count(), longest_wait);
  summary.reason = text;
  log_.stopped(text);
  checkpoints_.write_last_good(output_);
}

bool CaseRun::must_give_up(double share_done) const {
  if (stop_reason() == nullptr || !(share_done > 0)) return false;
  const std::chrono::duration<double> spent = Clock::now() - window_begin_;
  // One step may be slow for any reason; a second of steps tells how long the rest takes.
  return spent.count() > 1 && spent.count() * (1 - share_done) / share_done > longest_wait;
}

void CaseRun::loop(Summary& summary) {
  Simulation& simulation = *simulation_;
  ProgressStyle style = ProgressStyle::for_stderr(options_.quiet);
  if (options_.json_progress) style.form = ProgressStyle::Form::json;
  Progress progress(progress_state(), options_.end, style);
  if (!resumed_) output_.begin(simulation);
  checkpoints_.keep_if_due(simulation, output_);
  if (simulation.unsaveable().empty())  // else nothing could be continued
    simulation.give_up_windows_when([this](double share_done) { return must_give_up(share_done); });
  summary.status = RunStatus::done;
  const double rounding = 1e-6 * assembly_.step.steps_per_window * assembly_.step.dt;
  while (!is_steady(summary) && simulation.time() < options_.end - rounding) {
    window_begin_ = Clock::now();
    output_.take(simulation.advance(), simulation);
    log_.drive_events(simulation);
    simulation.require_sound();
    require_own_directory();
    checkpoints_.keep_if_due(simulation, output_);
    progress.update(progress_state());
    if (const char* reason = stop_reason()) {
      summary.status = RunStatus::interrupted;
      summary.reason = reason;
      break;
    }
  }
  progress.finish(progress_state());
  checkpoints_.write(simulation, output_);
  if (options_.steady && summary.status == RunStatus::done && summary.reason.empty()) note_unsteady(summary);
}

bool CaseRun::is_steady(Summary& summary) {
  if (!options_.steady) return false;
  const std::vector<GyrationMeans>& gyrations = output_.gyrations().gyrations;
  if (gyrations.empty() || gyrations.back().end != simulation_->time()) return false;
  const SteadyProgress now = steady_progress(output_.gyrations(), simulation_->product()->sieves());
  log_.steady(now, *options_.steady);
  if (!is_known(now, *options_.steady)) return false;
  char text[80];
  std::snprintf(text, sizeof text, "steady since %.4g s, known to %.3g %%: ", now.from, 100 * *options_.steady);
  summary.reason = text + to_text(now);
  return true;
}

/// Says that the run has reached its end before its figures were known.
void CaseRun::note_unsteady(Summary& summary) {
  const SteadyProgress now = steady_progress(output_.gyrations(), simulation_->product()->sieves());
  char text[100];
  std::snprintf(text, sizeof text,
                "time.duration is over before the figures are known to %.3g %%: ", 100 * *options_.steady);
  summary.reason = text + to_text(now);
  if (now.not_steady.empty() && now.gyrations < gyrations_of_errors)
    summary.reason += ", from " + std::to_string(now.gyrations) + " of at least " +
                      std::to_string(gyrations_of_errors) + " gyrations";
  log_.not_known(summary.reason);
}

void CaseRun::require_own_directory() const {
  if (directory_.lock && directory_.lock->lost())
    throw OutputError(directory_.path.string() + ": another run has taken this directory while this one was suspended");
}

const char* CaseRun::stop_reason() const {
  const std::chrono::duration<double> since = Clock::now() - start_;
  if (options_.max_walltime && since.count() > *options_.max_walltime) return "--max-walltime is over";
  return stop_requested() ? "a signal asked to stop" : nullptr;
}

ProgressState CaseRun::progress_state() const {
  ProgressState s;
  const Counts counts = simulation_->dem().counts();
  s.time = simulation_->time();
  s.particle_steps = counts.particle_steps;
  s.particles = counts.particles;
  if (input_.bonds) s.bonds_broken = counts.broken_tension + counts.broken_shear;
  if (simulation_->drivetrain()) {
    s.eccentric_speed = simulation_->drivetrain()->state().speed;
    s.crushing_power = simulation_->drivetrain()->means().crushing_power;
  }
  return s;
}

double CaseRun::seconds_so_far() const {
  const std::chrono::duration<double> since = Clock::now() - start_;
  return output_.earlier_seconds() + since.count();
}

Summary CaseRun::base_summary() const {
  Summary s;
  s.title = input_.identity.title;
  s.version = version::number;
  s.git_hash = version::git;
  s.device = options_.device.name;
  s.precision = to_string(input_.numerics.precision);
  s.threads = options_.device.threads;
  s.time_step = assembly_.step.bond_step;
  s.hold = assembly_.step.dt;
  s.time_step_limit = assembly_.step.limit;
  return s;
}

void CaseRun::finish(Summary& s) {
  s.wall_seconds = seconds_so_far();
  add_figures(s, input_, assembly_, *simulation_, output_);
  if (input_.laboratory) s.laboratory = write_laboratory(input_, assembly_, directory_.path);
  write_summary(s, directory_.path);
  const std::string text = to_text(s, directory_.path);
  log_.summary(text);
  log_.ended(*simulation_, s.status);
  if (!options_.quiet) std::cout << text << std::flush;
}

/// Marks a resumed run unfinished until it completes, in case this process is killed.
void CaseRun::mark_unfinished() const {
  Summary s = base_summary();
  s.status = RunStatus::interrupted;
  s.reason = "resumed from its checkpoint, not finished";
  s.wall_seconds = output_.earlier_seconds();
  add_figures(s, input_, assembly_, *simulation_, output_);
  write_summary(s, directory_.path);
}

namespace {

/// A summary with the figures of a run that failed; without them where they cannot be had, as on a device that is lost.
Summary with_known_figures(const Summary& s, const Case& input, const Assembly& assembly, const Simulation& simulation,
                           const RunOutput& output) {
  Summary full = s;
  try {
    add_figures(full, input, assembly, simulation, output);
    return full;
  } catch (const std::exception&) {  // the failure itself is reported
    return s;
  }
}

}  // namespace

/// Records a failure in the directory, if it can still be written.
void CaseRun::fail(Summary& s, const std::string& reason) const {
  if (directory_.lock && directory_.lock->lost()) return;  // the summary there is another run's
  s.status = RunStatus::failed;
  s.reason = reason;
  s.simulated_seconds = simulation_->time();
  s.wall_seconds = seconds_so_far();
  try {
    write_summary(with_known_figures(s, input_, assembly_, *simulation_, output_), directory_.path);
  } catch (const OutputError&) {  // the failure itself is reported
  }
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/local_engine.hpp"

#include "app/run/exit_codes.hpp"
#include "app/sweep/child_programs.hpp"
#include "app/sweep/run_messages.hpp"
#include "io/run/progress.hpp"
#include "io/run/run_lock.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iostream>
#include <map>

#include <unistd.h>

namespace gyro {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A point that is being run.
struct RunningPoint {
  const CheckedPoint* point = nullptr;
  Clock::time_point begin = Clock::now();
  std::uintmax_t log_begin = 0;  ///< size of the log before this run [bytes]
};

class LocalEngine {
 public:
  LocalEngine(const fs::path& directory, const CheckedSweep& sweep, const LocalOptions& options)
      : directory_(directory), sweep_(sweep), options_(options) {}
  LocalOutcome run();

 private:
  void sort_points();
  void start_next();
  void note_signal(int signal);
  void note_end(const EndedChild& child);
  void note_failure(const RunningPoint& ended, const EndedChild& child, const std::string& line);
  void say(const std::string& what, const std::string& name, const std::string& rest = {}) const;
  void say_progress();

  const fs::path& directory_;
  const CheckedSweep& sweep_;
  const LocalOptions& options_;
  ChildPrograms children_;
  std::map<pid_t, RunningPoint> running_;
  std::deque<const CheckedPoint*> due_;
  LocalOutcome outcome_;
  int signals_ = 0;
  double run_seconds_ = 0;  ///< of the points that have ended in this call
  int runs_ = 0;            ///< their number
  Clock::time_point said_ = Clock::now();
};

void LocalEngine::say(const std::string& what, const std::string& name, const std::string& rest) const {
  if (options_.quiet) return;
  const int ended = outcome_.done + outcome_.interrupted + outcome_.stopped + outcome_.failed + outcome_.elsewhere;
  std::cerr << "[" << ended << "/" << sweep_.points.size() << "] " << what << " " << name << rest << "\n";
}

/// Counts the points that need not be run, and lines up the others.
void LocalEngine::sort_points() {
  int skipped = 0;
  for (const CheckedPoint& point : sweep_.points) {
    const PointState state = state_of(directory_, sweep_, point);
    if (is_due(state, options_.retry)) {
      due_.push_back(&point);
      continue;
    }
    skipped += state == PointState::done;
    outcome_.done += state == PointState::done;
    outcome_.stopped += state == PointState::stopped;
    outcome_.failed += state == PointState::failed;
    outcome_.elsewhere += state == PointState::running;
    if (state == PointState::running) say("runs elsewhere:", point.name);
    if (state == PointState::stopped || state == PointState::failed)
      say(std::string(to_string(state)) + " before:", point.name, "; --retry runs it again");
  }
  if (skipped > 0 && !options_.quiet) std::cerr << skipped << " points are done already\n";
}

void LocalEngine::start_next() {
  const CheckedPoint& point = *due_.front();
  due_.pop_front();
  // Another sweep may have run it while this one waited for its turn.
  const PointState state = state_of(directory_, sweep_, point);
  if (!is_due(state, options_.retry)) {
    (state == PointState::done      ? outcome_.done
     : state == PointState::stopped ? outcome_.stopped
     : state == PointState::failed  ? outcome_.failed
                                    : outcome_.elsewhere) += 1;
    return say(std::string(to_string(state)) + " elsewhere:", point.name);
  }
  const fs::path log = log_file(directory_, point.name);
  std::error_code none;
  const std::uintmax_t size = fs::exists(log, none) ? fs::file_size(log, none) : 0;
  const pid_t child = children_.start_self(run_arguments(directory_, sweep_, point), log);
  running_[child] = {&point, Clock::now(), size};
  say(state == PointState::half_done ? "continue" : "start", point.name);
}

void LocalEngine::note_signal(int signal) {
  if (signal == 0) return;
  ++signals_;
  if (signal == SIGINT && signals_ > 1) {
    children_.send(SIGKILL);
    _exit(130);
  }
  outcome_.by_signal = true;
  if (signals_ == 1 && !options_.quiet)
    std::cerr << "stopping: " << children_.running() << " runs write their checkpoints"
              << (signal == SIGINT ? "; press Ctrl-C again to stop at once" : "") << "\n";
  // SIGTERM in any case: a second SIGINT would end a run without a checkpoint.
  children_.send(SIGTERM);
}

void LocalEngine::note_failure(const RunningPoint& ended, const EndedChild& child, const std::string& line) {
  const std::string& name = ended.point->name;
  const bool locked = line.find(lock_is_held) != std::string::npos;
  if (child.code == exit_bad_input && state_of(directory_, sweep_, *ended.point) == PointState::done) {
    ++outcome_.done;
    return say("done elsewhere:", name);
  }
  if (child.code == exit_bad_input && locked) {
    ++outcome_.elsewhere;
    return say("runs elsewhere:", name);
  }
  ++outcome_.failed;
  const std::string reason =
      child.signal != 0
          ? "killed by signal " + std::to_string(child.signal) + "; the next call continues it from its last checkpoint"
          : "exit code " + std::to_string(child.code) + "; " + placed_in_sweep(line, sweep_, *ended.point);
  say("FAILED", name, ": " + reason + " (" + log_file(directory_, name).string() + ")");
}

void LocalEngine::note_end(const EndedChild& child) {
  const RunningPoint ended = running_.at(child.id);
  running_.erase(child.id);
  const double seconds = seconds_since(ended.begin);
  const std::string took = ", " + format_duration(seconds);
  const std::string line = last_line(log_file(directory_, ended.point->name), ended.log_begin);
  if (child.code == exit_done) {
    run_seconds_ += seconds;
    ++runs_;
    ++outcome_.done;
    say("done", ended.point->name, took);
  } else if (child.code == exit_stopped) {
    ++outcome_.stopped;
    say("STOPPED", ended.point->name, took + ": " + reason_of(directory_ / ended.point->name, line));
  } else if (child.code == exit_interrupted || (outcome_.by_signal && child.signal == SIGTERM)) {  // while it started
    ++outcome_.interrupted;
    say("interrupted", ended.point->name, took);
  } else {
    note_failure(ended, child, line);
  }
}

void LocalEngine::say_progress() {
  constexpr double pause = 60;  // [s]
  if (options_.quiet || seconds_since(said_) < pause) return;
  said_ = Clock::now();
  std::cerr << "    " << running_.size() << " running, " << due_.size() << " waiting";
  const double share = static_cast<double>(due_.size() + running_.size()) / options_.jobs;
  if (runs_ > 0) std::cerr << ", about " << format_duration(share * run_seconds_ / runs_) << " left";
  std::cerr << "\n";
}

LocalOutcome LocalEngine::run() {
  sort_points();
  while (!running_.empty() || (!due_.empty() && !outcome_.by_signal)) {
    while (!due_.empty() && !outcome_.by_signal && running_.size() < static_cast<std::size_t>(options_.jobs))
      start_next();
    if (running_.empty()) continue;
    note_signal(children_.wait(std::chrono::seconds(1)));
    for (const EndedChild& child : children_.take_ended()) note_end(child);
    say_progress();
  }
  outcome_.interrupted += static_cast<int>(due_.size());
  return outcome_;
}

}  // namespace

bool is_due(PointState state, bool retry) {
  if (state == PointState::stopped || state == PointState::failed) return retry;
  return state == PointState::waiting || state == PointState::half_done;
}

std::vector<std::string> run_arguments(const fs::path& directory, const CheckedSweep& sweep,
                                       const CheckedPoint& point) {
  std::vector<std::string> words{"run", fs::absolute(sweep.file.case_file).lexically_normal().string()};
  for (const std::string& setting : point.overrides) words.insert(words.end(), {"--set", setting});
  words.insert(words.end(), {"--out", (directory / point.name).string(), "--resume", "--quiet", "--threads",
                             std::to_string(sweep.file.threads)});
  if (!sweep.file.until.empty()) words.insert(words.end(), {"--until", sweep.file.until});
  if (!sweep.file.max_walltime.empty()) words.insert(words.end(), {"--max-walltime", sweep.file.max_walltime});
  return words;
}

LocalOutcome run_locally(const fs::path& directory, const CheckedSweep& sweep, const LocalOptions& options) {
  return LocalEngine(directory, sweep, options).run();
}

int exit_code(const LocalOutcome& outcome) {
  if (outcome.by_signal || outcome.interrupted > 0 || outcome.elsewhere > 0) return exit_interrupted;
  return outcome.failed > 0 ? exit_internal : outcome.stopped > 0 ? exit_stopped : exit_done;
}

}  // namespace gyro

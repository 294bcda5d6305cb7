// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/run_log.hpp"

#include "app/run/checkpoint.hpp"
#include "app/version.hpp"

#include <cstdio>
#include <iostream>
#include <sstream>

namespace gyro {
namespace {

std::string hold_text(const StepChoice& step) {
  if (step.max_substeps == 1) return {};
  char text[80];
  std::snprintf(text, sizeof text, ", contacts held for %.4g us", step.dt * 1e6);
  return text;
}

constexpr double much_escaped = 1e-3;  // of the feed; more rock over the rim makes throughput and hold-up unreliable
constexpr double hertz_overlap = 0.3;  // overlap / radius beyond which Hertz's law no longer describes the force

}  // namespace

RunLog::RunLog(std::filesystem::path directory, bool quiet)
    : directory_(std::move(directory)), quiet_(quiet), log_(directory_ / "log.txt") {}

void RunLog::notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) log_.info(note);
}

void RunLog::resumed(const Simulation& simulation, const std::string& writer) {
  if (simulation.drivetrain()) drive_events_ = simulation.drivetrain()->state().events;
  log_.info("resumed at t = " + std::to_string(simulation.time()) + " s from checkpoint.h5");
  if (writer != this_program())
    log_.warning("checkpoint.h5 was written by gyrosim " + writer + ", this is " + this_program() +
                 ": the results may differ in the last bits from those of a run without interruption");
}

void RunLog::started(const Device& device, const StepChoice& step, const Simulation& simulation) {
  const Counts counts = simulation.dem().counts();
  char line[400];
  std::snprintf(
      line, sizeof line, "gyrosim %s (%s), %s, %d %s, step %.4g us (limit %.4g us: %s)%s, %lld particles, %lld bonds",
      version::number, version::git, device.name.c_str(), device.threads, device.threads == 1 ? "thread" : "threads",
      step.bond_step * 1e6, step.limit * 1e6, step.limited_by.c_str(), hold_text(step).c_str(),
      static_cast<long long>(counts.particles), static_cast<long long>(counts.bonds_intact));
  log_.info(line);
  if (!quiet_) std::cerr << line << "\nresults in " << directory_.string() << "\n";
}

void RunLog::filled(const Filled& filled) {
  char line[300];
  std::snprintf(
      line, sizeof line,
      "feed.initial_from: %.6g kg placed, on average %.3g mm from where they lay and %+.3g mm in height, by mass",
      filled.mass, 1e3 * filled.shift, 1e3 * filled.rise);
  log_.info(line);
  if (filled.lost == 0) return;
  std::snprintf(line, sizeof line, "feed.initial_from: %lld pieces with %.4g kg, %.2g %% of the hold-up, found no room",
                static_cast<long long>(filled.lost), filled.lost_mass,
                100 * filled.lost_mass / (filled.mass + filled.lost_mass));
  log_.warning(line);
}

void RunLog::drive_fmu(const DriveFmu& fmu, const std::string& unsaveable) {
  log_.warning("the drivetrain is native code of " + fmu.file.string() + " (" + fmu.model_name +
               (fmu.generation_tool.empty() ? "" : ", " + fmu.generation_tool) +
               "), which runs in a separate process with your rights");
  if (fmu.needs_tool) log_.warning(fmu.file.filename().string() + " declares that it needs another program to run");
  if (!unsaveable.empty())
    log_.warning("this run has no checkpoints: " + unsaveable + "; --resume starts it at its beginning");
}

void RunLog::drive_events(Simulation& simulation) {
  for (const std::string& note : simulation.take_drive_notes()) log_.warning(note);
  if (!simulation.drivetrain() || simulation.drivetrain()->state().events == drive_events_) return;
  const std::vector<DriveEvent> events = simulation.drivetrain()->events();
  for (auto k = static_cast<std::size_t>(drive_events_); k < events.size(); ++k)
    log_.warning("drive: " + to_string(events[k].kind) + " at t = " + std::to_string(events[k].time) + " s");
  drive_events_ = simulation.drivetrain()->state().events;
}

void RunLog::stopped(const std::string& reason) {
  log_.error(reason);
}

void RunLog::steady(const SteadyProgress& progress, double asked) {
  constexpr double fallen = 0.8;
  const double worst = progress.worst();
  if (!(worst <= fallen * logged_error_) && !is_known(progress, asked)) return;
  logged_error_ = worst;
  char since[120];
  std::snprintf(since, sizeof since, " (steady since %.4g s, %zu gyrations; the run ends at %.3g %%)", progress.from,
                progress.gyrations, 100 * asked);
  log_.info("standard errors: " + to_text(progress) + since);
}

void RunLog::not_known(const std::string& reason) {
  log_.warning(reason);
}

void RunLog::lost_rows() {
  log_.warning("results.h5 ends before the window that was stopped: its numbers are not finite, and left out");
}

void RunLog::summary(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) log_.info(line);
}

void RunLog::ended(const Simulation& simulation, RunStatus status) {
  if (const double overlap = simulation.ledger().worst_overlap(); overlap > hertz_overlap) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "contacts overlapped by up to %.2f of the radius, far beyond the range of Hertz's law; "
                  "a larger materials.rock.shear_modulus is closer to real rock",
                  overlap);
    log_.warning(line);
  }
  if (const double escaped = simulation.escaped_fraction(); escaped > much_escaped) {
    char line[240];
    std::snprintf(
        line, sizeof line,
        "%.4g kg of rock left over the rim, %.2g %% of the feed; it is not in the product: feed less or lower, "
        "or close the chamber with crusher.lid",
        simulation.escaped_mass(), 100 * escaped);
    log_.warning(line);
  }
  for (const auto& [phase, seconds] : simulation.dem().phase_seconds())
    log_.info("phase " + phase + ": " + std::to_string(seconds) + " s");
  for (const auto& [name, count] : simulation.dem().traffic())
    log_.info("device " + name + ": " + std::to_string(count));
  log_.info("status " + to_string(status));
}

}  // namespace gyro

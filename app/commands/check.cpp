// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/assembly.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/library_wait.hpp"
#include "app/simulation/device.hpp"
#include "core/base/errors.hpp"
#include "io/run/progress.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace gyro {
namespace {

/// The size and cost of a run.
struct Estimate {
  StepChoice step;
  std::int64_t particles = 0, bonds = 0, particles_at_end = 0, steps = 0;
  double bytes_at_start = 0;  ///< a batch included
  double bytes = 0;           ///< with all that the rate feeds, if nothing is discharged
  double seconds = 0;
  std::optional<Filled> filled;  ///< by feed.initial_from, if all of it was tried
  bool placed = true;            ///< otherwise the counts follow from masses, and a part of the rock was tried
};

/// Measurements of a run of some windows from t = 0.
struct Trial {
  Counts start;
  std::optional<Filled> filled;
  std::int64_t particles;   ///< after the windows, with what the feed has brought
  double seconds_per_step;  ///< median: the first steps build neighbour lists, and others may use the machine
};
/// @param threads  of the run; 0: all cores
Trial try_out(const Case& input, Setup setup, int threads) {
  constexpr double enough_work = 1e6;     // particle steps in a trial window, some tenths of a second
  constexpr double enough_time = 1.5;     // [s]
  constexpr std::int64_t overhead = 100;  // of a step, in particles
  setup.inspection_interval = 0;
  auto dem = make_dem(choose_device("cpu", threads), setup.scene, input.numerics.precision);
  const std::unique_ptr<Simulation> simulation = make_simulation(input, std::move(setup), std::move(dem));
  const Counts at_start = simulation->dem().counts();
  std::int64_t particles = at_start.particles;
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;  // per step
  const auto start = Clock::now();
  do {
    const double affordable = enough_work / static_cast<double>(std::max(particles, overhead));
    const int max_steps = static_cast<int>(std::clamp(affordable, 1.0, 1e9));
    const auto begin = Clock::now();
    const WindowResult result = simulation->advance(max_steps);
    simulation->require_sound();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count() / result.window.steps);
    particles = simulation->dem().counts().particles;
  } while (seconds.size() < 3 ||
           (seconds.size() < 100 && Clock::now() - start < std::chrono::duration<double>(enough_time)));
  std::nth_element(seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2), seconds.end());
  return {at_start, simulation->filled(), particles, seconds[seconds.size() / 2]};
}

/// [kg]; 0 without a library
double heaviest_rock(const Setup& setup) {
  double volume = 0;
  for (const RockTemplate& rock : setup.library.rocks) volume = std::max(volume, rock.solid_volume);
  return volume * setup.scene.materials[static_cast<std::size_t>(setup.scene.rock_material)].density;
}

/// Takes away rock that would take minutes to place, and drops a batch at once: the trial ends before a later start.
/// @return share of the particles at the start that are left
double thin_out(Setup& setup, const ExpectedCounts& expected) {
  constexpr double max_rocks = 2e4, max_particles = 1e5;
  if (setup.feed && setup.feed->batch > 0) setup.feed->start = 0;
  const double share = std::min({1.0, max_rocks / expected.rocks, max_particles / expected.particles});
  if (!(share < 1) || !setup.feed) return 1;
  const double rock = heaviest_rock(setup);
  for (double* mass : {&setup.feed->initial, &setup.feed->batch})
    *mass = std::max(share * *mass, std::min(*mass, rock));  // the feed refuses less than a rock
  if (setup.filling) {
    double before = 0;  // pieces, of which every 1/share-th stays
    std::erase_if(setup.filling->pieces, [&](const Piece&) {
      const double number = before++;
      return std::floor(share * (number + 1)) == std::floor(share * number);
    });
  }
  setup.feed->fixed.resize(
      std::max<std::size_t>(setup.feed->fixed.empty() ? 0 : 1,
                            static_cast<std::size_t>(share * static_cast<double>(setup.feed->fixed.size()))));
  return share;
}

Estimate estimate(const Case& input, const Assembly& assembly, int threads) {
  Estimate e;
  e.step = assembly.step;
  const ExpectedCounts& expected = assembly.expected;
  e.steps = std::llround(expected.steps);
  Setup setup = assembly.setup;
  e.placed = thin_out(setup, expected) == 1;
  const Trial trial = try_out(input, std::move(setup), threads);
  if (e.placed) e.filled = trial.filled;
  const bool batch = assembly.setup.feed && assembly.setup.feed->batch > 0;
  // Counts of placed rock are exact; a batch comes later.
  e.particles = e.placed ? trial.start.particles : std::llround(expected.particles);
  e.bonds = e.placed ? trial.start.bonds_intact : std::llround(expected.bonds);
  const double start = batch ? std::max(expected.particles, double(e.particles)) : double(e.particles);
  e.particles_at_end = std::llround(start + expected.fed_particles);
  const double bonds = batch ? std::max(expected.bonds, double(e.bonds)) : double(e.bonds);
  e.bytes_at_start = expected_bytes(start, bonds, input.numerics.precision);
  e.bytes = expected_bytes(double(e.particles_at_end), bonds + expected.fed_bonds, input.numerics.precision);
  // A step takes time in proportion to the particles; what the rate feeds in a trial is too little to count.
  const double average = 0.5 * (start + double(e.particles_at_end));
  const auto tried = static_cast<double>(batch ? trial.particles : trial.start.particles);
  e.seconds = expected.steps * trial.seconds_per_step * (tried > 0 ? average / tried : 1);
  return e;
}

void add_figures(nlohmann::json& out, const Estimate& e) {
  out["time_step"] = e.step.bond_step;
  out["hold"] = e.step.dt;
  out["substeps"] = {e.step.min_substeps, e.step.max_substeps};
  out["time_step_limit"] = e.step.limit;  // null where nothing limits it
  out["limited_by"] = e.step.limited_by;
  out["particles"] = e.particles;
  out["particles_at_end"] = e.particles_at_end;  // if all the feed finds room and nothing is discharged
  out["bonds"] = e.bonds;
  out["steps"] = e.steps;
  out["bytes"] = e.bytes;
  out["bytes_at_start"] = e.bytes_at_start;
  out["bytes_free"] = free_memory().bytes;  // null where it is not known
  out["estimated_seconds"] = e.seconds;
  out["placed"] = e.placed;
  if (e.filled) out["filled"] = {{"mass", e.filled->mass}, {"lost_mass", e.filled->lost_mass}};
}

/// The most that a run can need: how much of the feed is in the chamber at a time shows only in a run.
void print_memory(const Estimate& e) {
  std::printf("memory         about %s bytes of rock", format_count(e.bytes).c_str());
  if (e.bytes > e.bytes_at_start)
    std::printf(" if all the feed finds room and nothing is discharged, %s at the start",
                format_count(e.bytes_at_start).c_str());
  std::printf("; a run takes some 40 M besides");
  if (const FreeMemory free = free_memory(); std::isfinite(free.bytes))
    std::printf("; %s is %s", free.what.c_str(), format_count(free.bytes).c_str());
  std::printf("\n");
}

void print_step(const StepChoice& step) {
  std::printf("step           %.4g us", step.bond_step * 1e6);
  if (std::isfinite(step.limit)) std::printf(", limit %.4g us (%s)", step.limit * 1e6, step.limited_by.c_str());
  std::printf("\n");
  if (step.max_substeps == 1) return;
  std::printf("hold           %.4g us of contacts and walls", step.dt * 1e6);
  if (!step.hold_limited_by.empty()) std::printf(" (%s)", step.hold_limited_by.c_str());
  if (step.min_substeps == step.max_substeps)
    std::printf(", %d sub-steps of every rock\n", step.max_substeps);
  else
    std::printf(", %d to %d sub-steps of a rock\n", step.min_substeps, step.max_substeps);
}

void print(const Case& input, const Assembly& assembly, const Estimate& e) {
  std::cout << input.resolved << "\n";
  print_step(e.step);
  std::printf("steps          %lld, %d per coupling interval\n", static_cast<long long>(e.steps),
              e.step.steps_per_window);
  std::printf("particles      %s at the start, about %s by the end if all the feed finds room\n",
              format_count(double(e.particles)).c_str(), format_count(double(e.particles_at_end)).c_str());
  std::printf("bonds          %s at the start\n", format_count(double(e.bonds)).c_str());
  if (e.filled)
    std::printf("filling        %.6g kg placed, %.4g kg without room\n", e.filled->mass, e.filled->lost_mass);
  if (!e.placed)
    std::printf("estimate       the counts follow from masses; whether all rock finds room shows in a run\n");
  if (const std::vector<RockTemplate>& rocks = assembly.setup.library.rocks; !rocks.empty())
    std::printf("library        %zu rocks, %.3g to %.3g mm\n", rocks.size(), rocks.front().diameter * 1e3,
                rocks.back().diameter * 1e3);
  if (assembly.resolution)
    std::printf("resolution     particles of %s; finer product is %s\n", to_string(*assembly.resolution).c_str(),
                input.output.fines ? "estimated, by output.fines" : "unknown");
  for (const std::string& note : assembly.notes) std::printf("note           %s\n", note.c_str());
  print_memory(e);
  std::printf("wall time      about %s on this machine\n", format_duration(e.seconds).c_str());
}

}  // namespace

int check_command(const CaseArguments& arguments) {
  nlohmann::json out{{"valid", false}, {"problems", nlohmann::json::array()}};
  CaseReport report = load_case(arguments.file, arguments.set);
  std::optional<Assembly> assembly;
  std::optional<Estimate> found;
  const auto blame = [&](const std::string& key, const std::string& problem) {
    report.problems.push_back(problem_at(arguments.file, arguments.set, key, problem));
  };
  if (report.loaded) {
    if (report.loaded->drivetrain_fmu)
      std::cerr << "starts the native code of " << report.loaded->drivetrain_fmu->file.string()
                << ", in a separate process with your rights, to see whether it can be initialised\n";
    try {
      assembly.emplace(assemble(*report.loaded, {.threads = arguments.threads, .library_progress = LibraryWait()}));
      found.emplace(estimate(*report.loaded, *assembly, arguments.threads));
    } catch (const BadKey& bad) {
      blame(bad.key, bad.what());
    } catch (const StoppedByGuard& stop) {
      blame("", std::string("a run of this case stops at once: ") + stop.what());
    }
  }
  for (const CaseProblem& p : report.problems) {
    out["problems"].push_back({{"line", p.line}, {"column", p.column}, {"message", p.message}});
    std::cerr << to_string(p) << "\n";
  }
  if (found) {
    out["valid"] = true;
    add_figures(out, *found);
    out["notes"] = assembly->notes;
    const std::optional<Resolution>& resolution = assembly->resolution;  // null without rock that can break
    out["resolution"] = resolution ? nlohmann::json(resolution->coarsest) : nlohmann::json(nullptr);
    out["finest_particle"] = resolution ? nlohmann::json(resolution->finest) : nlohmann::json(nullptr);
    if (!arguments.json) print(*report.loaded, *assembly, *found);
  }
  if (arguments.json) std::cout << out.dump(2) << "\n";
  return found ? exit_done : exit_bad_input;
}

}  // namespace gyro

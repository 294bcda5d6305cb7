// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/assembly.hpp"
#include "app/commands/commands.hpp"
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
  double bytes = 0, seconds = 0;
  bool placed = true;  ///< otherwise the counts follow from masses, and a part of the rock was tried
};

/// Measurements of a run of some windows from t = 0.
struct Trial {
  Counts start;
  double seconds_per_step;  ///< median: the first steps build neighbour lists, and others may use the machine
};
Trial try_out(const Case& input, Setup setup) {
  constexpr double enough_work = 1e6;  // particle steps in a trial window, some tenths of a second
  constexpr double enough_time = 1.5;  // [s]
  setup.inspection_interval = 0;
  auto dem = make_dem(choose_device("cpu", 0), setup.scene, input.numerics.precision);
  const std::unique_ptr<Simulation> simulation = make_simulation(input, std::move(setup), std::move(dem));
  const Counts at_start = simulation->dem().counts();
  const double affordable = enough_work / static_cast<double>(std::max<std::int64_t>(at_start.particles, 1));
  const int max_steps = static_cast<int>(std::clamp(affordable, 1.0, 1e9));
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;  // per step
  const auto start = Clock::now();
  do {
    const auto begin = Clock::now();
    const WindowResult result = simulation->advance(max_steps);
    simulation->require_sound();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count() / result.window.steps);
  } while (seconds.size() < 3 ||
           (seconds.size() < 100 && Clock::now() - start < std::chrono::duration<double>(enough_time)));
  std::nth_element(seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2), seconds.end());
  return {at_start, seconds[seconds.size() / 2]};
}

/// Takes away rock that would take minutes to place. @return share of the particles at the start that are left
double thin_out(Setup& setup, const ExpectedCounts& expected) {
  constexpr double max_rocks = 2e4, max_particles = 1e5;
  const double share = std::min({1.0, max_rocks / expected.rocks, max_particles / expected.particles});
  if (!(share < 1) || !setup.feed) return 1;
  setup.feed->initial *= share;
  setup.feed->fixed.resize(
      std::max<std::size_t>(setup.feed->fixed.empty() ? 0 : 1,
                            static_cast<std::size_t>(share * static_cast<double>(setup.feed->fixed.size()))));
  return share;
}

Estimate estimate(const Case& input, const Assembly& assembly) {
  Estimate e;
  e.step = assembly.step;
  const ExpectedCounts& expected = assembly.expected;
  e.steps = std::llround(expected.steps);
  Setup setup = assembly.setup;
  e.placed = thin_out(setup, expected) == 1;
  const Trial trial = try_out(input, std::move(setup));
  const double batch = assembly.setup.feed ? assembly.setup.feed->batch : 0;
  // Counts of placed rock are exact; a batch comes later.
  e.particles = e.placed ? trial.start.particles : std::llround(expected.particles);
  e.bonds = e.placed ? trial.start.bonds_intact : std::llround(expected.bonds);
  const double tried = static_cast<double>(std::max<std::int64_t>(trial.start.particles, 1));
  const double all = std::max(expected.particles, double(e.particles)) + expected.fed_particles;
  e.particles_at_end = batch > 0 || !e.placed ? std::llround(all) : e.particles + std::llround(expected.fed_particles);
  e.bytes = expected_bytes(double(e.particles_at_end), double(e.bonds));
  const double growth =
      e.particles > 0 ? 0.5 * (1 + static_cast<double>(e.particles_at_end) / static_cast<double>(e.particles)) : 1;
  const double whole = e.placed ? 1 : double(e.particles) / tried;
  e.seconds = expected.steps * growth * whole * trial.seconds_per_step;
  return e;
}

void add_figures(nlohmann::json& out, const Estimate& e) {
  out["time_step"] = e.step.dt;
  out["time_step_limit"] = e.step.limit;  // null where nothing limits it
  out["limited_by"] = e.step.limited_by;
  out["particles"] = e.particles;
  out["bonds"] = e.bonds;
  out["steps"] = e.steps;
  out["bytes"] = e.bytes;
  out["estimated_seconds"] = e.seconds;
  out["placed"] = e.placed;
}

void print(const Case& input, const Assembly& assembly, const Estimate& e) {
  std::cout << input.resolved << "\n";
  std::printf("step           %.4g us", e.step.dt * 1e6);
  if (std::isfinite(e.step.limit)) std::printf(", limit %.4g us (%s)", e.step.limit * 1e6, e.step.limited_by.c_str());
  std::printf("\n");
  std::printf("steps          %lld, %d per coupling interval\n", static_cast<long long>(e.steps),
              e.step.steps_per_window);
  std::printf("particles      %s at the start, about %s by the end if all the feed finds room\n",
              format_count(double(e.particles)).c_str(), format_count(double(e.particles_at_end)).c_str());
  std::printf("bonds          %s at the start\n", format_count(double(e.bonds)).c_str());
  if (!e.placed)
    std::printf("estimate       the counts follow from masses; whether all rock finds room shows in a run\n");
  if (const std::vector<RockTemplate>& rocks = assembly.setup.library.rocks; !rocks.empty())
    std::printf("library        %zu rocks, %.3g to %.3g mm\n", rocks.size(), rocks.front().diameter * 1e3,
                rocks.back().diameter * 1e3);
  for (const std::string& note : assembly.notes) std::printf("note           %s\n", note.c_str());
  std::printf("memory         about %s bytes\n", format_count(e.bytes).c_str());
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
      assembly.emplace(assemble(*report.loaded, arguments.threads));
      found.emplace(estimate(*report.loaded, *assembly));
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
    if (!arguments.json) print(*report.loaded, *assembly, *found);
  }
  if (arguments.json) std::cout << out.dump(2) << "\n";
  return found ? exit_done : exit_bad_input;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/measure.hpp"

#include "app/assembly/assembly.hpp"
#include "app/assembly/bad_key.hpp"
#include "app/bench/speed/process_memory.hpp"
#include "app/simulation/device.hpp"
#include "core/base/errors.hpp"
#include "core/base/fields.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <utility>

namespace gyro::bench {
namespace {

static_assert(declares_every_field<SpeedMeasurement>);

/// Wall time, and processor time of all threads, since it was made [s].
class StopWatch {
 public:
  double wall() const { return std::chrono::duration<double>(Clock::now() - wall_).count(); }
  double cpu() const { return process_seconds() - cpu_; }

 private:
  using Clock = std::chrono::steady_clock;
  static double process_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  Clock::time_point wall_ = Clock::now();
  double cpu_ = process_seconds();
};

Case loaded(const SpeedRun& run, const std::vector<std::string>& overrides) {
  CaseReport report = load_case(run.file, overrides);
  std::string problems;
  for (const CaseProblem& problem : report.problems) problems += (problems.empty() ? "" : "\n") + to_string(problem);
  if (!report.loaded) throw BadInput(problems);
  return std::move(*report.loaded);
}

std::unique_ptr<Simulation> made(const SpeedRun& run) {
  std::vector<std::string> overrides = run.overrides;
  overrides.push_back("numerics.precision=" + to_string(run.precision));
  Case input = loaded(run, overrides);
  try {
    Assembly assembly = assemble(input, {.threads = run.threads});
    input.particles.reset();  // their rows are in the setup now
    auto dem = make_dem(choose_device("cpu", run.threads), assembly.setup.scene, run.precision);
    return make_simulation(input, std::move(assembly.setup), std::move(dem));
  } catch (const BadKey& bad) {
    throw BadInput(to_string(problem_at(run.file, overrides, bad.key, bad.what())));
  }
}

/// @param count  steps, or windows of the longest kind
/// @return steps that were done
std::int64_t advance(Simulation& simulation, int count, bool whole_windows) {
  const std::int64_t steps = whole_windows ? std::int64_t{count} * simulation.setup().steps_per_window : count;
  std::int64_t done = 0;
  while (done < steps) {
    done += simulation.advance(static_cast<int>(steps - done)).window.steps;
    simulation.require_sound();
  }
  return done;
}

using Phases = std::vector<std::pair<std::string, double>>;

/// Seconds of each phase since an earlier reading.
Phases since(const Phases& before, const Phases& now) {
  Phases passed;
  for (const auto& [name, seconds] : now) {
    const auto same = std::ranges::find(before, name, &Phases::value_type::first);
    passed.emplace_back(name, seconds - (same != before.end() ? same->second : 0));
  }
  return passed;
}

/// Pairs and walls that touch: the state that is saved holds these alone.
std::int64_t touching(const Dem& dem) {
  const SavedState saved = dem.save();
  std::int64_t count = static_cast<std::int64_t>(saved.get<Index>("contacts/pair/i").size());
  for (const std::int32_t n : saved.get<std::int32_t>("wall_contacts/count")) count += n;
  return count;
}

void note_state(const Dem& dem, SpeedMeasurement& m) {
  m.contacts = touching(dem);
  const ParticleSnapshot s = dem.particles();
  for (std::size_t k = 0; k < s.size(); ++k) {
    m.kinetic += 0.5 * s.mass[k] * norm2(s.velocity[k]);
    m.rotation += 0.2 * s.mass[k] * s.radius[k] * s.radius[k] * norm2(s.angular_velocity[k]);
  }
}

}  // namespace

nlohmann::json to_json(const SpeedMeasurement& measurement) {
  nlohmann::json j;
  SpeedMeasurement::for_each_field([&](const char* name, const auto& value) { j[name] = value; }, measurement);
  return j;
}

SpeedMeasurement measurement_of(const nlohmann::json& j) {
  SpeedMeasurement m;
  SpeedMeasurement::for_each_field([&](const char* name, auto& value) { j.at(name).get_to(value); }, m);
  return m;
}

SpeedMeasurement measure_speed(const SpeedRun& run) {
  SpeedMeasurement m;
  const std::int64_t memory = resident_bytes();
  const StopWatch setup;
  const std::unique_ptr<Simulation> simulation = made(run);
  m.setup_seconds = setup.wall();
  advance(*simulation, run.warm_up, run.whole_windows);
  const Dem& dem = simulation->dem();
  const Counts before = dem.counts();
  const Phases phases = dem.phase_seconds();
  const StopWatch clock;
  m.steps = advance(*simulation, run.timed, run.whole_windows);
  m.wall_seconds = clock.wall();
  m.cpu_seconds = clock.cpu();
  m.phases = since(phases, dem.phase_seconds());
  m.bytes = peak_resident_bytes() - memory;
  const Counts after = dem.counts();
  m.particles = after.particles;
  m.bonds = after.bonds_intact;
  m.bond_steps = after.bond_steps - before.bond_steps;
  m.rebuilds = after.rebuilds - before.rebuilds;
  m.substeps = simulation->setup().scene.substeps;
  m.time_step = simulation->setup().scene.dt;
  note_state(dem, m);
  return m;
}

}  // namespace gyro::bench

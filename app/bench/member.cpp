// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/member.hpp"

#include "app/assembly/assembly.hpp"
#include "app/bench/first_break.hpp"
#include "app/bench/size.hpp"
#include "app/simulation/device.hpp"
#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <sstream>

namespace gyro::bench {
namespace {

/// Processor time of the calling thread [s], which does not depend on other programs on the machine.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Case load(const Member& m, std::vector<std::string> overrides) {
  overrides.push_back("case.seed=" + std::to_string(m.seed));
  const CaseReport report = load_case(m.folder / (m.scene->name + ".yaml"), overrides);
  std::string problems;
  for (const CaseProblem& problem : report.problems) problems += (problems.empty() ? "" : "\n") + to_string(problem);
  if (!report.loaded) throw BadInput(problems);
  return *report.loaded;
}

double smallest_radius(const Setup& setup) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const NewRock& rock : setup.start)
    for (const NewParticle& p : rock.particles) smallest = std::min(smallest, p.radius);
  return smallest;
}

/// Sets what a case cannot: skins of neighbour lists, and holds beyond the limit of the check of a case.
void apply(const KnobSetting& setting, double window, Assembly& assembly) {
  Setup& setup = assembly.setup;
  setup.inspection_interval = 0;  // no particle is removed
  if (setting.margin > 0) setup.scene.neighbour_skin = setting.margin * smallest_radius(setup);
  StepChoice& step = assembly.step;
  if (setting.hold_share > 0) {
    StepRequest request{.window = window};
    request.rates = {.kind = Rates::Kind::automatic, .share = setting.hold_share};
    step = set_step(setup, request);
  }
  if (setting.hold == 1) return;
  step.steps_per_window = static_cast<int>(std::ceil(1.0 * step.steps_per_window / setting.hold));
  step.dt = window / step.steps_per_window;
  step.bond_step = step.dt / setting.hold;
  step.max_substeps = setting.hold;
  step.of_library.assign(step.of_library.size(), setting.hold);
  step.of_start.assign(step.of_start.size(), setting.hold);
  set_step(setup, step);
}

/// Index of the wall whose force and work are measured.
std::size_t tool_of(const AccuracyScene& scene, const Setup& setup) {
  if (scene.tool.empty()) return static_cast<std::size_t>(gyrating_wall(setup.scene));
  const auto& walls = setup.scene.walls;
  const auto found = std::find_if(walls.begin(), walls.end(), [&](const Wall& w) { return w.name == scene.tool; });
  if (found == walls.end()) throw BadInput(scene.name + ".yaml has no wall " + scene.tool);
  return static_cast<std::size_t>(found - walls.begin());
}

/// A run and the quantities recorded from it.
struct Watched {
  Simulation& simulation;
  std::size_t tool;
  double work = 0;  ///< done by the tool [J]
  FirstBreak first_break = {};

  void window() {
    const WindowResult result = simulation.advance();
    const WallLoad& load = result.walls[tool];
    work += load.work;
    if (!first_break.seen()) first_break.see(result.window, norm(load.force), result.breakages);
  }
};

std::map<std::string, double> values_of(const Watched& run, const Case& input) {
  const Simulation& s = run.simulation;
  const Counts counts = s.dem().counts();
  const Sizes sizes =
      sizes_of(s.dem().particles(), input.materials[static_cast<std::size_t>(input.rock_material)].density);
  std::map<std::string, double> v;
  v["first_break_time"] = run.first_break.time();
  v["first_break_force"] = run.first_break.force();
  v["first_break_bond"] = run.first_break.bond();
  v["energy_per_mass"] = run.work / sizes.mass;
  v["mean_power"] = run.work / s.time();
  v["broken_share"] =
      static_cast<double>(counts.broken_tension + counts.broken_shear) / static_cast<double>(s.bonds_initial());
  v["fragment_size"] = sizes.mean;
  v["p80"] = sizes.p80;
  v["energy_residual"] = s.ledger().residual_fraction();
  if (s.drivetrain()) v["eccentric_speed"] = s.drivetrain()->state().speed;
  return v;
}

}  // namespace

MemberResult run_member(const Member& member) {
  const Case input = load(member, member.setting.overrides);
  Assembly assembly = assemble(input, {.threads = 1});
  Setup& setup = assembly.setup;
  apply(member.setting, input.coupling_interval, assembly);
  auto dem = make_dem(choose_device("cpu", 1), setup.scene, input.numerics.precision);
  const std::unique_ptr<Simulation> made = make_simulation(input, setup, std::move(dem));
  Simulation& simulation = *made;
  Watched run{simulation, tool_of(*member.scene, setup)};
  MemberResult result;
  result.time_step = assembly.step.bond_step;
  result.time_step_limit = assembly.step.limit;
  const double end = input.time.duration - 1e-6 * setup.steps_per_window * setup.scene.dt;
  const double start = thread_seconds();
  while (simulation.time() < end && !simulation.verdict()) {
    run.window();
    if (member.setting.to_first_break && run.first_break.seen()) break;
  }
  result.cpu_seconds = thread_seconds() - start;
  result.simulated_seconds = simulation.time();
  result.stopped = simulation.verdict();
  if (!result.stopped) result.values = values_of(run, input);
  return result;
}

std::string refusal(const Member& member) {
  if (member.setting.hold_share > Rates{}.share) return "contacts would be held for too long";
  try {
    assemble(load(member, as_overrides(member.setting)), {.threads = 1});
  } catch (const BadInput& problem) {
    return problem.what();
  }
  return {};
}

std::string fingerprint(const AccuracyScene& scene, const std::filesystem::path& folder) {
  const Case input = load({&scene, folder, default_setting(), 1}, {});
  std::vector<std::filesystem::path> files{input.file};
  if (input.particles) {
    files.push_back(input.particles->file);
    files.push_back(input.particles->bonds_file);
  }
  if (input.crusher) files.push_back(input.crusher->profile);
  std::uint64_t hash = 14695981039346656037u;
  for (const std::filesystem::path& file : files) {
    if (file.empty()) continue;
    std::istringstream in(read_file(file));
    for (std::string line; std::getline(in, line);) {
      line.erase(std::min(line.find('#'), line.size()));
      while (!line.empty() && line.back() == ' ') line.pop_back();
      if (line.empty()) continue;
      for (const char c : line + "\n") hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    }
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace gyro::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/ceiling/ceiling.hpp"
#include "app/bench/speed/growth.hpp"
#include "app/bench/speed/own_process.hpp"
#include "app/bench/speed/report.hpp"
#include "app/bench/speed/state_files.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/program_files.hpp"
#include "app/version.hpp"
#include "core/base/errors.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace gyro {
namespace {

using namespace bench;
namespace fs = std::filesystem;

/// A folder for start states that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "gyrosim-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw OutputError(name + ": cannot be made; give a folder for start states with --states");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::vector<SpeedScene> chosen(const BenchSpeedArguments& a) {
  std::vector<SpeedScene> scenes;
  for (const std::string& name : a.scenes) scenes.push_back(scene_named(name));
  for (const SpeedScene& scene : speed_scenes())
    if (a.scenes.empty() && !a.ceiling && !a.growth && !scene.asked_only && !(a.states_only && scene.make == nullptr))
      scenes.push_back(scene);
  for (SpeedScene& scene : scenes) {
    if (scene.make == nullptr && !a.scenes.empty() && (a.seed || a.particles || a.states_only))
      throw BadInput("--scene " + scene.name +
                     ": --seed, --particles and --states-only belong to start states, and this scene has none; leave "
                     "them out or use --set");
    scene.recipe.seed = a.seed.value_or(scene.recipe.seed);
    scene.recipe.particles = a.particles.value_or(scene.recipe.particles);
    scene.warm_up = a.warm_up.value_or(scene.warm_up);
    scene.timed = a.timed.value_or(scene.timed);
  }
  return scenes;
}

SpeedPlan plan_of(const BenchSpeedArguments& a, const fs::path& states) {
  SpeedPlan plan{.cases = case_folder(), .states = states, .overrides = a.set, .repeat = a.repeat};
  if (!a.threads.empty()) plan.threads = a.threads;
  if (!a.precisions.empty()) plan.precisions.clear();
  for (const std::string& word : a.precisions)
    plan.precisions.push_back(word == "mixed" ? Precision::mixed : Precision::double_);
  return plan;
}

int write_states(const std::vector<SpeedScene>& scenes, const SpeedPlan& plan) {
  for (const SpeedScene& scene : scenes)
    std::cout << write_start(scene, plan.cases, plan.states).parent_path().string() << "\n";
  return exit_done;
}

/// Of a run of all scenes, or where it is asked for.
nlohmann::ordered_json ceilings_of(const BenchSpeedArguments& a, const SpeedPlan& plan) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  if (!a.ceiling && (a.growth || !a.scenes.empty())) return all;
  const std::vector<BondCeiling> ceilings = measure_bond_ceiling(plan.precisions);
  if (!a.json) print(ceilings);
  for (const BondCeiling& ceiling : ceilings) all.push_back(to_json(ceiling));
  return all;
}

nlohmann::ordered_json growth_in(const BenchSpeedArguments& a, const SpeedPlan& plan) {
  if (!a.growth) return {};
  std::vector<SpeedResult> results;
  for (SpeedScene scene : growth_scenes(a.particles.value_or(1000000))) {
    scene.recipe.seed = a.seed.value_or(scene.recipe.seed);
    scene.warm_up = a.warm_up.value_or(scene.warm_up);
    scene.timed = a.timed.value_or(scene.timed);
    for (const SpeedResult& result : measure(scene, plan)) results.push_back(result);
  }
  const std::vector<GrowthRow> rows = growth_of(results);
  if (!a.json) print(rows);
  return to_json(rows);
}

}  // namespace

int bench_speed_command(const BenchSpeedArguments& a) {
  const std::vector<SpeedScene> scenes = chosen(a);
  if (a.states_only && scenes.empty())
    throw BadInput(
        "--states-only writes the start states of scenes: name them with --scene, or leave out --growth and --ceiling");
  if (a.states_only && !a.states) throw BadInput("--states-only needs a folder to write into; give it with --states");
  std::optional<TemporaryFolder> temporary;
  if (!a.states) temporary.emplace();
  const SpeedPlan plan = plan_of(a, a.states ? *a.states : temporary->path());
  if (a.states_only) return write_states(scenes, plan);
  if (!a.json && !scenes.empty()) print_speed_head();
  nlohmann::ordered_json measured = nlohmann::ordered_json::array();
  for (const SpeedScene& scene : scenes)
    for (const SpeedResult& result : measure(scene, plan)) {
      if (a.json)
        measured.push_back(to_json(result));
      else
        print(result);
    }
  const nlohmann::ordered_json growth = growth_in(a, plan), ceilings = ceilings_of(a, plan);
  if (a.json) {
    nlohmann::ordered_json all{{"scenes", measured}, {"bond_ceiling", ceilings}};
    if (a.growth) all["growth"] = growth;
    all["machine"] = processor_name();
    all["git"] = version::git;
    std::cout << all.dump(1) << "\n";
  }
  return exit_done;
}

}  // namespace gyro

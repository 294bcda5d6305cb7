// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/report.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/program_files.hpp"
#include "app/version.hpp"

#include <cstdio>
#include <iostream>

namespace gyro {
namespace {

using namespace bench;

std::string names() {
  std::string all;
  for (const AccuracyScene& scene : accuracy_scenes()) all += (all.empty() ? "" : ", ") + scene.name;
  return all;
}

std::vector<AccuracyScene> chosen(const std::string& name) {
  std::vector<AccuracyScene> all;
  for (const AccuracyScene& scene : accuracy_scenes())
    if (name.empty() || scene.name == name) all.push_back(scene);
  if (all.empty()) throw BadInput("--scene " + name + ": there is no such scene; use one of " + names());
  return all;
}

void require_knob(const std::string& knob) {
  if (knob.empty()) return;
  std::string known;
  for (const AccuracyScene& scene : accuracy_scenes())
    for (const KnobSetting& setting : settings_of(scene, false)) {
      if (setting.knob == knob) return;
      if ((known + ", ").find(setting.knob + ", ") == std::string::npos)
        known += (known.empty() ? "" : ", ") + setting.knob;
    }
  throw BadInput("--knob " + knob + ": there is no such knob; use one of " + known);
}

int make_references(const std::vector<AccuracyScene>& scenes, const std::filesystem::path& folder, int threads) {
  for (const AccuracyScene& scene : scenes) {
    write_reference(folder / "reference.json", scene.name, make_reference(scene, folder, threads));
    std::fprintf(stderr, "%s: reference of %d seeds in %s\n", scene.name.c_str(), scene.seeds,
                 (folder / "reference.json").c_str());
  }
  return exit_done;
}

}  // namespace

int bench_accuracy_command(const BenchAccuracyArguments& a) {
  const std::filesystem::path folder = a.folder.value_or(case_folder() / "bench/accuracy");
  const std::vector<AccuracyScene> scenes = chosen(a.scene);
  require_knob(a.knob);
  if (a.make_reference) return make_references(scenes, folder, a.threads);
  nlohmann::json points = nlohmann::json::array(), skipped = nlohmann::json::array();
  for (const AccuracyScene& scene : scenes) {
    if (a.scene.empty() && !has_reference(folder / "reference.json", scene.name)) {
      std::fprintf(stderr, "%s: left out, there is no reference of it yet; --make-reference --scene %s makes it\n",
                   scene.name.c_str(), scene.name.c_str());
      skipped.push_back(scene.name);
      continue;
    }
    const Reference reference = read_reference(folder / "reference.json", scene, folder);
    if (!a.json) print_head(scene, reference);
    measure(scene, folder, reference, {.quick = a.quick, .knob = a.knob, .threads = a.threads},
            [&](const Point& point) { a.json ? add_json(point, points) : print(point); });
  }
  if (skipped.size() == scenes.size())
    throw BadInput((folder / "reference.json").string() +
                   " has no reference of any scene; --make-reference makes them");
  if (a.json)
    std::cout << nlohmann::json{{"points", points},
                                {"without_reference", skipped},
                                {"threads", a.threads},
                                {"git", version::git},
                                {"cost", "processor seconds of one thread per simulated second"}}
                     .dump(1)
              << "\n";
  return exit_done;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/reference.hpp"

#include "app/version.hpp"
#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/run/replace_file.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>

namespace gyro::bench {
namespace {

using nlohmann::json;

/// The content of the file; an empty object if it does not exist.
json read_all(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return json::object();
  const json all = json::parse(read_file(file), nullptr, false);
  if (all.is_discarded()) throw BadInput(file.string() + " is not JSON; make it with --make-reference");
  return all;
}

bool known_at_first_break(const Metric& metric) {
  return metric.family == Family::path || metric.family == Family::identity;
}

Reference::Table fine_table(const Ensemble& ensemble, const AccuracyScene& scene) {
  Reference::Table table;
  for (const Metric& metric : scene.metrics) table[metric.name] = ensemble.values(metric.name);
  return table;
}

Reference::Table coarse_table(const Ensemble& ensemble, const AccuracyScene& scene) {
  Reference::Table table;
  for (const Metric& metric : scene.metrics)
    if (known_at_first_break(metric)) table[metric.name] = ensemble.values(metric.name);
  return table;
}

/// Metrics that the coarse table lacks are NaN for all seeds.
Reference::Table read_table(const json& values, const AccuracyScene& scene, std::size_t seeds) {
  Reference::Table table;
  for (const Metric& metric : scene.metrics)
    if (!values.contains(metric.name) && !known_at_first_break(metric))
      table[metric.name].assign(seeds, std::numeric_limits<double>::quiet_NaN());
  for (const auto& [name, row] : values.items())
    for (const json& x : row)  // null: there was nothing to measure
      table[name].push_back(x.is_null() ? std::numeric_limits<double>::quiet_NaN() : x.get<double>());
  return table;
}

const std::string how_to_make = "`gyrosim bench accuracy --make-reference` makes it";

Ensemble sound_ensemble(const AccuracyScene& scene, const std::filesystem::path& folder, const KnobSetting& setting,
                        int threads) {
  Ensemble ensemble = run_ensemble({&scene, folder, setting, 1}, scene.seeds, threads);
  if (ensemble.stopped() > 0)
    throw StoppedByGuard("the reference of " + scene.name + " cannot be made: " + ensemble.first_reason());
  return ensemble;
}

}  // namespace

Reference make_reference(const AccuracyScene& scene, const std::filesystem::path& folder, int threads) {
  const Ensemble fine = sound_ensemble(scene, folder, reference_setting(), threads);
  const Ensemble coarse = sound_ensemble(scene, folder, coarse_reference_setting(), threads);
  Reference r;
  r.fine = fine_table(fine, scene);
  r.coarse = coarse_table(coarse, scene);
  r.seeds = scene.seeds;
  r.time_step = fine.members.front().time_step;
  r.cpu_per_simulated_second = fine.cpu_per_simulated_second();
  r.fingerprint = fingerprint(scene, folder);
  r.git = version::git;
  r.command = "gyrosim bench accuracy --make-reference --scene " + scene.name;
  return r;
}

void write_reference(const std::filesystem::path& file, const std::string& scene, const Reference& r) {
  json all = read_all(file);
  json settings = json::object();
  for (const auto& [name, setting] : {std::pair{"fine", reference_setting()}, {"coarse", coarse_reference_setting()}})
    settings[name] = setting.overrides;
  all[scene] = {{"command", r.command},
                {"git", r.git},
                {"settings", settings},
                {"seeds", r.seeds},
                {"time_step", r.time_step},
                {"cpu_seconds_per_simulated_second", r.cpu_per_simulated_second},
                {"scene_fingerprint", r.fingerprint},
                {"fine", r.fine},
                {"coarse", r.coarse}};
  replace_file(file, all.dump(1) + "\n");
}

bool has_reference(const std::filesystem::path& file, const std::string& scene) {
  return read_all(file).contains(scene);
}

Reference read_reference(const std::filesystem::path& file, const AccuracyScene& scene,
                         const std::filesystem::path& folder) {
  const json all = read_all(file);
  if (!all.contains(scene.name))
    throw BadInput(file.string() + " has no reference of scene " + scene.name + "; " + how_to_make);
  const json& j = all[scene.name];
  try {
    Reference r;
    r.seeds = j.at("seeds");
    const auto seeds = static_cast<std::size_t>(r.seeds);
    r.fine = read_table(j.at("fine"), scene, seeds);
    r.coarse = read_table(j.at("coarse"), scene, seeds);
    r.time_step = j.at("time_step");
    r.cpu_per_simulated_second = j.at("cpu_seconds_per_simulated_second");
    r.fingerprint = j.at("scene_fingerprint");
    r.git = j.at("git");
    r.command = j.at("command");
    if (r.fingerprint != fingerprint(scene, folder))
      throw BadInput(file.string() + ": the reference of " + scene.name +
                     " was made with another case or start state; " + how_to_make + " again");
    for (const Metric& metric : scene.metrics)
      if (r.fine.at(metric.name).size() != seeds || r.coarse.at(metric.name).size() != seeds)
        throw std::out_of_range(metric.name);
    return r;
  } catch (const json::exception& problem) {
    throw BadInput(file.string() + ": " + problem.what() + "; " + how_to_make);
  } catch (const std::out_of_range& metric) {
    throw BadInput(file.string() + ": the reference of " + scene.name + " lacks a metric or a seed; " + how_to_make);
  }
}

}  // namespace gyro::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/run_data.hpp"

#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <sstream>

namespace gyro::report {
namespace {

std::optional<Table> read_series(const hdf5::File& file) {
  std::vector<std::string> names{"eccentric_speed", "eccentric_angle",      "motor_torque",       "mantle_torque",
                                 "motor_power",     "crushing_power",       "mantle_force",       "feed_mass",
                                 "discharged_mass", "holdup_mass",          "escaped_mass",       "throughput",
                                 "particles",       "bonds_broken_tension", "bonds_broken_shear", "fragments"};
  if (!file.contains("/series")) return std::nullopt;
  for (const std::string& name : file.children("/series"))
    if (name.starts_with("wall_force_")) names.push_back(name);
  return read_table(file, "/series", names);
}

std::optional<Table> read_ledger(const hdf5::File& file) {
  return read_table(file, "/ledger",
                    {"kinetic", "potential", "contact_elastic", "bond_elastic", "contact_damping", "friction",
                     "bond_damping", "bond_breakage", "wall_work", "exchanged", "switched", "energy_residual"});
}

std::optional<double> number_of(const hdf5::File& file, const std::string& group, const char* name) {
  try {
    return file.number_attribute(group, name);
  } catch (const OutputError&) {
    return std::nullopt;  // a run without bonds, or of an older version
  }
}

std::optional<Sieved> read_sieved(const hdf5::File& file, const std::string& group) {
  auto table = read_table(file, group, {"passing", "passing_with_fines", "mass", "p80"});
  if (!table || table->rows() == 0 || !file.contains(group + "/sizes")) return std::nullopt;
  return Sieved{std::move(*table), file.dataset(group + "/sizes").read(), number_of(file, group, "resolution"),
                number_of(file, group, "finest_particle")};
}

std::optional<Breaks> read_breaks(const hdf5::File& file) {
  const auto table = read_table(file, "/breakage", {"mode", "position", "energy"});
  if (!table || !table->find("mode") || !table->find("position")) return std::nullopt;
  Breaks breaks{table->time(), table->find("position")->part(2), {}, table->values("energy")};
  for (const double mode : table->values("mode")) breaks.mode.push_back(static_cast<int>(mode));
  return breaks;
}

std::vector<LinerMaps> read_liners(const hdf5::File& file) {
  std::vector<LinerMaps> all;
  if (!file.contains("/liners")) return all;
  for (const std::string& wall : file.children("/liners")) {
    const std::string group = "/liners/" + wall;
    auto table = read_table(file, group, {"pressure", "work"});
    if (!table || table->rows() == 0) continue;
    LinerMaps maps{wall, std::move(*table), file.dataset(group + "/heights").read(),
                   file.dataset(group + "/azimuths").read(), file.dataset(group + "/area").read()};
    if (maps.heights.size() < 2 || maps.azimuths.size() < 2) continue;
    if ((maps.heights.size() - 1) * (maps.azimuths.size() - 1) == maps.area.size()) all.push_back(std::move(maps));
  }
  return all;
}

Provenance read_provenance(const hdf5::File& file) {
  const auto text = [&](const char* name) { return file.string_attribute("/case", name); };
  return {text("resolved_yaml"), text("version"),   text("git_hash"),
          text("device"),        text("precision"), std::to_string(file.integer_attribute("/case", "seed"))};
}

void read_results(const hdf5::File& file, RunData& run) {
  run.provenance = read_provenance(file);
  run.series = read_series(file);
  run.ledger = read_ledger(file);
  run.performance = read_table(file, "/performance", {"wall_seconds", "particle_steps", "bond_steps", "list_rebuilds"});
  run.product = read_sieved(file, "/product");
  run.holdup = read_sieved(file, "/holdup");
  run.breaks = read_breaks(file);
  run.liners = read_liners(file);
}

}  // namespace

double RunData::end() const {
  return series && series->rows() > 0 ? series->time().back() : summary.simulated_seconds;
}

std::optional<double> RunData::gyrations() const {
  const std::vector<double> angle = series ? series->values("eccentric_angle") : std::vector<double>();
  if (angle.empty()) return std::nullopt;
  return std::abs(angle.back()) / (2 * std::numbers::pi);
}

std::vector<std::pair<std::string, double>> phases_of(const std::string& log) {
  constexpr std::string_view mark = " info: phase ";
  std::map<std::string, double> seconds;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find(mark), colon = line.rfind(": ");
    if (begin == std::string::npos || colon == std::string::npos || colon < begin + mark.size()) continue;
    const std::string name = line.substr(begin + mark.size(), colon - begin - mark.size());
    seconds[name] += std::strtod(line.c_str() + colon + 2, nullptr);
  }
  std::vector<std::pair<std::string, double>> phases(seconds.begin(), seconds.end());
  std::ranges::stable_sort(phases, std::greater{}, &std::pair<std::string, double>::second);
  return phases;
}

RunData read_run(const std::filesystem::path& directory) {
  RunData run;
  run.directory = directory;
  run.summary = load_summary(directory);
  const std::filesystem::path results = directory / "results.h5", log = directory / "log.txt";
  if (!std::filesystem::exists(results))
    throw BadInput(results.string() + ": does not exist; give the directory of a run");
  try {
    read_results(hdf5::File::open(results), run);
  } catch (const OutputError& problem) {
    throw BadInput(results.string() + ": is damaged (" + problem.what() + "); restore the file, or run the case again");
  }
  run.facts = case_facts(run.provenance.yaml, directory / "case.yaml");
  if (std::filesystem::exists(log)) run.phases = phases_of(read_file(log));
  return run;
}

void name_runs(std::vector<RunData>& runs) {
  for (RunData& run : runs) {
    const auto path = std::filesystem::absolute(run.directory).lexically_normal();
    run.name = path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
  }
  std::map<std::string, int> uses;
  for (const RunData& run : runs) ++uses[run.name];
  for (RunData& run : runs)
    if (uses[run.name] > 1) run.name = run.directory.lexically_normal().string();
  std::map<std::string, int> before;  // a directory that is given twice
  for (RunData& run : runs)
    if (const int number = ++before[run.name]; number > 1) run.name += " (" + std::to_string(number) + ")";
}

}  // namespace gyro::report

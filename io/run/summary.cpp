// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/summary.hpp"

#include "io/run/replace_file.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace gyro {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json steady_json(const std::optional<SteadyFigures>& s) {
  if (!s) return nullptr;
  return {{"from", number(s->from)},
          {"crushing_power", number(s->crushing_power)},
          {"throughput_tph", number(s->throughput_tph)},
          {"residence_time", number(s->residence_time)}};
}

Json laboratory_json(const std::optional<LaboratoryFigures>& l) {
  if (!l) return nullptr;
  return {{"test", l->test},
          {"size", number(l->size)},
          {"broken_before", l->broken_before},
          {"first_break_force", number(l->first_break_force)},
          {"middle_breaks", number(l->middle_breaks)},
          {"failure_force", number(l->failure_force)},
          {"failure_displacement", number(l->failure_displacement)},
          {"strength", number(l->strength)},
          {"stiffness", number(l->stiffness)},
          {"modulus", number(l->modulus)}};
}

}  // namespace

std::string to_string(RunStatus status) {
  switch (status) {
    case RunStatus::done:
      return "done";
    case RunStatus::interrupted:
      return "interrupted";
    case RunStatus::stopped:
      return "stopped";
    case RunStatus::failed:
      return "failed";
  }
  return "failed";
}

std::string to_json(const Summary& s) {
  Json events = Json::array();
  for (const DriveHappening& event : s.drive_events)
    events.push_back({{"time", number(event.time)}, {"event", event.what}});
  const Json json = {{"status", to_string(s.status)},
                     {"reason", text_or_null(s.reason)},
                     {"title", s.title},
                     {"version", s.version},
                     {"git", s.git_hash},
                     {"device", s.device},
                     {"threads", s.threads},
                     {"precision", s.precision},
                     {"simulated_seconds", number(s.simulated_seconds)},
                     {"wall_seconds", number(s.wall_seconds)},
                     {"particle_steps", s.particle_steps},
                     {"bond_steps", s.bond_steps},
                     {"time_step", number(s.time_step)},
                     {"time_step_limit", number(s.time_step_limit)},
                     {"particles", s.particles},
                     {"bonds_initial", s.bonds_initial},
                     {"bonds_broken", s.bonds_broken},
                     {"feed_mass", number(s.feed_mass)},
                     {"feed_waiting", number(s.feed_waiting)},
                     {"discharged_mass", number(s.discharged_mass)},
                     {"throughput_tph", number(s.throughput_tph)},
                     {"specific_energy_kwh_per_t", number(s.specific_energy_kwh_per_t)},
                     {"mean_crushing_power", number(s.mean_crushing_power)},
                     {"p80", number(s.p80)},
                     {"p50", number(s.p50)},
                     {"product_below_css", number(s.product_below_css)},
                     {"product_below_oss", number(s.product_below_oss)},
                     {"singles_share", number(s.singles_share)},
                     {"swell_of_crumbled", number(s.swell_of_crumbled)},
                     {"energy_residual_fraction", number(s.energy_residual_fraction)},
                     {"momentum_residual_fraction", number(s.momentum_residual_fraction)},
                     {"mass_residual_fraction", number(s.mass_residual_fraction)},
                     {"max_overlap_ratio", number(s.max_overlap_ratio)},
                     {"stalled", s.stalled},
                     {"choked", s.choked ? Json(*s.choked) : Json(nullptr)},
                     {"holdup_mass", number(s.holdup_mass)},
                     {"steady", steady_json(s.steady)},
                     {"laboratory", laboratory_json(s.laboratory)},
                     {"drive_events", events}};
  // A title may hold bytes that are no UTF-8; they must not cost the summary.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const Summary& summary, const std::filesystem::path& directory) {
  replace_file(directory / "summary.json", to_json(summary), true);
}

std::optional<EarlierRun> read_summary(const std::filesystem::path& directory) {
  std::ifstream file(directory / "summary.json");
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("status") || !json["status"].is_string()) return std::nullopt;
  EarlierRun run{json["status"].get<std::string>(), 0};
  if (json.contains("simulated_seconds") && json["simulated_seconds"].is_number())
    run.simulated_seconds = json["simulated_seconds"].get<double>();
  return run;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of the values of the summary to JSON and back.
#include "core/base/errors.hpp"
#include "io/run/summary_table.hpp"

#include <cmath>

namespace gyro {

Json json_of(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(bool value) {
  return value;
}

Json json_of(int value) {
  return value;
}

Json json_of(std::int64_t value) {
  return value;
}

Json json_of(RunStatus status) {
  return to_string(status);
}

Json json_of(const std::string& text) {
  return text;
}

Json json_of(const SteadyFigures& steady) {
  return json_of(steady_figures(), steady);
}

Json json_of(const MotorFigures& motor) {
  return json_of(motor_figures(), motor);
}

Json json_of(const LaboratoryFigures& laboratory) {
  return json_of(laboratory_figures(), laboratory);
}

Json json_of(const FinesFigures& fines) {
  return json_of(fines_figures(), fines);
}

Json json_of(const std::vector<DriveHappening>& events) {
  Json all = Json::array();
  for (const DriveHappening& event : events) all.push_back(json_of(drive_event_figures(), event));
  return all;
}

void read(const Json& json, double& value) {
  value = json.get<double>();
}

void read(const Json& json, bool& value) {
  value = json.get<bool>();
}

void read(const Json& json, int& value) {
  value = json.get<int>();
}

void read(const Json& json, std::int64_t& value) {
  value = json.get<std::int64_t>();
}

void read(const Json& json, RunStatus& status) {
  const auto word = json.get<std::string>();
  for (const RunStatus known : {RunStatus::done, RunStatus::interrupted, RunStatus::stopped, RunStatus::failed})
    if (to_string(known) == word) {
      status = known;
      return;
    }
  throw BadInput("status `" + word + "` is unknown");
}

void read(const Json& json, std::string& text) {
  text = json.get<std::string>();
}

void read(const Json& json, SteadyFigures& steady) {
  read(steady_figures(), json, steady);
}

void read(const Json& json, MotorFigures& motor) {
  read(motor_figures(), json, motor);
}

void read(const Json& json, LaboratoryFigures& laboratory) {
  read(laboratory_figures(), json, laboratory);
}

void read(const Json& json, FinesFigures& fines) {
  read(fines_figures(), json, fines);
}

void read(const Json& json, std::vector<DriveHappening>& events) {
  for (const Json& event : json) read(drive_event_figures(), event, events.emplace_back());
}

}  // namespace gyro

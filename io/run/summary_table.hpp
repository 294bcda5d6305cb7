// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/summary.hpp"
#include "io/run/text.hpp"

#include <concepts>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace gyro {

using Json = nlohmann::ordered_json;

/// JSON of a figure's value; what is not there or not finite is null.
Json json_of(double value);
Json json_of(const std::optional<double>& value);
Json json_of(std::optional<bool> value);
Json json_of(bool value);
Json json_of(std::int64_t value);
Json json_of(const std::string& text);
Json json_of(const std::optional<std::string>& text);
Json json_of(const std::optional<SteadyFigures>& steady);
Json json_of(const std::optional<MotorFigures>& motor);
Json json_of(const std::optional<LaboratoryFigures>& laboratory);
Json json_of(const std::vector<DriveHappening>& events);

/// The function of a figure: a lambda without captures.
template <class S>
class FigureValue {
 public:
  template <class F>
  requires std::is_empty_v<F> && std::invocable<F, const S&>
  constexpr FigureValue(F) : json_([](const S& s) { return json_of(F{}(s)); }) {}
  Json operator()(const S& s) const { return json_(s); }

 private:
  Json (*json_)(const S&);
};

/// A member of summary.json: what is said of it, where its value comes from, and its line on the terminal.
template <class S>
struct Figure {
  Text name;
  Text units;  ///< "1" for a pure number, "-" for what is no number
  FigureValue<S> value;
  Text description;
  const char* when = "always";              ///< else it is null
  std::string (*line)(const S&) = nullptr;  ///< empty where it says nothing about this run
};

/// The tables, in the order of the file and of the terminal.
const std::vector<Figure<Summary>>& summary_figures();
const std::vector<Figure<SteadyFigures>>& steady_figures();
const std::vector<Figure<MotorFigures>>& motor_figures();
const std::vector<Figure<LaboratoryFigures>>& laboratory_figures();
const std::vector<Figure<DriveHappening>>& drive_event_figures();

template <class S>
Json json_of(const std::vector<Figure<S>>& table, const S& s) {
  Json json = Json::object();
  for (const Figure<S>& figure : table) json[std::string(figure.name)] = figure.value(s);
  return json;
}

template <class S>
std::string lines_of(const std::vector<Figure<S>>& table, const S& s) {
  std::string text;
  for (const Figure<S>& figure : table)
    if (figure.line) text += figure.line(s);
  return text;
}

}  // namespace gyro

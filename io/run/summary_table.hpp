// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "io/run/summary.hpp"
#include "io/run/text.hpp"

#include <limits>
#include <nlohmann/json.hpp>

namespace gyro {

using Json = nlohmann::ordered_json;

/// JSON of the value of a figure. A missing value and a number that is not finite are null.
Json json_of(double value);
Json json_of(bool value);
Json json_of(int value);
Json json_of(std::int64_t value);
Json json_of(RunStatus status);
Json json_of(const std::string& text);
Json json_of(const SteadyFigures& steady);
Json json_of(const MotorFigures& motor);
Json json_of(const LaboratoryFigures& laboratory);
Json json_of(const FinesFigures& fines);
Json json_of(const std::vector<DriveHappening>& events);
template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : Json(nullptr);
}

/// Sets a value from its JSON, which must not be null. @throws Json::exception for JSON of another type; BadInput for
/// an unknown status
void read(const Json& json, double& value);
void read(const Json& json, bool& value);
void read(const Json& json, int& value);
void read(const Json& json, std::int64_t& value);
void read(const Json& json, RunStatus& status);
void read(const Json& json, std::string& text);
void read(const Json& json, SteadyFigures& steady);
void read(const Json& json, MotorFigures& motor);
void read(const Json& json, LaboratoryFigures& laboratory);
void read(const Json& json, FinesFigures& fines);
void read(const Json& json, std::vector<DriveHappening>& events);
template <class T>
void read(const Json& json, std::optional<T>& value) {
  read(json, value.emplace());
}

inline const Estimate* there(const Estimate& e) {
  return &e;
}
inline const Estimate* there(const std::optional<Estimate>& e) {
  return e ? &*e : nullptr;
}

/// Access to the value of a figure: a member of a struct, or one of the two numbers of an estimate.
template <auto Member>
struct Field {
  template <class S>
  static Json write(const S& s) {
    return json_of(s.*Member);
  }
  template <class S>
  static void fill(S& s, const Json& json) {
    read(json, s.*Member);
  }
};
template <auto Member>
struct TextOrNull : Field<Member> {
  template <class S>
  static Json write(const S& s) {
    return (s.*Member).empty() ? Json(nullptr) : json_of(s.*Member);
  }
};
template <auto Member>
struct EstimateValue {
  template <class S>
  static Json write(const S& s) {
    const Estimate* e = there(s.*Member);
    return e ? json_of(e->value) : Json(nullptr);
  }
  template <class S>
  static void fill(S& s, const Json& json) {
    s.*Member = Estimate{json.get<double>(), std::numeric_limits<double>::quiet_NaN()};
  }
};
template <auto Member>
struct EstimateError {
  template <class S>
  static Json write(const S& s) {
    const Estimate* e = there(s.*Member);
    return e ? json_of(e->error) : Json(nullptr);
  }
  template <class S>
  static void fill(S& s, const Json& json) {
    if (const Estimate* e = there(s.*Member)) s.*Member = Estimate{e->value, json.get<double>()};
  }
};
template <auto Member>
inline constexpr Field<Member> field{};
template <auto Member>
inline constexpr TextOrNull<Member> text_or_null{};  ///< null if the text is empty
template <auto Member>
inline constexpr EstimateValue<Member> estimate_value{};
template <auto Member>
inline constexpr EstimateError<Member> estimate_error{};  ///< must follow the value in the table

/// Writes and reads the value of a figure.
template <class S>
class FigureValue {
 public:
  template <class Place>
  constexpr FigureValue(const Place&) : write_(&Place::template write<S>), fill_(&Place::template fill<S>) {}
  Json operator()(const S& s) const { return write_(s); }
  void fill(S& s, const Json& json) const { fill_(s, json); }

 private:
  Json (*write_)(const S&);
  void (*fill_)(S&, const Json&);
};

/// A member of summary.json: its name, units and description, its value, and its line on the terminal.
template <class S>
struct Figure {
  Text name;
  Text units;  ///< "1" for a pure number, "-" for text, lists and yes/no values
  FigureValue<S> value;
  Text description;
  const char* when = "always";              ///< when it has a value; otherwise it is null
  std::string (*line)(const S&) = nullptr;  ///< its line, empty if it does not apply to the run; null: none
};

/// The tables of figures, in the order of the file and of the lines on the terminal.
const std::vector<Figure<Summary>>& summary_figures();
const std::vector<Figure<SteadyFigures>>& steady_figures();
const std::vector<Figure<MotorFigures>>& motor_figures();
const std::vector<Figure<LaboratoryFigures>>& laboratory_figures();
const std::vector<Figure<FinesFigures>>& fines_figures();
const std::vector<Figure<DriveHappening>>& drive_event_figures();

template <class S>
Json json_of(const std::vector<Figure<S>>& table, const S& s) {
  Json json = Json::object();
  for (const Figure<S>& figure : table) json[std::string(figure.name)] = figure.value(s);
  return json;
}

/// Sets the members of a struct from JSON. Members that are missing or null in the JSON stay unchanged.
template <class S>
void read(const std::vector<Figure<S>>& table, const Json& json, S& s) {
  if (!json.is_object()) throw BadInput("`" + json.dump() + "` is not an object with figures");
  for (const Figure<S>& figure : table)
    if (const auto found = json.find(std::string(figure.name)); found != json.end() && !found->is_null())
      figure.value.fill(s, *found);
}

template <class S>
std::string lines_of(const std::vector<Figure<S>>& table, const S& s) {
  std::string text;
  for (const Figure<S>& figure : table)
    if (figure.line) text += figure.line(s);
  return text;
}

}  // namespace gyro

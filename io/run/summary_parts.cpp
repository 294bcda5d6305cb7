// SPDX-License-Identifier: GPL-3.0-or-later
// Members of members of summary.json.
#include "io/run/summary_lines.hpp"
#include "io/run/summary_table.hpp"

namespace gyro {
namespace {

constexpr const char* if_failed = "if the rock failed";

}  // namespace

const std::vector<Figure<SteadyFigures>>& steady_figures() {
  static const std::vector<Figure<SteadyFigures>> figures{
      {.name = "from",
       .units = "s",
       .value = [](const SteadyFigures& s) { return s.from; },
       .description = "time from which on the run shows no drift"},
      {.name = "crushing_power",
       .units = "W",
       .value = [](const SteadyFigures& s) { return s.crushing_power; },
       .description = "crushing power, mean since then"},
      {.name = "throughput_tph",
       .units = "t/h",
       .value = [](const SteadyFigures& s) { return s.throughput_tph; },
       .description = "discharged mass / time since then"},
      {.name = "residence_time",
       .units = "s",
       .value = [](const SteadyFigures& s) { return s.residence_time; },
       .description = "hold-up / throughput",
       .when = "with discharge"},
  };
  return figures;
}

const std::vector<Figure<LaboratoryFigures>>& laboratory_figures() {
  static const std::vector<Figure<LaboratoryFigures>> figures{
      {.name = "test",
       .units = "-",
       .value = [](const LaboratoryFigures& s) { return s.test; },
       .description = "platen, brazilian or uniaxial",
       .line =
           [](const LaboratoryFigures& s) {
             return line("test", s.test + format(", %.4g mm between the platens at first contact", s.size * 1e3));
           }},
      {.name = "size",
       .units = "m",
       .value = [](const LaboratoryFigures& s) { return s.size; },
       .description = "distance of the platens at first contact"},
      {.name = "broken_before",
       .units = "1",
       .value = [](const LaboratoryFigures& s) { return static_cast<std::int64_t>(s.broken_before); },
       .description = "bonds that broke before the moving platen pressed",
       .line =
           [](const LaboratoryFigures& s) {
             return s.broken_before > 0 ? line("before the test", std::to_string(s.broken_before) + " bonds broke")
                                        : std::string();
           }},
      {.name = "first_break_force",
       .units = "N",
       .value = [](const LaboratoryFigures& s) { return s.first_break_force; },
       .description = "force on the platens when the first bond broke",
       .when = "if a bond broke",
       .line =
           [](const LaboratoryFigures& s) {
             return s.first_break_force ? line("first bond broke", format("at %.4g N", *s.first_break_force))
                                        : std::string();
           }},
      {.name = "middle_breaks",
       .units = "1",
       .value = [](const LaboratoryFigures& s) { return s.middle_breaks; },
       .description = "share of the first breaks in the middle third between the platens",
       .when = "in a brazilian test, if a bond broke",
       .line =
           [](const LaboratoryFigures& s) {
             return s.middle_breaks
                        ? line("first breaks", format("%.0f %% of them in the middle third", 100 * *s.middle_breaks))
                        : std::string();
           }},
      {.name = "failure_force",
       .units = "N",
       .value = [](const LaboratoryFigures& s) { return s.failure_force; },
       .description = "largest force until failure",
       .when = if_failed,
       .line = failure_line},
      {.name = "failure_displacement",
       .units = "m",
       .value = [](const LaboratoryFigures& s) { return s.failure_displacement; },
       .description = "displacement of the platens since first contact",
       .when = if_failed},
      {.name = "strength",
       .units = "Pa",
       .value = [](const LaboratoryFigures& s) { return s.strength; },
       .description = "strength by the formula of the test",
       .when = if_failed,
       .line = [](const LaboratoryFigures& s) { return number_line("strength", s.strength, 1e-6, " MPa"); }},
      {.name = "stiffness",
       .units = "N/m",
       .value = [](const LaboratoryFigures& s) { return s.stiffness; },
       .description = "slope of the curve between 20 and 60 % of the failure force",
       .when = if_failed,
       .line = [](const LaboratoryFigures& s) { return number_line("stiffness", s.stiffness, 1e-6, " MN/m"); }},
      {.name = "modulus",
       .units = "Pa",
       .value = [](const LaboratoryFigures& s) { return s.modulus; },
       .description = "stiffness x length / area",
       .when = "in a uniaxial test, if the rock failed",
       .line = [](const LaboratoryFigures& s) { return number_line("modulus", s.modulus, 1e-9, " GPa"); }},
  };
  return figures;
}

const std::vector<Figure<DriveHappening>>& drive_event_figures() {
  static const std::vector<Figure<DriveHappening>> figures{
      {.name = "time",
       .units = "s",
       .value = [](const DriveHappening& s) { return s.time; },
       .description = "simulated time"},
      {.name = "event",
       .units = "-",
       .value = [](const DriveHappening& s) { return s.what; },
       .description = "what happened"},
  };
  return figures;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
// Members of the objects in summary.json.
#include "io/run/summary_lines.hpp"
#include "io/run/summary_table.hpp"

namespace gyro {
namespace {

constexpr const char* if_failed = "if the rock failed";
constexpr const char* with_discharge = "with discharge since then";
constexpr const char* with_fines = "with discharge since then, and output.fines";
constexpr const char* with_breakage_fines = "with output.fines.breakage";
constexpr const char* with_motor = "with a drivetrain that gives it";
constexpr const char* with_name_plate = "with a motor that has a rated power";

}  // namespace

const std::vector<Figure<SteadyFigures>>& steady_figures() {
  using S = SteadyFigures;
  static const std::vector<Figure<S>> figures{
      {.name = "from", .units = "s", .value = field<&S::from>, .description = "time from which the run shows no drift"},
      {.name = "gyrations", .units = "1", .value = field<&S::gyrations>, .description = "whole gyrations since then"},
      {.name = "blocks",
       .units = "1",
       .value = field<&S::blocks>,
       .description = "blocks of whole gyrations from which the standard errors are computed by the jackknife"},
      {.name = "crushing_power",
       .units = "W",
       .value = estimate_value<&S::crushing_power>,
       .description = "crushing power, mean since then"},
      {.name = "crushing_power_error",
       .units = "W",
       .value = estimate_error<&S::crushing_power>,
       .description = "its standard error"},
      {.name = "motor_power",
       .units = "W",
       .value = estimate_value<&S::motor_power>,
       .description = "mechanical power of the motor at its shaft, mean since then",
       .when = with_motor},
      {.name = "motor_power_error",
       .units = "W",
       .value = estimate_error<&S::motor_power>,
       .description = "its standard error",
       .when = with_motor},
      {.name = "throughput_tph",
       .units = "t/h",
       .value = estimate_value<&S::throughput_tph>,
       .description = "discharged mass / time since then"},
      {.name = "throughput_tph_error",
       .units = "t/h",
       .value = estimate_error<&S::throughput_tph>,
       .description = "its standard error"},
      {.name = "specific_energy_kwh_per_t",
       .units = "kWh/t",
       .value = estimate_value<&S::specific_energy_kwh_per_t>,
       .description = "crushing energy / discharged mass since then",
       .when = with_discharge},
      {.name = "specific_energy_kwh_per_t_error",
       .units = "kWh/t",
       .value = estimate_error<&S::specific_energy_kwh_per_t>,
       .description = "its standard error",
       .when = with_discharge},
      {.name = "p80",
       .units = "m",
       .value = estimate_value<&S::p80>,
       .description = "size that 80 % of the product since then passes",
       .when = with_discharge},
      {.name = "p80_error",
       .units = "m",
       .value = estimate_error<&S::p80>,
       .description = "its standard error",
       .when = with_discharge},
      {.name = "p50",
       .units = "m",
       .value = estimate_value<&S::p50>,
       .description = "size that 50 % of the product since then passes",
       .when = with_discharge},
      {.name = "p50_error",
       .units = "m",
       .value = estimate_error<&S::p50>,
       .description = "its standard error",
       .when = with_discharge},
      {.name = "product_below_css",
       .units = "1",
       .value = estimate_value<&S::product_below_css>,
       .description = "share of the product since then that passes the closed side setting; null outside the sieves",
       .when = with_discharge},
      {.name = "product_below_css_error",
       .units = "1",
       .value = estimate_error<&S::product_below_css>,
       .description = "its standard error",
       .when = with_discharge},
      {.name = "product_below_oss",
       .units = "1",
       .value = estimate_value<&S::product_below_oss>,
       .description = "share of the product since then that passes the open side setting; null outside the sieves",
       .when = with_discharge},
      {.name = "product_below_oss_error",
       .units = "1",
       .value = estimate_error<&S::product_below_oss>,
       .description = "its standard error",
       .when = with_discharge},
      {.name = "p80_with_fines",
       .units = "m",
       .value = estimate_value<&S::p80_with_fines>,
       .description = "p80 with estimated fines",
       .when = with_fines},
      {.name = "p80_with_fines_error",
       .units = "m",
       .value = estimate_error<&S::p80_with_fines>,
       .description = "its standard error",
       .when = with_fines},
      {.name = "p50_with_fines",
       .units = "m",
       .value = estimate_value<&S::p50_with_fines>,
       .description = "p50 with estimated fines",
       .when = with_fines},
      {.name = "p50_with_fines_error",
       .units = "m",
       .value = estimate_error<&S::p50_with_fines>,
       .description = "its standard error",
       .when = with_fines},
      {.name = "residence_time",
       .units = "s",
       .value = field<&S::residence_time>,
       .description = "hold-up / throughput",
       .when = with_discharge},
  };
  return figures;
}

const std::vector<Figure<MotorFigures>>& motor_figures() {
  using S = MotorFigures;
  static const std::vector<Figure<S>> figures{
      {.name = "from",
       .units = "s",
       .value = field<&S::from>,
       .description = "the figures are of the rows of /series that begin at this time or later: when the run becomes "
                      "steady, or 0"},
      {.name = "mean", .units = "W", .value = field<&S::mean>, .description = "mechanical power at the shaft, mean"},
      {.name = "p95",
       .units = "W",
       .value = field<&S::p95>,
       .description =
           "95th percentile of motor_power in the rows of /series: 95 % of the rows have at most this value"},
      {.name = "peak",
       .units = "W",
       .value = field<&S::peak>,
       .description = "largest motor_power in a row of /series"},
      {.name = "rated_power",
       .units = "W",
       .value = field<&S::rated_power>,
       .description = "power on the name plate",
       .when = with_name_plate},
      {.name = "mean_fraction",
       .units = "1",
       .value = field<&S::mean_fraction>,
       .description = "mean / rated power",
       .when = with_name_plate},
      {.name = "peak_fraction",
       .units = "1",
       .value = field<&S::peak_fraction>,
       .description = "peak / rated power",
       .when = with_name_plate},
  };
  return figures;
}

const std::vector<Figure<LaboratoryFigures>>& laboratory_figures() {
  static const std::vector<Figure<LaboratoryFigures>> figures{
      {.name = "test",
       .units = "-",
       .value = field<&LaboratoryFigures::test>,
       .description = "platen, brazilian or uniaxial",
       .line =
           [](const LaboratoryFigures& s) {
             return line("test", s.test + format(", %.4g mm between the platens at first contact", s.size * 1e3));
           }},
      {.name = "size",
       .units = "m",
       .value = field<&LaboratoryFigures::size>,
       .description = "distance of the platens at first contact"},
      {.name = "broken_before",
       .units = "1",
       .value = field<&LaboratoryFigures::broken_before>,
       .description = "bonds that broke before the moving platen pressed",
       .line =
           [](const LaboratoryFigures& s) {
             return s.broken_before > 0 ? line("before the test", std::to_string(s.broken_before) + " bonds broke")
                                        : std::string();
           }},
      {.name = "first_break_force",
       .units = "N",
       .value = field<&LaboratoryFigures::first_break_force>,
       .description = "force on the platens when the first bond broke",
       .when = "if a bond broke",
       .line =
           [](const LaboratoryFigures& s) {
             return s.first_break_force ? line("first bond broke", format("at %.4g N", *s.first_break_force))
                                        : std::string();
           }},
      {.name = "middle_breaks",
       .units = "1",
       .value = field<&LaboratoryFigures::middle_breaks>,
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
       .value = field<&LaboratoryFigures::failure_force>,
       .description = "largest force until failure",
       .when = if_failed,
       .line = failure_line},
      {.name = "failure_displacement",
       .units = "m",
       .value = field<&LaboratoryFigures::failure_displacement>,
       .description = "displacement of the platens since first contact",
       .when = if_failed},
      {.name = "strength",
       .units = "Pa",
       .value = field<&LaboratoryFigures::strength>,
       .description = "strength by the formula of the test",
       .when = if_failed,
       .line = [](const LaboratoryFigures& s) { return number_line("strength", s.strength, 1e-6, " MPa"); }},
      {.name = "stiffness",
       .units = "N/m",
       .value = field<&LaboratoryFigures::stiffness>,
       .description = "slope of the curve between 20 and 60 % of the failure force",
       .when = if_failed,
       .line = [](const LaboratoryFigures& s) { return number_line("stiffness", s.stiffness, 1e-6, " MN/m"); }},
      {.name = "modulus",
       .units = "Pa",
       .value = field<&LaboratoryFigures::modulus>,
       .description = "stiffness x length / area",
       .when = "in a uniaxial test, if the rock failed",
       .line = [](const LaboratoryFigures& s) { return number_line("modulus", s.modulus, 1e-9, " GPa"); }},
  };
  return figures;
}

const std::vector<Figure<FinesFigures>>& fines_figures() {
  using S = FinesFigures;
  static const std::vector<Figure<S>> figures{
      {.name = "law",
       .units = "-",
       .value = field<&S::law>,
       .description = "what the estimate is made with: breakage or gates_gaudin_schuhmann, as in output.fines"},
      {.name = "p80",
       .units = "m",
       .value = field<&S::p80>,
       .description = "size that 80 % of the product of the whole run passes, with estimated fines"},
      {.name = "p50",
       .units = "m",
       .value = field<&S::p50>,
       .description = "size that 50 % of the product of the whole run passes, with estimated fines"},
      {.name = "share",
       .units = "1",
       .value = field<&S::share>,
       .description = "estimated share of the product that is finer than the coarsest particle of its fragment"},
      {.name = "released_energy_kwh_per_t",
       .units = "kWh/t",
       .value = field<&S::released_energy_kwh_per_t>,
       .description = "elastic energy that the broken bonds of the product released / its mass"},
      {.name = "t10",
       .units = "1",
       .value = field<&S::t10>,
       .description =
           "share finer than a tenth of the size that a rock was fed with, by that energy, mean over the product",
       .when = with_breakage_fines},
      {.name = "beyond_share",
       .units = "1",
       .value = field<&S::beyond_share>,
       .description = "share of the product with a t10 above 40 %, more than is usual in crushers: the estimate is an "
                      "extrapolation there",
       .when = with_breakage_fines},
  };
  return figures;
}

const std::vector<Figure<DriveHappening>>& drive_event_figures() {
  static const std::vector<Figure<DriveHappening>> figures{
      {.name = "time", .units = "s", .value = field<&DriveHappening::time>, .description = "simulated time"},
      {.name = "event", .units = "-", .value = field<&DriveHappening::what>, .description = "what happened"},
  };
  return figures;
}

}  // namespace gyro

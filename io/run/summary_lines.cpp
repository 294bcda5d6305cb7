// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/summary_lines.hpp"

#include "io/run/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace gyro {
namespace {

std::string speed(double count, double seconds, const char* of) {
  return seconds > 0 ? ", " + format_count(count / seconds) + " " + of + "/s" : std::string();
}

/// A unit for a number: number x factor is the value in this unit.
struct Unit {
  double factor;
  const char* name;
};

Unit mass_unit(double mass) {
  return mass >= 1000 ? Unit{1e-3, "t"} : mass >= 0.1 ? Unit{1, "kg"} : Unit{1e3, "g"};
}
Unit flow_unit(double tph) {
  return tph >= 1 ? Unit{1, "t/h"} : Unit{1e3, "kg/h"};
}
Unit power_unit(double power) {
  return std::abs(power) >= 1000 ? Unit{1e-3, "kW"} : Unit{1, "W"};
}

std::string text_of(double value, const Unit& unit) {
  return format("%.4g ", value * unit.factor) + unit.name;
}
std::string text_of(const Estimate& e, const Unit& unit) {
  return format("%.4g +- %.2g ", e.value * unit.factor, e.error * unit.factor) + unit.name;
}

/// Line with a figure of the steady part if there is one, otherwise of the whole run.
template <class UnitOf>
std::string figure_line(const char* name, const Summary& s, const std::optional<Estimate>& steady,
                        const std::optional<double>& whole, const UnitOf& unit_of, const char* what = "") {
  if (s.steady) return steady ? line(name, text_of(*steady, unit_of(steady->value)) + what) : std::string();
  return whole ? line(name, text_of(*whole, unit_of(*whole)) + what + (s.not_steady ? ", start-up" : ""))
               : std::string();
}

}  // namespace

std::string format(const char* pattern, ...) {
  char text[256];
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text, sizeof text, pattern, values);
  va_end(values);
  return text;
}

std::string line(const char* name, const std::string& value) {
  return format("  %-18s", name) + value + "\n";
}

std::string number_line(const char* name, const std::optional<double>& value, double scale, const char* unit,
                        int digits) {
  return value ? line(name, format("%.*g", digits, *value * scale) + unit) : std::string();
}

std::string mass_line(const char* name, const std::optional<double>& mass) {
  return mass ? line(name, text_of(*mass, mass_unit(*mass))) : std::string();
}

std::string throughput_line(const Summary& s) {
  return figure_line("throughput", s, s.steady ? std::optional(s.steady->throughput_tph) : std::nullopt,
                     s.throughput_tph, flow_unit);
}

std::string p80_line(const Summary& s) {
  return figure_line("product P80", s, s.steady ? s.steady->p80 : std::nullopt, s.p80, [](double) {
    return Unit{1e3, "mm"};
  });
}

std::string crushing_power_line(const Summary& s) {
  return figure_line("crushing power", s, s.steady ? std::optional(s.steady->crushing_power) : std::nullopt,
                     s.mean_crushing_power, power_unit, ", mean");
}

std::string specific_energy_line(const Summary& s) {
  return figure_line("specific energy", s, s.steady ? s.steady->specific_energy_kwh_per_t : std::nullopt,
                     s.specific_energy_kwh_per_t, [](double) {
                       return Unit{1, "kWh/t"};
                     });
}

std::string waiting_line(const Summary& s) {
  if (!s.feed_waiting || !(*s.feed_waiting > 0)) return {};
  return line("waiting", text_of(*s.feed_waiting, mass_unit(*s.feed_waiting)) + ", which found no room");
}

std::string escaped_line(const Summary& s) {
  if (!s.escaped_mass || !(*s.escaped_mass > 0)) return {};
  return line("escaped", text_of(*s.escaped_mass, mass_unit(*s.escaped_mass)) +
                             format(" over the rim, %.2g %% of the feed; not in the product",
                                    100 * s.escaped_fraction.value_or(0)));
}

std::string below_settings_line(const Summary& s) {
  const auto value = [&](std::optional<Estimate> SteadyFigures::*steady, const std::optional<double>& whole) {
    if (!s.steady) return whole;
    const std::optional<Estimate>& e = (*s.steady).*steady;
    return e ? std::optional(e->value) : std::nullopt;
  };
  const auto oss = value(&SteadyFigures::product_below_oss, s.product_below_oss);
  const auto css = value(&SteadyFigures::product_below_css, s.product_below_css);
  std::string text;
  if (oss) text = format("%.3g %% below OSS", 100 * *oss);
  if (css) text += (oss ? ", " : "") + format("%.3g %% below CSS", 100 * *css);
  return text.empty() ? text : line("", text);
}

std::string single_particles_line(const Summary& s) {
  if (!s.singles_share || !s.swell_of_crumbled) return {};
  return line("single particles", format("%.3g %% of the product; crumbled rock swells %.2f-fold, real rock 1.7",
                                         100 * *s.singles_share, *s.swell_of_crumbled));
}

std::string resolution_line(const Summary& s) {
  if (!s.resolution || !s.finest_particle) return {};
  const bool graded = *s.resolution > 1.001 * *s.finest_particle;
  const std::string from = graded ? format("%.3g to ", *s.finest_particle * 1e3) : std::string();
  const std::string finer =
      s.fines ? format("below %.3g mm estimated, by ", *s.resolution * 1e3) +
                    (s.fines->law == "breakage" ? "the energy of breakage" : "a Gates-Gaudin-Schuhmann distribution")
              : std::string("finer product is unknown");
  return line("resolution", "particles of " + from + format("%.3g mm; ", *s.resolution * 1e3) + finer);
}

std::string fines_lines(const Summary& s) {
  if (!s.fines) return {};
  const FinesFigures& f = *s.fines;
  const auto size = [&](const char* name, std::optional<Estimate> SteadyFigures::*steady,
                        const std::optional<double>& whole) -> std::string {
    const Unit mm{1e3, "mm"};
    if (!s.steady) return whole ? name + text_of(*whole, mm) + ", " : std::string();
    const std::optional<Estimate>& e = (*s.steady).*steady;
    return e ? name + text_of(*e, mm) + ", " : std::string();
  };
  std::string text = line("with fines", size("P80 ", &SteadyFigures::p80_with_fines, f.p80) +
                                            size("P50 ", &SteadyFigures::p50_with_fines, f.p50) +
                                            format("%.3g %% finer than its particles", 100 * f.share));
  if (f.t10) {
    const double whole = s.specific_energy_kwh_per_t.value_or(0);
    text += line(
        "t10",
        format("%.3g %%, mean of the product; bonds released %.3g kWh/t", 100 * *f.t10, f.released_energy_kwh_per_t) +
            (whole > 0 ? format(", %.3g %% of the crushing energy", 100 * f.released_energy_kwh_per_t / whole)
                       : std::string()));
  }
  if (f.beyond_share.value_or(0) > 0)
    text += line("", format("above 40 %% for %.3g %% of the product: the estimate is an extrapolation there",
                            100 * *f.beyond_share));
  return text;
}

std::string steady_line(const Summary& s) {
  if (!s.steady) return {};
  return line(
      "steady",
      format("since %.4g s: the figures below are of %lld gyrations, with standard errors from %lld blocks",
             s.steady->from, static_cast<long long>(s.steady->gyrations), static_cast<long long>(s.steady->blocks)));
}

std::string not_steady_line(const Summary& s) {
  return s.not_steady ? line("not steady", *s.not_steady + "; the figures below are of the start-up") : std::string();
}

std::string motor_line(const Summary& s) {
  if (!s.motor) return {};
  const MotorFigures& m = *s.motor;
  const Unit unit = power_unit(std::max(std::abs(m.mean), std::abs(m.peak)));
  std::string text =
      text_of(m.mean, unit) + " mean, " + text_of(m.p95, unit) + " 95 %, " + text_of(m.peak, unit) + " peak";
  if (m.rated_power && m.mean_fraction && m.peak_fraction)
    text += format("; mean %.3g %%, peak %.3g %% of rated ", 100 * *m.mean_fraction, 100 * *m.peak_fraction) +
            text_of(*m.rated_power, power_unit(*m.rated_power));
  return line("motor power", text);
}

std::string drive_event_lines(const Summary& s) {
  constexpr std::size_t max_lines = 6;
  std::string text;
  for (std::size_t k = 0; k < s.drive_events.size() && k < max_lines; ++k)
    text += line("drive", s.drive_events[k].what + format(" at %.6g s", s.drive_events[k].time));
  if (s.drive_events.size() > max_lines) text += line("drive", "... and more, see summary.json");
  return text;
}

std::string particles_line(const Summary& s) {
  if (!s.particles) return {};
  return line("particles",
              std::to_string(*s.particles) + " at the end" +
                  speed(static_cast<double>(s.particle_steps.value_or(0)), s.wall_seconds, "particle-steps"));
}

std::string bonds_line(const Summary& s) {
  if (!s.bonds_broken || s.bonds_initial.value_or(0) <= 0) return {};
  const double share = 100.0 * static_cast<double>(*s.bonds_broken) / static_cast<double>(*s.bonds_initial);
  return line("bonds", std::to_string(*s.bonds_broken) + " of " + std::to_string(*s.bonds_initial) +
                           format(" broken (%.3g %%)", share) +
                           speed(static_cast<double>(s.bond_steps.value_or(0)), s.wall_seconds, "bond-steps"));
}

std::string time_step_line(const Summary& s) {
  if (!(s.time_step > 0)) return {};
  // Without rock and bonds the step has no limit: it is infinite, or 0 after reading, because JSON has no infinity.
  const bool limited = s.time_step_limit > 0 && std::isfinite(s.time_step_limit);
  return line("time step",
              format("%.4g us", s.time_step * 1e6) +
                  (limited ? format(", limit %.4g us", s.time_step_limit * 1e6) : std::string()) +
                  (s.hold > s.time_step ? format(", contacts held for %.4g us", s.hold * 1e6) : std::string()));
}

std::string device_line(const Summary& s) {
  const std::string threads =
      s.threads > 0 ? ", " + std::to_string(s.threads) + (s.threads == 1 ? " thread" : " threads") : std::string();
  return line("ran on", s.device + threads + (s.precision.empty() ? "" : ", " + s.precision + " precision"));
}

std::string failure_line(const LaboratoryFigures& l) {
  if (!l.failure_force || !l.failure_displacement) return line("failure", "none before the end of the run");
  return line("failure", format("at %.4g N, %.3g mm", *l.failure_force, *l.failure_displacement * 1e3));
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/headline.hpp"

#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

/// Collects figures that have a value.
class List {
 public:
  explicit List(const Summary& summary) : s_(summary) {}

  void add(const std::string& key, const char* label, const char* units, const std::optional<double>& value,
           bool big = false) {
    add(key, label, units, value, std::nullopt, big);
  }

  /// A figure of the steady part if the run has one, else of the whole run.
  void add(const std::string& key, const std::string& steady_key, const char* label, const char* units,
           const std::optional<Estimate>& steady, const std::optional<double>& whole, bool big) {
    if (!s_.steady) return add(key, label, units, whole, std::nullopt, big);
    if (steady) add("steady." + steady_key, label, units, steady->value, steady->error, big);
  }

  std::vector<Headline> take() { return std::move(figures_); }

 private:
  void add(const std::string& key, const char* label, const std::string& units, const std::optional<double>& value,
           std::optional<double> error, bool big) {
    if (!value || !std::isfinite(*value)) return;
    if (error && !std::isfinite(*error)) error.reset();
    const double factor = units == "%" ? 100 : 1;
    if (error) *error *= factor;
    figures_.push_back({key, label, units, *value * factor, error, about_figure(key), big});
  }

  const Summary& s_;
  std::vector<Headline> figures_;
};

void add_laboratory(List& list, const Summary& s) {
  if (!s.laboratory) return;
  const LaboratoryFigures& l = *s.laboratory;
  list.add("laboratory.strength", "Strength", "Pa", l.strength, true);
  list.add("laboratory.modulus", "Modulus", "Pa", l.modulus, true);
  list.add("laboratory.failure_force", "Failure force", "N", l.failure_force, true);
  list.add("laboratory.failure_displacement", "Displacement at failure", "m", l.failure_displacement, true);
  list.add("laboratory.stiffness", "Stiffness", "N/m", l.stiffness, true);
  list.add("laboratory.first_break_force", "Force at the first broken bond", "N", l.first_break_force);
}

void add_machine(List& list, const Summary& s) {
  const auto steady = [&](auto member) -> std::optional<Estimate> {
    return s.steady ? std::optional<Estimate>((*s.steady).*member) : std::nullopt;
  };
  using S = SteadyFigures;
  list.add("mean_crushing_power", "crushing_power", "Crushing power", "W", steady(&S::crushing_power),
           s.mean_crushing_power, true);
  list.add("throughput_tph", "throughput_tph", "Throughput", "t/h", steady(&S::throughput_tph), s.throughput_tph, true);
  list.add("p80", "p80", "Product P80", "m", steady(&S::p80), s.p80, true);
  list.add("specific_energy_kwh_per_t", "specific_energy_kwh_per_t", "Specific energy", "kWh/t",
           steady(&S::specific_energy_kwh_per_t), s.specific_energy_kwh_per_t, true);
  if (s.motor) {
    list.add("motor.mean_fraction", "Share of rated motor power", "%", s.motor->mean_fraction, true);
    list.add("motor.mean", "Motor power, mean", "W", s.motor->mean, !s.motor->mean_fraction);
    list.add("motor.p95", "Motor power, 95 % of the time below", "W", s.motor->p95);
    list.add("motor.peak", "Motor power, peak", "W", s.motor->peak);
    list.add("motor.rated_power", "Rated motor power", "W", s.motor->rated_power);
  }
}

void add_product(List& list, const Summary& s) {
  const auto steady = [&](auto member) { return s.steady ? (*s.steady).*member : std::optional<Estimate>(); };
  using S = SteadyFigures;
  list.add("p50", "p50", "Product P50", "m", steady(&S::p50), s.p50, false);
  list.add("product_below_css", "product_below_css", "Product below the closed side setting", "%",
           steady(&S::product_below_css), s.product_below_css, false);
  list.add("product_below_oss", "product_below_oss", "Product below the open side setting", "%",
           steady(&S::product_below_oss), s.product_below_oss, false);
  list.add("singles_share", "Single particles in the product", "%", s.singles_share);
  list.add("resolution", "Resolution: coarsest particle", "m", s.resolution);
  if (s.fines) {
    list.add("fines.p80", "p80_with_fines", "Product P80 with estimated fines", "m", steady(&S::p80_with_fines),
             s.fines->p80, false);
    list.add("fines.share", "Estimated fines in the product", "%", s.fines->share);
  }
  list.add("feed_mass", "Mass fed", "kg", s.feed_mass);
  list.add("discharged_mass", "Mass discharged", "kg", s.discharged_mass);
  list.add("holdup_mass", "Mass in the chamber at the end", "kg", s.holdup_mass);
  list.add("escaped_mass", "Mass that left over the rim", "kg", s.escaped_mass);
  if (s.steady) list.add("steady.residence_time", "Residence time", "s", s.steady->residence_time);
}

void add_run(List& list, const Summary& s) {
  if (s.bonds_initial && *s.bonds_initial > 0 && s.bonds_broken)
    list.add("bonds_broken", "Broken bonds", "%",
             static_cast<double>(*s.bonds_broken) / static_cast<double>(*s.bonds_initial),
             !s.mean_crushing_power && !s.laboratory);
  list.add("energy_residual_fraction", "Energy residual", "%", s.energy_residual_fraction, true);
  list.add("max_overlap_ratio", "Largest overlap / radius", "%", s.max_overlap_ratio);
  list.add("simulated_seconds", "Simulated time", "s", s.simulated_seconds, !s.mean_crushing_power && !s.laboratory);
  list.add("wall_seconds", "Wall-clock time", "s", s.wall_seconds);
}

}  // namespace

std::vector<Headline> headlines(const Summary& summary) {
  List list(summary);
  add_laboratory(list, summary);
  add_machine(list, summary);
  add_product(list, summary);
  add_run(list, summary);
  return list.take();
}

std::string text_of(const Headline& figure) {
  const Unit unit = shown_unit(figure.units, figure.value);
  const std::string number_text = figure.error
                                      ? number_with_error(figure.value * unit.factor, *figure.error * unit.factor)
                                      : number(figure.value * unit.factor);
  return number_text + (unit.name.empty() ? "" : "\u00a0" + unit.name);
}

std::string about_figure(const std::string& name) {
  static const std::vector<SummaryMember> members = summary_members();
  const auto found = std::ranges::find(members, name, &SummaryMember::name);
  return found == members.end() ? "" : found->description;
}

}  // namespace gyro::report

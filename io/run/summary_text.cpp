// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/progress.hpp"
#include "io/run/summary.hpp"

#include <cstdarg>
#include <cstdio>

namespace gyro {
namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  char text[256];
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text, sizeof text, pattern, values);
  va_end(values);
  return text;
}

/// "  name                value".
std::string line(const char* name, const std::string& value) {
  return format("  %-18s", name) + value + "\n";
}

std::string product_lines(const Summary& s) {
  std::string text;
  if (s.feed_mass) text += line("fed", format("%.4g t", *s.feed_mass / 1e3));
  if (s.feed_waiting && *s.feed_waiting > 0)
    text += line("waiting", format("%.4g t, which found no room", *s.feed_waiting / 1e3));
  if (s.discharged_mass) text += line("discharged", format("%.4g t", *s.discharged_mass / 1e3));
  if (s.throughput_tph) text += line("throughput", format("%.4g t/h", *s.throughput_tph));
  if (s.p80) text += line("product P80", format("%.4g mm", *s.p80 * 1e3));
  if (s.product_below_oss && s.product_below_css)
    text += line(
        "", format("%.3g %% below OSS, %.3g %% below CSS", 100 * *s.product_below_oss, 100 * *s.product_below_css));
  if (s.singles_share && s.swell_of_crumbled)
    text += line("single particles", format("%.3g %% of the product; crumbled rock swells %.2f-fold, real rock 1.7",
                                            100 * *s.singles_share, *s.swell_of_crumbled));
  if (s.mean_crushing_power) text += line("crushing power", format("%.4g kW, mean", *s.mean_crushing_power / 1e3));
  if (s.specific_energy_kwh_per_t) text += line("specific energy", format("%.4g kWh/t", *s.specific_energy_kwh_per_t));
  if (s.steady)
    text += line("steady", format("from %.4g s: %.4g kW, %.4g t/h", s.steady->from, s.steady->crushing_power / 1e3,
                                  s.steady->throughput_tph));
  if (s.choked && *s.choked) text += line("feed", "choked: more rock waits than one gyration feeds");
  constexpr std::size_t max_lines = 6;
  for (std::size_t k = 0; k < s.drive_events.size() && k < max_lines; ++k)
    text += line("drive", s.drive_events[k].what + format(" at %.6g s", s.drive_events[k].time));
  if (s.drive_events.size() > max_lines) text += line("drive", "... and more, see summary.json");
  return text;
}

std::string laboratory_lines(const LaboratoryFigures& l) {
  std::string text = line("test", l.test + format(", %.4g mm between the platens at first contact", l.size * 1e3));
  if (l.broken_before > 0) text += line("before the test", std::to_string(l.broken_before) + " bonds broke");
  if (l.first_break_force) text += line("first bond broke", format("at %.4g N", *l.first_break_force));
  if (l.middle_breaks)
    text += line("first breaks", format("%.0f %% of them in the middle third", 100 * *l.middle_breaks));
  if (!l.failure_force || !l.failure_displacement) return text + line("failure", "none until the end");
  text += line("failure", format("at %.4g N, %.3g mm", *l.failure_force, *l.failure_displacement * 1e3));
  if (l.strength) text += line("strength", format("%.4g MPa", *l.strength / 1e6));
  if (l.stiffness) text += line("stiffness", format("%.4g MN/m", *l.stiffness / 1e6));
  if (l.modulus) text += line("modulus", format("%.4g GPa", *l.modulus / 1e9));
  return text;
}

std::string balance_lines(const Summary& s) {
  std::string text;
  if (s.energy_residual_fraction)
    text += line("energy residual", format("%.2g of the work done", *s.energy_residual_fraction));
  if (s.momentum_residual_fraction)
    text += line("momentum residual", format("%.2g of the impulses", *s.momentum_residual_fraction));
  if (s.mass_residual_fraction) text += line("mass residual", format("%.2g", *s.mass_residual_fraction));
  if (s.max_overlap_ratio) text += line("largest overlap", format("%.2g", *s.max_overlap_ratio) + " of the radius");
  return text;
}

std::string speed(double count, double seconds, const char* of) {
  return seconds > 0 ? ", " + format_count(count / seconds) + " " + of + "/s" : std::string();
}

}  // namespace

std::string to_text(const Summary& s, const std::filesystem::path& directory) {
  std::string text = "\n" + (s.title.empty() ? std::string("Run") : s.title) + ": " + to_string(s.status);
  if (!s.reason.empty()) text += " (" + s.reason + ")";
  text += format(", %.6g s simulated in ", s.simulated_seconds) + format_duration(s.wall_seconds) + "\n";
  text += product_lines(s);
  if (s.laboratory) text += laboratory_lines(*s.laboratory);
  text += line("particles", std::to_string(s.particles) + " at the end" +
                                speed(static_cast<double>(s.particle_steps), s.wall_seconds, "particle-steps"));
  if (s.bonds_initial > 0) {
    const double share = 100.0 * static_cast<double>(s.bonds_broken) / static_cast<double>(s.bonds_initial);
    text += line("bonds", std::to_string(s.bonds_broken) + " of " + std::to_string(s.bonds_initial) +
                              format(" broken (%.3g %%)", share) +
                              speed(static_cast<double>(s.bond_steps), s.wall_seconds, "bond-steps"));
  }
  if (s.time_step_limit > 0)
    text += line("time step", format("%.4g us, limit %.4g us", s.time_step * 1e6, s.time_step_limit * 1e6));
  text += balance_lines(s);
  text +=
      line("ran on", s.device +
                         (s.threads > 0 ? ", " + std::to_string(s.threads) + (s.threads == 1 ? " thread" : " threads")
                                        : std::string()) +
                         (s.precision.empty() ? "" : ", " + s.precision + " precision"));
  return text + line("output", directory.string());
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/summary_lines.hpp"

#include "io/run/progress.hpp"

#include <cstdarg>
#include <cstdio>

namespace gyro {
namespace {

std::string speed(double count, double seconds, const char* of) {
  return seconds > 0 ? ", " + format_count(count / seconds) + " " + of + "/s" : std::string();
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

std::string waiting_line(const Summary& s) {
  if (!s.feed_waiting || !(*s.feed_waiting > 0)) return {};
  return line("waiting", format("%.4g t, which found no room", *s.feed_waiting / 1e3));
}

std::string escaped_line(const Summary& s) {
  if (!s.escaped_mass || !(*s.escaped_mass > 0)) return {};
  return line("escaped", format("%.4g kg over the rim, %.2g %% of the feed; not in the product", *s.escaped_mass,
                                100 * s.escaped_fraction.value_or(0)));
}

std::string below_settings_line(const Summary& s) {
  if (!s.product_below_oss || !s.product_below_css) return {};
  return line("",
              format("%.3g %% below OSS, %.3g %% below CSS", 100 * *s.product_below_oss, 100 * *s.product_below_css));
}

std::string single_particles_line(const Summary& s) {
  if (!s.singles_share || !s.swell_of_crumbled) return {};
  return line("single particles", format("%.3g %% of the product; crumbled rock swells %.2f-fold, real rock 1.7",
                                         100 * *s.singles_share, *s.swell_of_crumbled));
}

std::string steady_line(const Summary& s) {
  if (!s.steady) return {};
  return line("steady", format("from %.4g s: %.4g kW, %.4g t/h", s.steady->from, s.steady->crushing_power / 1e3,
                               s.steady->throughput_tph));
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
  return line("particles", std::to_string(s.particles) + " at the end" +
                               speed(static_cast<double>(s.particle_steps), s.wall_seconds, "particle-steps"));
}

std::string bonds_line(const Summary& s) {
  if (s.bonds_initial <= 0) return {};
  const double share = 100.0 * static_cast<double>(s.bonds_broken) / static_cast<double>(s.bonds_initial);
  return line("bonds", std::to_string(s.bonds_broken) + " of " + std::to_string(s.bonds_initial) +
                           format(" broken (%.3g %%)", share) +
                           speed(static_cast<double>(s.bond_steps), s.wall_seconds, "bond-steps"));
}

std::string time_step_line(const Summary& s) {
  if (!(s.time_step_limit > 0)) return {};
  return line("time step", format("%.4g us, limit %.4g us", s.time_step * 1e6, s.time_step_limit * 1e6));
}

std::string device_line(const Summary& s) {
  const std::string threads =
      s.threads > 0 ? ", " + std::to_string(s.threads) + (s.threads == 1 ? " thread" : " threads") : std::string();
  return line("ran on", s.device + threads + (s.precision.empty() ? "" : ", " + s.precision + " precision"));
}

std::string failure_line(const LaboratoryFigures& l) {
  if (!l.failure_force || !l.failure_displacement) return line("failure", "none until the end");
  return line("failure", format("at %.4g N, %.3g mm", *l.failure_force, *l.failure_displacement * 1e3));
}

}  // namespace gyro

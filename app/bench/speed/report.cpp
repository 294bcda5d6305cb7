// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/report.hpp"

#include <cstdio>
#include <fstream>

namespace gyro::bench {
namespace {

constexpr double printed_share = 0.005;  // of the smallest phase in the table

/// Quotients of a result's median.
struct Rates {
  double particles, bonds, contacts;  ///< steps per second
  double simulated;                   ///< seconds per hour
  double bytes;                       ///< per particle
  double slowest, fastest;            ///< particle-steps per second
};

Rates rates_of(const SpeedResult& r) {
  const SpeedMeasurement& m = r.median();
  const double seconds = r.seconds(m), steps = static_cast<double>(m.steps);
  return {.particles = r.particle_steps_per_second(m),
          .bonds = static_cast<double>(m.bond_steps) / seconds,
          .contacts = static_cast<double>(m.contacts) * steps / seconds,
          .simulated = 3600 * m.time_step * steps / seconds,
          .bytes = static_cast<double>(m.bytes) / static_cast<double>(m.particles),
          .slowest = r.particle_steps_per_second(r.runs.back()),
          .fastest = r.particle_steps_per_second(r.runs.front())};
}

/// Share of each phase of the time on the clock; `other` is what lies outside of all.
std::vector<std::pair<std::string, double>> shares_of(const SpeedMeasurement& m) {
  std::vector<std::pair<std::string, double>> shares;
  double other = 1;
  for (const auto& [name, seconds] : m.phases) {
    shares.emplace_back(name, seconds / m.wall_seconds);
    other -= shares.back().second;
  }
  shares.emplace_back("other", other);
  return shares;
}

}  // namespace

void print_speed_head() {
  std::printf("%s\n%-5s %7s %-6s %8s %15s %8s %8s %9s %8s %8s %9s\n", processor_name().c_str(), "", "", "", "M part.",
              "", "M bond", "M cont.", "simulated", "", "set-up", "bytes per");
  std::printf("%-5s %7s %-6s %8s %15s %8s %8s %9s %8s %8s %9s\n", "scene", "threads", "", "steps/s", "[from .. to]",
              "steps/s", "eval./s", "s/hour", "rebuilds", "s", "particle");
  std::fflush(stdout);
}

void print(const SpeedResult& r) {
  const SpeedMeasurement& m = r.median();
  const Rates rates = rates_of(r);
  char spread[40];
  std::snprintf(spread, sizeof spread, "[%.2f .. %.2f]", rates.slowest / 1e6, rates.fastest / 1e6);
  std::printf("%-5s %7d %-6s %8.3f %15s %8.2f %8.2f %9.3g %8lld %8.2f %9.0f\n", r.scene.c_str(), r.threads,
              to_string(r.precision).c_str(), rates.particles / 1e6, spread, rates.bonds / 1e6, rates.contacts / 1e6,
              rates.simulated, static_cast<long long>(m.rebuilds), m.setup_seconds, rates.bytes);
  std::string shares;
  for (const auto& [name, share] : shares_of(m)) {
    char text[80];
    std::snprintf(text, sizeof text, "%s%s %.0f %%", shares.empty() ? "" : ", ", name.c_str(), 100 * share);
    if (share >= printed_share) shares += text;
  }
  std::printf("      %s\n", shares.c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json to_json(const SpeedResult& r) {
  const SpeedMeasurement& m = r.median();
  const Rates rates = rates_of(r);
  nlohmann::ordered_json j{{"scene", r.scene},
                           {"threads", r.threads},
                           {"precision", to_string(r.precision)},
                           {"particles", m.particles},
                           {"bonds", m.bonds},
                           {"contacts", m.contacts},
                           {"steps", m.steps},
                           {"substeps", m.substeps},
                           {"time_step", m.time_step},
                           {"seconds", r.seconds(m)},
                           {"wall_seconds", m.wall_seconds},
                           {"cpu_seconds", m.cpu_seconds},
                           {"particle_steps_per_second", rates.particles},
                           {"spread", {rates.slowest, rates.fastest}},
                           {"repeat", r.runs.size()},
                           {"bond_steps_per_second", rates.bonds},
                           {"contact_evaluations_per_second", rates.contacts},
                           {"simulated_seconds_per_hour", rates.simulated},
                           {"rebuilds", m.rebuilds},
                           {"setup_seconds", m.setup_seconds},
                           {"bytes_per_particle", rates.bytes},
                           {"kinetic_energy", m.kinetic},
                           {"rotation_energy", m.rotation}};
  for (const auto& [name, share] : shares_of(m)) j["phases"][name] = share;
  return j;
}

std::string processor_name() {
  std::ifstream cpus("/proc/cpuinfo");
  for (std::string line; std::getline(cpus, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return {};
}

}  // namespace gyro::bench

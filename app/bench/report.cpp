// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/report.hpp"

#include <cmath>
#include <cstdio>

namespace gyro::bench {
namespace {

const char* name_of(Family family) {
  switch (family) {
    case Family::path:
      return "path";
    case Family::identity:
      return "identity";
    case Family::ensemble:
      return "ensemble";
    case Family::invariant:
      break;
  }
  return "invariant";
}

/// Whether an error is not significant: within two standard errors of zero, and not exactly zero.
bool within_noise(const PointMetric& m) {
  return m.metric.family == Family::ensemble && m.deviation.error > 0 && m.deviation.error <= 2 * m.deviation.error_se;
}

std::string cell(const PointMetric& m) {
  if (m.deviation.error == 0) return "0";
  char text[48];
  std::snprintf(text, sizeof text, "%.1e +- %.0e%s", m.deviation.error, m.deviation.error_se,
                within_noise(m) ? " ~" : "");
  return text;
}

/// The text as a JSON number if it is a number, otherwise as a string.
nlohmann::json value_of(const std::string& text) {
  const nlohmann::json number = nlohmann::json::parse(text, nullptr, false);
  return number.is_number() ? number : nlohmann::json(text);
}

}  // namespace

void print_head(const AccuracyScene& scene, const Reference& reference) {
  std::printf(
      "\n%s: %s, %d seeds; reference: double, step %.4g us, windows of 50 us, %.3g s per simulated second, git %s\n",
      scene.name.c_str(), scene.title.c_str(), reference.seeds, reference.time_step * 1e6,
      reference.cpu_per_simulated_second, reference.git.c_str());
  std::printf("%-15s %-7s %8s %9s", "knob", "value", "step/us", "s per s");
  for (const Metric& metric : scene.metrics) std::printf(" %21s", metric.name.c_str());
  std::printf("\n%-15s %-7s %8s %9s", "reference", "", "", "");
  for (const Metric& metric : scene.metrics) {
    if (metric.family == Family::identity) {
      std::printf(" %21s", "");
      continue;
    }
    std::printf(" %17.4g %3s", mean_of(reference.fine.at(metric.name)).value,
                metric.unit == "1" ? "" : metric.unit.c_str());
  }
  std::printf("\n%-15s %-7s %8s %9s", "noise", "", "", "");
  for (const Metric& metric : scene.metrics) {
    const auto& fine = reference.fine.at(metric.name);
    std::printf(" %21.1e", deviation(metric.family, {fine, fine, reference.coarse.at(metric.name)}).noise);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print(const Point& p) {
  std::printf("%-15s %-7s %8.4g %9.4g", p.setting.knob.c_str(), p.setting.value.c_str(), p.time_step * 1e6,
              p.seconds_per_simulated_second);
  for (const PointMetric& m : p.metrics) std::printf(" %21s", cell(m).c_str());
  if (p.stopped > 0) std::printf("  %d of %d stopped", p.stopped, p.seeds);
  if (!p.refused.empty()) std::printf("  not allowed in a case");
  std::printf("\n");
  std::fflush(stdout);
}

void add_json(const Point& p, nlohmann::json& points) {
  for (const PointMetric& m : p.metrics) {
    const Deviation& d = m.deviation;
    nlohmann::json j{{"scene", p.scene},
                     {"knob", p.setting.knob},
                     {"value", value_of(p.setting.value)},
                     {"seconds_per_simulated_second", p.seconds_per_simulated_second},
                     {"metric", m.metric.name},
                     {"error", d.error},
                     {"error_se", d.error_se},
                     {"noise", d.noise},
                     {"bias", d.bias},
                     {"family", name_of(m.metric.family)},
                     {"unit", m.metric.unit},
                     {"mean", d.mean},
                     {"reference", d.reference},
                     {"seeds", d.seeds},
                     {"time_step", p.time_step},
                     {"time_step_limit", p.time_step_limit},
                     {"against", p.setting.exact ? "default" : "reference"},
                     {"stopped", p.stopped},
                     {"accepted", p.refused.empty()}};
    if (p.stopped > 0) j["stop_reason"] = p.reason;
    if (!p.refused.empty()) j["refusal"] = p.refused;
    points.push_back(std::move(j));
  }
}

}  // namespace gyro::bench

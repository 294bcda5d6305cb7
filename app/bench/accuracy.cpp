// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/accuracy.hpp"

#include <algorithm>

namespace gyro::bench {
namespace {

constexpr int quick_seeds = 3;
constexpr int exact_seeds = 2;  // equal bits need no statistics

std::vector<double> first_of(std::vector<double> values, std::size_t count) {
  values.resize(count);
  return values;
}

/// Metrics that must not change are compared seed by seed, because means over seeds could hide a difference.
Family family_of(const Metric& metric, const KnobSetting& setting) {
  return setting.exact && metric.family != Family::identity ? Family::path : metric.family;
}

/// @param fine, coarse  reference values for the ensemble, by metric and seed
Point point_of(const Member& member, const Ensemble& ensemble, const Reference::Table& fine,
               const Reference::Table& coarse) {
  Point p;
  p.scene = member.scene->name;
  p.setting = member.setting;
  p.seeds = static_cast<int>(ensemble.members.size());
  p.seconds_per_simulated_second = ensemble.cpu_per_simulated_second();
  p.time_step = ensemble.members.front().time_step;
  p.time_step_limit = ensemble.members.front().time_step_limit;
  p.stopped = ensemble.stopped();
  p.reason = ensemble.first_reason();
  p.refused = refusal(member);
  for (const Metric& metric : member.scene->metrics) {
    const std::size_t count = ensemble.members.size();
    const std::vector<double> measured = ensemble.values(metric.name), at_fine = first_of(fine.at(metric.name), count),
                              at_coarse = first_of(coarse.at(metric.name), count);
    p.metrics.push_back({metric, deviation(family_of(metric, member.setting), {measured, at_fine, at_coarse})});
  }
  return p;
}

}  // namespace

void measure(const AccuracyScene& scene, const std::filesystem::path& folder, const Reference& reference,
             const Extent& extent, const std::function<void(const Point&)>& take) {
  const int seeds = extent.quick ? std::min(quick_seeds, reference.seeds) : reference.seeds;
  Reference::Table at_default;
  for (const KnobSetting& setting : settings_of(scene, extent.quick)) {
    const bool is_default = at_default.empty();  // it comes first
    const bool wanted = extent.knob.empty() || extent.knob == setting.knob;
    if (!wanted && !is_default) continue;
    const Member member{&scene, folder, setting, 1};
    const int own_seeds = setting.exact || !wanted ? std::min(exact_seeds, seeds) : seeds;
    const Ensemble ensemble = run_ensemble(member, own_seeds, extent.threads);
    if (is_default)
      for (const Metric& metric : scene.metrics) at_default[metric.name] = ensemble.values(metric.name);
    if (!wanted) continue;
    take(setting.exact ? point_of(member, ensemble, at_default, at_default)
                       : point_of(member, ensemble, reference.fine, reference.coarse));
  }
}

}  // namespace gyro::bench

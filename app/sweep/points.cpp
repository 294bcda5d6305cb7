// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/points.hpp"

#include <algorithm>

namespace gyro {

std::size_t count_points(const SweepFile& sweep, std::size_t limit) {
  std::size_t count = std::max<std::size_t>(1, sweep.seeds.size());
  for (const SweepAxis& axis : sweep.axes) {
    if (count > limit) break;
    count *= axis.size();
  }
  return std::min(count, limit + 1);
}

std::vector<SweepPoint> expand(const SweepFile& sweep) {
  std::vector<SweepPoint> points(1);
  for (const SweepAxis& axis : sweep.axes) {
    std::vector<SweepPoint> longer;
    for (const SweepPoint& point : points)
      for (const std::vector<SweepSetting>& row : axis) {
        longer.push_back(point);
        longer.back().varied.insert(longer.back().varied.end(), row.begin(), row.end());
      }
    points = std::move(longer);
  }
  if (sweep.seeds.empty()) return points;
  std::vector<SweepPoint> seeded;
  for (const SweepPoint& point : points)
    for (const SweepSeed& seed : sweep.seeds) {
      seeded.push_back(point);
      seeded.back().seed = seed;
    }
  return seeded;
}

std::vector<SweepSetting> settings_of(const SweepFile& sweep, const SweepPoint& point) {
  std::vector<SweepSetting> settings = sweep.set;
  settings.insert(settings.end(), point.varied.begin(), point.varied.end());
  if (point.seed)
    settings.push_back({"case.seed", std::to_string(point.seed->seed), point.seed->mark, point.seed->mark});
  return settings;
}

std::vector<std::string> overrides_of(const std::vector<SweepSetting>& settings) {
  std::vector<std::string> overrides;
  for (const SweepSetting& setting : settings) overrides.push_back(setting.key + "=" + setting.value);
  return overrides;
}

std::vector<std::string> varied_keys(const SweepFile& sweep) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : sweep.axes)
    if (!axis.empty())
      for (const SweepSetting& setting : axis.front()) keys.push_back(setting.key);
  return keys;
}

}  // namespace gyro

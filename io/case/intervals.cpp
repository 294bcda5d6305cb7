// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/parts.hpp"

#include <algorithm>

namespace gyro {
namespace {

constexpr double rounding = 1e-9;
constexpr const char* by_windows[] = {"output.series", "output.snapshots", "output.liners.interval"};

std::string in_seconds(double time) {
  return number_text(time) + " s";
}

/// A checkpoint is made after a window and takes the disk some milliseconds.
void check_checkpoints(const Setting& root, CaseProblems& log) {
  constexpr double shortest = 1e-3;
  const Setting* wanted = root.find("output.checkpoints");
  if (wanted == nullptr || wanted->numbers[0] == 0 || wanted->numbers[0] >= shortest) return;
  log.add(wanted->mark, "output.checkpoints = " + in_seconds(wanted->numbers[0]) +
                            " is shorter than it takes to write one; give 1 ms or more, or 0 for one at the end only");
}

}  // namespace

void complete_intervals(Setting& root) {
  const Setting* window = root.find("coupling.interval");
  if (window == nullptr) return;
  for (Setting& section : root.children) {
    if (section.name != "output") continue;
    for (Setting& interval : section.children)
      if ((interval.name == "series" || interval.name == "snapshots") && !interval.given && interval.numbers[0] > 0)
        interval.numbers[0] = std::max(interval.numbers[0], window->numbers[0]);
  }
}

void check_intervals(const Setting& root, CaseProblems& log) {
  check_checkpoints(root, log);
  const Setting* window = root.find("coupling.interval");
  if (window == nullptr) return;
  const double shortest = window->numbers[0] * (1 - rounding);
  for (const char* key : by_windows) {
    const Setting* interval = root.find(key);
    if (interval == nullptr || interval->numbers[0] == 0 || interval->numbers[0] >= shortest) continue;
    const bool may_be_zero = std::string_view(key) == "output.snapshots";
    log.add(interval->mark, std::string(key) + " = " + in_seconds(interval->numbers[0]) +
                                " is shorter than coupling.interval, at whose ends a run writes; give at least " +
                                in_seconds(window->numbers[0]) + (may_be_zero ? ", 0 for none," : "") +
                                " or shorten coupling.interval");
  }
}

}  // namespace gyro

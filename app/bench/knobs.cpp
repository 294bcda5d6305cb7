// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/knobs.hpp"

#include <cstdio>

namespace gyro::bench {
namespace {

constexpr double default_safety = 0.7;  // time.safety

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

std::string safety(double share) {
  return "time.safety=" + text_of(share);
}

const std::string one_rate = "numerics.hold=off";  // bonds and contacts take the same steps

/// One rate.
KnobSetting step(double share) {
  return {.knob = "step", .value = text_of(share), .overrides = {safety(share), one_rate}};
}

KnobSetting step_in_double(double share) {
  return {.knob = "step_double",
          .value = text_of(share),
          .overrides = {safety(share), one_rate, "numerics.precision=double"}};
}

KnobSetting substeps(int k) {
  return {.knob = "substeps", .value = std::to_string(k), .overrides = {one_rate}, .hold = k};
}

/// Contacts at the default step, bonds with k sub-steps in it.
KnobSetting substeps_within(int k) {
  return {.knob = "substeps_within",
          .value = std::to_string(k),
          .overrides = {safety(default_safety / k), one_rate},
          .hold = k};
}

/// Contacts at this share of their undamped limit, each rock with the sub-steps that its bonds need.
KnobSetting hold(double share) {
  KnobSetting setting{.knob = "hold", .value = text_of(share), .overrides = {}};
  setting.hold_share = share;
  return setting;
}

KnobSetting window(double milliseconds) {
  return {.knob = "window",
          .value = text_of(milliseconds * 1e-3),
          .overrides = {"coupling.interval=" + text_of(milliseconds * 1e-3), "output=null"}};
}

/// Rocks and pieces as rigid bodies until the static stress of a bond passes this share of its strength.
KnobSetting rigid(double bonded_above) {
  return {.knob = "rigid",
          .value = text_of(bonded_above),
          .overrides = {"numerics.levels={rigid: pieces, bonded_above: " + text_of(bonded_above) + "}"}};
}

KnobSetting margin(double share) {
  return {.knob = "margin", .value = text_of(share), .overrides = {}, .margin = share, .exact = true};
}

KnobSetting reference(double divisor) {
  return {.knob = "reference",
          .value = text_of(default_safety / divisor),
          .overrides = {safety(default_safety / divisor), one_rate, "numerics.precision=double",
                        "coupling.interval=50e-6"}};
}

}  // namespace

std::vector<std::string> as_overrides(const KnobSetting& setting) {
  std::vector<std::string> all = setting.overrides;
  if (setting.hold > 1) all.push_back("numerics.substeps=" + std::to_string(setting.hold));
  return all;
}

KnobSetting default_setting() {
  return {.knob = "hold", .value = "0.5", .overrides = {}};
}

std::vector<KnobSetting> settings_of(const AccuracyScene& scene, bool quick) {
  if (quick)
    return {default_setting(), hold(0.25), step(default_safety), step(default_safety / 2), substeps(2), margin(0.2)};
  std::vector<KnobSetting> all{default_setting()};
  for (const double share : {0.125, 0.25, 0.7, 0.9}) all.push_back(hold(share));
  for (const double share : {0.9, default_safety, 0.35, 0.175}) all.push_back(step(share));
  all.push_back({.knob = "precision", .value = "double", .overrides = {"numerics.precision=double"}});
  for (const int k : {2, 4, 8}) all.push_back(substeps(k));
  if (scene.name == "platen") {
    for (const double share : {0.35, 0.175}) all.push_back(step_in_double(share));
    for (const int k : {2, 4}) all.push_back(substeps_within(k));
  }
  if (scene.tool.empty())
    for (const double milliseconds : {0.125, 0.25, 1.0, 2.0}) all.push_back(window(milliseconds));
  for (const double share : {0.3, 0.5, 0.7}) all.push_back(rigid(share));
  for (const double share : {0.2, 2.0}) all.push_back(margin(share));
  return all;
}

KnobSetting reference_setting() {
  return reference(16);
}

KnobSetting coarse_reference_setting() {
  KnobSetting setting = reference(8);
  setting.to_first_break = true;
  return setting;
}

}  // namespace gyro::bench

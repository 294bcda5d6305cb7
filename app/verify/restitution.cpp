// SPDX-License-Identifier: GPL-3.0-or-later
// Damped normal impacts: test 3 of Chung & Ooi, Granular Matter 13 (2011) 643.
#include "app/verify/check.hpp"
#include "app/verify/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gyro::verify {
namespace {

const std::string source = "asked for; damping by restitution_of_damping() in core/laws/restitution.hpp";

std::string percent(double e) {
  char text[16];
  std::snprintf(text, sizeof text, "e-%03.0f", 100 * e);
  return text;
}

const double asked[] = {0.05, 0.1, 0.2, 0.25, 0.3, 0.5, 0.7, 0.9, 1};

double rebound(const Material& material, double e, double speed, double steps_per_contact, Loads loads) {
  WallImpact impact{material, {0, e, 0}, 0.0025, {0, 0, -speed}};
  impact.steps_per_contact = steps_per_contact;
  return hit_wall(impact, loads).velocity.z / speed;
}

/// Rebound at all restitutions, and whether it is the same at three speeds.
void series(Recorder& out, const Material& material) {
  for (const double e : asked) {
    const double slow = rebound(material, e, 0.1, 1000, out.loads());
    const double middle = rebound(material, e, 3.9, 1000, out.loads());
    const double fast = rebound(material, e, 10, 1000, out.loads());
    out.absolute(percent(e), middle, e, {2e-4, 3e-4}, source);
    out.absolute(percent(e) + "-at-all-speeds", std::max({slow, middle, fast}) - std::min({slow, middle, fast}), 0,
                 {1e-6, 1e-4}, "the law has no scale of speed");
  }
}

/// At fifty steps a contact, and that the error goes with the step.
void coarse(Recorder& out) {
  const Material material = elastic(380e9, 0.23, 4000);
  const auto worst = [&](double steps) {
    double error = 0;
    for (const double e : asked) error = std::max(error, std::abs(rebound(material, e, 3.9, steps, out.loads()) - e));
    return error;
  };
  const double at_50 = worst(50);
  out.absolute("largest-error-at-50-steps", at_50, 0, {5e-3, 5e-3}, source);
  out.within("error-by-a-tenth-of-the-step", worst(500) / at_50, 0, 0.2, "first order where the force is cut at zero");
}

const std::array<Case, 3> cases{{
    {"restitution/aluminium-oxide", [](Recorder& out) { series(out, elastic(380e9, 0.23, 4000)); }},
    {"restitution/cast-iron", [](Recorder& out) { series(out, elastic(100e9, 0.25, 7000)); }},
    {"restitution/coarse-step", coarse},
}};

}  // namespace

std::span<const Case> restitution_cases() {
  return cases;
}

}  // namespace gyro::verify

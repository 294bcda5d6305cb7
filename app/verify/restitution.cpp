// SPDX-License-Identifier: GPL-3.0-or-later
// Damped normal impacts: test 3 of Chung & Ooi, Granular Matter 13 (2011) 643.
#include "app/verify/check.hpp"
#include "app/verify/impact.hpp"

#include <array>
#include <cstdio>

namespace gyro::verify {
namespace {

const std::string source = "asked for; damping by restitution_of_damping() in core/laws/restitution.hpp";

std::string percent(double e) {
  char text[16];
  std::snprintf(text, sizeof text, "e-%03.0f", 100 * e);
  return text;
}

/// Rebound at all restitutions. The speed changes from one to the next: the result must not.
void series(Recorder& out, const Material& material) {
  const double asked[] = {0.05, 0.1, 0.2, 0.25, 0.3, 0.5, 0.7, 0.9, 1};
  const double speeds[] = {0.1, 3.9, 10};
  for (int k = 0; k < 9; ++k) {
    const double speed = speeds[k % 3];
    const ImpactResult got = hit_wall({material, {0, asked[k], 0}, 0.0025, {0, 0, -speed}}, out.loads());
    out.absolute(percent(asked[k]), got.velocity.z / speed, asked[k], {2e-4, 3e-4}, source);
  }
}

const std::array<Case, 2> cases{{
    {"restitution/aluminium-oxide", [](Recorder& out) { series(out, elastic(380e9, 0.23, 4000)); }},
    {"restitution/cast-iron", [](Recorder& out) { series(out, elastic(100e9, 0.25, 7000)); }},
}};

}  // namespace

std::span<const Case> restitution_cases() {
  return cases;
}

}  // namespace gyro::verify

// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic normal impacts: tests 1 and 2 of Chung & Ooi, Granular Matter 13 (2011) 643.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/verification.hpp"

#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

using namespace fixtures;

const std::string source = "Chung & Ooi (2011); Johnson (1985), ch. 11";

void compare(Recorder& out, const ImpactResult& got, const ElasticImpact& theory, double rebound) {
  out.relative("force", got.force, theory.force, {1e-5, 1e-5}, source);
  out.relative("overlap", got.overlap, theory.overlap, {1e-5, 1e-5}, source);
  out.relative("duration", got.duration, theory.duration, {1e-5, 1e-5}, source);
  out.relative("rebound", rebound, 1, {1e-8, 1e-7}, source);
}

void two_spheres(Recorder& out, const Material& material) {
  const double radius = 0.01, speed = 10;
  const ImpactResult got = meet(material, {0, 1, 0}, radius, speed, 1000, out.precision());
  compare(out, got, head_on_impact(material, radius, speed), -got.velocity.x / speed);
}

/// Velocity Verlet is of second order: half the step gives a quarter of the error. In both runs the largest overlap is
/// reached at the end of a step.
void converges(Recorder& out) {
  const Material material = elastic(48e9, 0.20, 2800);
  const double radius = 0.01, speed = 10;
  const ElasticImpact theory = head_on_impact(material, radius, speed);
  const auto error = [&](double steps) {
    return meet(material, {0, 1, 0}, radius, speed, steps, out.precision()).overlap / theory.overlap - 1;
  };
  out.within("error-of-overlap-by-half-a-step", error(50) / error(100), 3.5, 4.5, "second order of velocity Verlet");
}

void on_wall(Recorder& out, const Material& material) {
  const double radius = 0.1, speed = 0.2;
  WallImpact impact{material, {0, 1, 0}, radius, {0, 0, -speed}};
  const ImpactResult plane = hit_wall(impact, out.precision());
  compare(out, plane, impact_on_wall(material, radius, speed), plane.velocity.z / speed);
  impact.mesh = true;
  const ImpactResult mesh = hit_wall(impact, out.precision());
  out.relative("force-on-triangle", mesh.force, plane.force, {1e-12, 1e-12}, "the same impact on a plane");
  out.relative("rebound-from-triangle", mesh.velocity.z, plane.velocity.z, {1e-12, 1e-12},
               "the same impact on a plane");
}

}  // namespace

std::vector<Verification> hertz_cases() {
  return {
      {"hertz/glass", [](Recorder& out) { two_spheres(out, elastic(48e9, 0.20, 2800)); }},
      {"hertz/limestone", [](Recorder& out) { two_spheres(out, elastic(20e9, 0.25, 2500)); }},
      {"hertz/convergence", converges},
      {"hertz/aluminium-on-wall", [](Recorder& out) { on_wall(out, elastic(70e9, 0.30, 2699)); }},
      {"hertz/magnesium-on-wall", [](Recorder& out) { on_wall(out, elastic(40e9, 0.35, 1800)); }},
  };
}

}  // namespace gyro::verify

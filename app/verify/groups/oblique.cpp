// SPDX-License-Identifier: GPL-3.0-or-later
// Oblique impacts: tests 4 and 5 of Chung & Ooi, Granular Matter 13 (2011) 643.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/verification.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

const std::string sliding = "momentum: friction mu (1 + e) m v_n at the mean lever";
const std::string sticking = "impact_reference.py: independent integration of the same law";

std::string numbered(const char* form, double number) {
  char text[32];
  std::snprintf(text, sizeof text, form, number);
  return text;
}

ObliqueImpact test_4(const Material& material, double degrees) {
  const double angle = degrees * pi / 180;
  return {material, {0.092, 0.98, 0}, 0.0025, 3.9 * std::sin(angle), 3.9 * std::cos(angle)};
}

struct Row {
  double degrees, ratio, angular_velocity;  ///< angle of impact; tangential restitution; after the impact [rad/s]
};

/// Up to 25 degrees the contact sticks for part of the impact.
void sticks(Recorder& out, const Material& material, std::span<const Row> rows) {
  for (const Row& row : rows) {
    const ObliqueImpact impact = test_4(material, row.degrees);
    const ObliqueResult got = hit_obliquely(impact, out.precision());
    const std::string name = numbered("%02.0f-degrees", row.degrees);
    out.relative(name + "-velocity", got.slide / impact.slide, row.ratio, {1e-3, 1e-3}, sticking);
    out.relative(name + "-spin", got.angular_velocity, row.angular_velocity, {3e-3, 3e-3}, sticking);
    out.absolute(name + "-across", got.across / impact.slide, 0, {1e-12, 1e-6}, "symmetry");
  }
}

/// From 30 degrees on the contact slides throughout the impact.
void slides(Recorder& out, const Material& material) {
  const double e = 0.98, mu = 0.092;
  for (const double degrees : {45.0, 60.0, 80.0}) {
    const ObliqueImpact impact = test_4(material, degrees);
    const ObliqueResult got = hit_obliquely(impact, out.precision());
    const std::string name = numbered("%02.0f-degrees", degrees);
    const double lost = mu * (1 + e) * impact.fall;
    out.relative(name + "-velocity", got.slide / impact.slide, 1 - lost / impact.slide, {1e-4, 1e-4}, sliding);
    out.relative(name + "-spin", got.angular_velocity, 2.5 * lost / impact.radius * mean_lever(impact), {1e-4, 1e-4},
                 sliding);
    out.relative(name + "-rebound", got.rebound / impact.fall, e, {1e-4, 1e-4}, "prescribed restitution");
  }
}

/// Comparison with published simulations, whose law unloads differently; therefore only the mean deviation at five
/// angles is checked.
void published(Recorder& out) {
  const Row rows[] = {{10, 0.687, 0}, {15, 0.624, 0}, {20, 0.616, 0}, {25, 0.634, 0}, {30, 0.684, 0}};
  double error = 0;
  for (const Row& row : rows) {
    const ObliqueImpact impact = test_4(elastic(380e9, 0.23, 4000), row.degrees);
    error += std::abs(hit_obliquely(impact, out.precision()).slide / impact.slide / row.ratio - 1) / 5;
  }
  out.absolute("mean-deviation-of-velocity", error, 0, {0.025, 0.025},
               "Chung & Ooi (2011), fig. of test 4, digitised in Kratos, which accepts 0.025");
}

/// Test 5: velocity lost, surface speed by spin and velocity of the contact patch after the impact, all divided by mu
/// v_n; psi is the velocity of the patch before the impact, also divided by mu v_n.
void small_and_sliding(Recorder& out, const Material& material) {
  const double mu = 0.3, fall = 5;
  for (const double psi : {7.5, 10.0}) {
    const ObliqueImpact impact{material, {mu, 1, 0}, 10e-6, psi * mu * fall, fall};
    const ObliqueResult got = hit_obliquely(impact, out.precision());
    const std::string name = numbered("psi-%02.0f", 10 * psi);
    const double lever = mean_lever(impact), angular_velocity = got.angular_velocity * impact.radius / (mu * fall);
    out.relative(name + "-velocity", (impact.slide - got.slide) / (mu * fall), 2, {1e-4, 1e-4}, sliding);
    out.relative(name + "-spin", angular_velocity, 5 * lever, {1e-4, 1e-4}, sliding);
    out.relative(name + "-patch", got.slide / (mu * fall) - angular_velocity, psi - 2 - 5 * lever, {1e-3, 1e-3},
                 sliding);
  }
}

void small_and_sticking(Recorder& out) {
  const Row rows[] = {{0.332, 0.16511, 0.11895},  {1.009, 0.39611, 0.43696},  {2.0, -0.22760, 1.58836},
                      {2.991, -1.01988, 2.85998}, {4.006, -1.42641, 3.87385}, {4.997, -1.44600, 4.59487}};
  const double mu = 0.3, fall = 5;
  for (const auto& [psi, patch, angular_velocity] : rows) {
    const ObliqueImpact impact{elastic(208e9, 0.30, 7850), {mu, 1, 0}, 10e-6, psi * mu * fall, fall};
    const ObliqueResult got = hit_obliquely(impact, out.precision());
    const std::string name = numbered("psi-%02.0f", 10 * psi);
    const double surface = got.angular_velocity * impact.radius / (mu * fall);
    out.absolute(name + "-patch", got.slide / (mu * fall) - surface, patch, {5e-3, 5e-3}, sticking);
    out.absolute(name + "-spin", surface, angular_velocity, {5e-3, 5e-3}, sticking);
  }
}

constexpr Row oxide[] = {{5, 0.85558, 48.938},
                         {10, 0.71122, 194.995},
                         {15, 0.63232, 370.060},
                         {20, 0.62093, 504.257},
                         {25, 0.63881, 593.820}};
constexpr Row alloy[] = {{5, 0.81134, 63.798},
                         {10, 0.68707, 210.906},
                         {15, 0.61682, 384.948},
                         {20, 0.61172, 515.603},
                         {25, 0.63462, 599.745}};

}  // namespace

std::vector<Verification> oblique_cases() {
  return {
      {"oblique/oxide-sticking", [](Recorder& out) { sticks(out, elastic(380e9, 0.23, 4000), oxide); }},
      {"oblique/alloy-sticking", [](Recorder& out) { sticks(out, elastic(70e9, 0.33, 2700), alloy); }},
      {"oblique/oxide-sliding", [](Recorder& out) { slides(out, elastic(380e9, 0.23, 4000)); }},
      {"oblique/alloy-sliding", [](Recorder& out) { slides(out, elastic(70e9, 0.33, 2700)); }},
      {"oblique/oxide-published", published},
      {"oblique/steel-10-um-sliding", [](Recorder& out) { small_and_sliding(out, elastic(208e9, 0.30, 7850)); }},
      {"oblique/polyethylene-10-um-sliding", [](Recorder& out) { small_and_sliding(out, elastic(1e9, 0.40, 1400)); }},
      {"oblique/steel-10-um-sticking", small_and_sticking},
  };
}

}  // namespace gyro::verify

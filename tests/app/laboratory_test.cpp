// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/laboratory.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

using namespace gyro;

namespace {

using Test = CaseLaboratory::Test;

/// The platens touch the rock after 10 ms at 0.1 m/s; the force rises with the stiffness until the rock splits in two
/// and the force falls to 0.3 of it.
Compression test_of(Test test, double stiffness, double failure) {
  Compression c;
  c.test = test;
  c.gap = 0.061;
  c.closing_speed = 0.1;
  c.diameter = 0.05;
  c.length = 0.1;
  bool broken = false;
  for (int k = 1; k <= 600; ++k) {
    const double time = 1e-4 * k, pressed = std::max(0.0, 0.1 * (time - 0.01));
    if (!broken && stiffness * pressed > failure) {
      broken = true;
      c.breaks.push_back({time, 0});
    }
    c.time.push_back(time);
    c.force.push_back(stiffness * pressed * (broken ? 0.3 : 1));
    c.largest_fragment.push_back(broken ? 0.15 : 0.3);
  }
  return c;
}

}  // namespace

TEST_CASE("A linear force gives its stiffness, modulus and strength") {
  const Compression c = test_of(Test::uniaxial, 1e6, 2000);  // fails at 2 mm
  const LaboratoryReport report = evaluate(c);
  const LaboratoryFigures& f = report.figures;
  CHECK(f.test == "uniaxial");
  CHECK(f.size == Approx(0.06).margin(3e-5));  // found at 0.5 % of the failure force and by rows of 0.01 mm
  REQUIRE(f.failure_force);
  CHECK(*f.failure_force == Approx(2000).epsilon(0.006));
  CHECK(*f.failure_displacement == Approx(2e-3).margin(3e-5));
  CHECK(*f.stiffness == Approx(1e6).epsilon(1e-6));
  const double area = std::numbers::pi / 4 * 0.05 * 0.05;
  CHECK(*f.strength == Approx(*f.failure_force / area));
  CHECK(*f.modulus == Approx(1e6 * 0.1 / area));
  CHECK(report.curve.front().displacement == 0);
  CHECK(report.curve.back().displacement == Approx(0.1 * 0.05).margin(3e-5));
}

TEST_CASE("Waves on the curve hardly change the stiffness") {
  Compression c = test_of(Test::uniaxial, 1e6, 2000);
  for (std::size_t k = 100; k < 290; ++k) c.force[k] += 100 * std::sin(0.55 * static_cast<double>(k));
  CHECK(*evaluate(c).figures.stiffness == Approx(1e6).epsilon(0.035));  // 6 A/(pi n span); two points: 2 A/span = 0.25
}

TEST_CASE("The strength of a lump depends on the distance of the platens") {
  const LaboratoryFigures f = evaluate(test_of(Test::platen, 1e6, 2000)).figures;
  CHECK(*f.failure_force == Approx(2000).epsilon(0.006));
  CHECK(*f.strength == Approx(0.9 * *f.failure_force / (0.06 * 0.06)).epsilon(1e-3));
  CHECK_FALSE(f.modulus);
}

TEST_CASE("The force of the first break is read from the curve") {
  Compression c = test_of(Test::platen, 1e6, 2000);
  c.breaks = {{0.0199, 0}};  // 0.99 mm after contact
  CHECK(*evaluate(c).figures.first_break_force == Approx(990).epsilon(1e-3));
}

TEST_CASE("A bond that breaks before the moving platen presses does not count as the first break") {
  Compression c = test_of(Test::platen, 1e6, 2000);
  c.begin = 0.01;
  c.breaks = {{0.002, -0.5}, {0.004, -0.5}, {0.0199, 0}};  // the rock fell onto the lower platen
  const LaboratoryFigures f = evaluate(c).figures;
  CHECK(f.broken_before == 2);
  CHECK(*f.first_break_force == Approx(990).epsilon(1e-3));
  c.breaks.pop_back();
  CHECK_FALSE(evaluate(c).figures.first_break_force);
  CHECK_FALSE(evaluate(c).figures.failure_force);
}

TEST_CASE("A Brazilian disc gives 2 F/(pi D t), and the share of its first breaks in the middle third") {
  Compression c = test_of(Test::brazilian, 1e6, 2000);
  c.length = 0.025;
  for (int k = 0; k < 30; ++k) c.breaks.push_back({0.04, k < 5 ? 0.16 : -0.17});
  const LaboratoryFigures f = evaluate(c).figures;
  CHECK(f.test == "brazilian");
  CHECK(*f.strength == Approx(2 * *f.failure_force / (std::numbers::pi * 0.05 * 0.025)));
  CHECK(*f.middle_breaks == Approx(6.0 / 20));  // the first break of all is in the middle
  CHECK_FALSE(f.modulus);
  CHECK_FALSE(evaluate(test_of(Test::platen, 1e6, 2000)).figures.middle_breaks);
}

TEST_CASE("A cylinder fails at its largest force, if the force falls by 30 % from there after a break") {
  Compression c = test_of(Test::uniaxial, 1e6, 2000);
  for (std::size_t k = 150; k < 160; ++k) c.force[k] *= 0.2;  // the ends are crushed before they carry load
  c.breaks = {{0.015, 0}};
  CHECK(*evaluate(c).figures.failure_force == Approx(2000).epsilon(0.006));
  for (std::size_t k = 299; k < 600; ++k) c.force[k] = 1500;
  CHECK_FALSE(evaluate(c).figures.failure_force);  // it still carries 3/4
  for (std::size_t k = 550; k < 600; ++k) c.force[k] = 1300;
  CHECK(*evaluate(c).figures.failure_force == Approx(2000).epsilon(0.006));
  c.breaks.clear();
  CHECK_FALSE(evaluate(c).figures.failure_force);  // no bond has broken: it bounced
}

TEST_CASE("A rock pressed from two sides fails when it splits, whatever its force before") {
  Compression c = test_of(Test::platen, 1e6, 1e9);
  c.breaks = {{0.015, 0}};
  for (std::size_t k = 300; k < 310; ++k) c.force[k] *= 0.1;  // a corner breaks off
  for (std::size_t k = 300; k < 600; ++k) c.largest_fragment[k] = 0.27;
  CHECK_FALSE(evaluate(c).figures.failure_force);
  for (std::size_t k = 500; k < 600; ++k) c.largest_fragment[k] = 0.199, c.force[k] *= 1.5;  // wedged apart
  const LaboratoryFigures f = evaluate(c).figures;
  CHECK(*f.failure_force == Approx(1e6 * 0.1 * (0.0501 - 0.01) * 1.5));  // of the row in which it was split
  CHECK(f.size == Approx(0.06).margin(6e-5));                            // at first contact, not after the corner broke
}

TEST_CASE("Platens that never touch the rock give no figures") {
  Compression c = test_of(Test::platen, 0, 1);
  CHECK(evaluate(c).curve.empty());
  CHECK_FALSE(evaluate(c).figures.failure_force);
  c.time.clear(), c.force.clear(), c.largest_fragment.clear();
  CHECK(evaluate(c).curve.empty());
}

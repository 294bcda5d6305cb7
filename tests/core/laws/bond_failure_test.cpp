// SPDX-License-Identifier: GPL-3.0-or-later
// The failure criterion of Mohr and Coulomb: shear strength tau_c + tan(phi) sigma under a pressure sigma.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

#include "core/laws/bond/models.hpp"

#include <cmath>
#include <numbers>

using namespace gyro;
using namespace gyro::test;

namespace {

using Mohr = BondLaw<MohrCoulomb>;
using Constant = BondLaw<ConstantStrength>;

using std::numbers::pi;

constexpr double tan_30 = 0.57735026918962576;

template <class T>
BondConstants<T> law_with(double internal_friction) {
  BondConstants<double> law = paper_law();
  law.bond.internal_friction = internal_friction;
  return cast<T>(law);
}

/// Stretched, and sheared by an angle: ends without rotation.
BondStrain<double> strain_at(double stretch, double angle) {
  const double length = bond_length + stretch;
  Ends e;
  e.j = {length * std::cos(angle), 0.6 * length * std::sin(angle), 0.8 * length * std::sin(angle)};
  return strain_of(e);
}

/// Stretch that gives a mean axial stress [Pa], tension positive.
double stretch_of(double axial) {
  return axial / 1.67e12;
}

BondLoad<double> load_at(double internal_friction, const BondStrain<double>& strain, double factor = 1) {
  BondSection<double> section = paper_section();
  section.strength = factor;
  return Mohr::load(law_with<double>(internal_friction), section, strain, at_rest());
}

/// Strain at which the bond fails in shear under a mean axial stress [Pa], by bisection of the angle.
BondStrain<double> at_shear_failure(double axial, double factor) {
  double low = 0, high = 0.1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    const BondStrain<double> strain = strain_at(stretch_of(axial), middle);
    (load_at(tan_30, strain, factor).shear_ratio < 1 ? low : high) = middle;
  }
  return strain_at(stretch_of(axial), high);
}

template <class T>
BondStrain<T> in_precision(const BondStrain<double>& s) {
  return {cast<T>(s.normal),       static_cast<T>(s.length), static_cast<T>(s.stretch),
          static_cast<T>(s.along), cast<T>(s.shear),         static_cast<T>(s.twist),
          cast<T>(s.bend)};
}

template <class T>
bool same_bits(const BondLoad<T>& a, const BondLoad<T>& b) {
  return norm(a.force - b.force) == T(0) && norm(a.torque_i - b.torque_i) == T(0) &&
         norm(a.torque_j - b.torque_j) == T(0) && a.tension_ratio == b.tension_ratio &&
         a.shear_ratio == b.shear_ratio && a.elastic == b.elastic && a.damped == b.damped;
}

}  // namespace

TEST_CASE("A sheared bond under pressure fails at the load of Mohr and Coulomb", "[laws][bond]") {
  // 24 MPa + tan(30 deg) sigma on 78.5398 mm2; a factor of the bond scales the 24 MPa.
  const auto [axial, factor, force] =
      GENERATE(Catch::Generators::table<double, double, double>({{0, 1, 1884.9556},
                                                                 {-10e6, 1, 2338.4054},
                                                                 {-30e6, 1, 3245.3051},
                                                                 {-100e6, 1, 6419.4540},
                                                                 {-10e6, 0.5, 1395.9276}}));
  const BondStrain<double> strain = at_shear_failure(axial, factor);
  const BondLoad<double> load = load_at(tan_30, strain, factor);
  const double push = dot(load.force, strain.normal), shear = norm(tangential(load.force, strain.normal));
  CHECK(load.shear_ratio == Approx(1).epsilon(1e-9));
  CHECK(load.tension_ratio < 1);
  CHECK(shear == Approx(force).epsilon(1e-7));
  CHECK(push == Approx(-axial * pi * bond_radius * bond_radius).epsilon(1e-9).margin(1e-6));
}

TEST_CASE("Pressure also increases the twisting torque at failure", "[laws][bond]") {
  // tau = M Rb/J: 24 and 29.7735 MPa with Rb^3 pi/2 = 1.963495e-7 m3.
  const double axial = GENERATE(0.0, -10e6), torque = axial == 0 ? 4.712389 : 5.846013;
  Ends e;
  e.j.x += stretch_of(axial);
  const double angle = torque / twist_rate;
  e.orientation_j = rotation_about({1, 0, 0}, angle);
  CHECK(load_at(tan_30, strain_of(e)).shear_ratio == Approx(1).epsilon(2e-5));
}

TEST_CASE("Tension and bending do not change the shear strength, and friction does not change the tensile strength",
          "[laws][bond]") {
  const double axial = GENERATE(0.0, 1e6, 20e6);
  const BondStrain<double> pulled = strain_at(stretch_of(axial), 1e-3);
  CHECK(same_bits(load_at(tan_30, pulled), load_at(0, pulled)));

  Ends bent;
  bent.orientation_j = rotation_about({0, 1, 0}, 4e-3);
  bent.j.z -= 4e-3 * bond_length / 2;
  BondStrain<double> strain = strain_of(bent);
  strain.stretch = 0;
  CHECK(same_bits(load_at(tan_30, strain), load_at(0, strain)));

  strain.stretch = stretch_of(-10e6);
  CHECK(load_at(tan_30, strain).tension_ratio == load_at(0, strain).tension_ratio);
  CHECK(load_at(tan_30, strain).shear_ratio < load_at(0, strain).shear_ratio);
}

TEMPLATE_TEST_CASE("Without friction the criterion of Mohr and Coulomb has the bits of constant strength",
                   "[laws][bond]", float, double) {
  using T = TestType;
  const BondConstants<T> law = law_with<T>(0);
  const BondSection<double> s = paper_section(0.4);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const BondSection<T> section{
        T(s.radius), T(1 + 0.5 * random_number(k, 80)), T(s.sqrt_mass), T(s.sqrt_inertia), T(s.arm), T(s.length)};
    const BondStrain<T> strain = in_precision<T>(strain_of(strained(k, 3e-3), 0.4));
    const BondRates<T> rates{cast<T>(random_vector(k, 20)), cast<T>(random_vector(k, 23)),
                             cast<T>(random_vector(k, 26))};
    CHECK(same_bits(Mohr::load(law, section, strain, rates), Constant::load(law, section, strain, rates)));
  }
}

TEST_CASE("The list of bond laws gives the law of each model", "[laws][bond]") {
  struct Parts {
    BondSection<double> section;
    BondStrain<double> strain_r;
    BondRates<double> rates;
  };
  const Parts bond{paper_section(), strain_at(stretch_of(-10e6), 1e-3), at_rest()};
  const BondConstants<double> law = law_with<double>(tan_30);
  const auto load = [&](BondFailure failure, bool pressed) { return bond_load({failure}, law, bond, pressed); };
  CHECK(same_bits(load(BondFailure::constant, false), Constant::load(law, bond.section, bond.strain_r, bond.rates)));
  CHECK(same_bits(load(BondFailure::mohr_coulomb, false), Mohr::load(law, bond.section, bond.strain_r, bond.rates)));
  CHECK(same_bits(load(BondFailure::mohr_coulomb, true),
                  pressed_load(law, bond.section, bond.strain_r, bond.rates).load));
}

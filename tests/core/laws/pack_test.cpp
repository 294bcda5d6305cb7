// SPDX-License-Identifier: GPL-3.0-or-later
// Packs: the bond law on eight lanes gives the bits of the law on one.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

#include "core/kernels/bond_lane.hpp"
#include "core/math/pack.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

constexpr int lanes = 8;

template <class T>
struct Case {
  BondSection<T> section;
  BondStrain<double> strain;
  BondRates<T> rates;
};

template <class T>
BondStrain<T> narrowed(const BondStrain<double>& s) {
  return {cast<T>(s.normal),       static_cast<T>(s.length), static_cast<T>(s.stretch),
          static_cast<T>(s.along), cast<T>(s.shear),         static_cast<T>(s.twist),
          cast<T>(s.bend)};
}

/// A bond of some size, strain and motion; half of them pressed.
template <class T>
Case<T> some_bond(std::uint64_t k) {
  Ends ends = strained(k, 3e-3);
  if (k % 2) ends.j = ends.i + 0.999 * (ends.j - ends.i);
  const double arm = 0.5 + 0.3 * random_number(k, 80);
  const auto number = [&](std::uint32_t draw) { return static_cast<T>(1 + 0.5 * random_number(k, draw)); };
  return {{T(0.005) * number(81), number(82), T(0.1) * number(83), T(1e-3) * number(84), static_cast<T>(arm),
           static_cast<T>(bond_length)},
          strain_of(ends, arm),
          {cast<T>(random_vector(k, 20)), cast<T>(random_vector(k, 23)), cast<T>(random_vector(k, 26))}};
}

template <class T>
void put(Pack<T, lanes>& pack, int lane, T value) {
  pack.v[lane] = value;
}
template <class T>
void put(Vec3<Pack<T, lanes>>& pack, int lane, const Vec3<T>& value) {
  put(pack.x, lane, value.x);
  put(pack.y, lane, value.y);
  put(pack.z, lane, value.z);
}

template <class T>
bool same(const Vec3<Pack<T, lanes>>& pack, int lane, const Vec3<T>& v) {
  return pack.x[lane] == v.x && pack.y[lane] == v.y && pack.z[lane] == v.z;
}

template <class T>
bool same(const BondLoad<Pack<T, lanes>>& pack, int lane, const BondLoad<T>& one) {
  return same(pack.force, lane, one.force) && same(pack.torque_i, lane, one.torque_i) &&
         same(pack.torque_j, lane, one.torque_j) && pack.tension_ratio[lane] == one.tension_ratio &&
         pack.shear_ratio[lane] == one.shear_ratio && pack.elastic[lane] == one.elastic &&
         pack.damped[lane] == one.damped;
}

template <class T>
struct OfConstantStrength {
  using Number = T;
  using Law = BondLaw<ConstantStrength>;
};
template <class T>
struct OfMohrCoulomb {
  using Number = T;
  using Law = BondLaw<MohrCoulomb>;
};

}  // namespace

TEMPLATE_PRODUCT_TEST_CASE("A pack of bonds has the loads of single bonds, bit by bit", "[laws][pack]",
                           (OfConstantStrength, OfMohrCoulomb), (float, double)) {
  using T = typename TestType::Number;
  using Law = typename TestType::Law;
  using P = Pack<T, lanes>;
  const BondParametersOf<T> numbers{T(1.67e12), T(6.67e11), T(36e6), T(24e6), T(0.05), T(1e9), T(3e8), T(0.6)};
  const BondConstants<T> law{numbers, T(0.5), T(1e-6)};
  for (std::uint64_t first = 0; first < 80; first += lanes) {
    BondSection<P> section;
    BondStrain<P> strain;
    BondRates<P> rates;
    for (int k = 0; k < lanes; ++k) {
      const Case<T> c = some_bond<T>(first + static_cast<std::uint64_t>(k));
      const BondStrain<T> s = narrowed<T>(c.strain);
      put(section.radius, k, c.section.radius), put(section.strength, k, c.section.strength);
      put(section.sqrt_mass, k, c.section.sqrt_mass), put(section.sqrt_inertia, k, c.section.sqrt_inertia);
      put(section.arm, k, c.section.arm), put(section.length, k, c.section.length);
      put(strain.normal, k, s.normal), put(strain.length, k, s.length), put(strain.stretch, k, s.stretch);
      put(strain.along, k, s.along), put(strain.shear, k, s.shear), put(strain.twist, k, s.twist);
      put(strain.bend, k, s.bend);
      put(rates.velocity, k, c.rates.velocity), put(rates.angular_velocity_i, k, c.rates.angular_velocity_i);
      put(rates.angular_velocity_j, k, c.rates.angular_velocity_j);
    }
    const BondLoad<P> intact = Law::load(cast<P>(law), section, strain, rates);
    const PressedLoad<P> loose = Law::pressed(cast<P>(law), section, strain, rates);
    for (int k = 0; k < lanes; ++k) {
      const Case<T> c = some_bond<T>(first + static_cast<std::uint64_t>(k));
      const BondStrain<T> s = narrowed<T>(c.strain);
      CHECK(same(intact, k, Law::load(law, c.section, s, c.rates)));
      const PressedLoad<T> one = Law::pressed(law, c.section, s, c.rates);
      CHECK(same(loose.load, k, one.load));
      CHECK(loose.keep[k] == one.keep);
      CHECK(loose.slip_work[k] == one.slip_work);
    }
  }
}

TEST_CASE("A pack of strains has the bits of single strains", "[laws][pack]") {
  using P = Pack<double, lanes>;
  BondEnds<P> ends;
  BondShape<P> shape;
  for (int k = 0; k < lanes; ++k) {
    const BondEnds<double> one = strained(static_cast<std::uint64_t>(k), 3e-3).relative();
    put(ends.span, k, one.span);
    for (auto [pack, q] :
         {std::pair{&ends.orientation_i, one.orientation_i}, std::pair{&ends.orientation_j, one.orientation_j}})
      put(pack->w, k, q.w), put(pack->x, k, q.x), put(pack->y, k, q.y), put(pack->z, k, q.z);
    put(shape.axis, k, {1, 0, 0}), put(shape.length, k, bond_length), put(shape.arm, k, 0.3 + 0.05 * k);
  }
  const BondStrain<P> pack = bond_strain(shape, ends);
  for (int k = 0; k < lanes; ++k) {
    const BondStrain<double> one = strain_of(strained(static_cast<std::uint64_t>(k), 3e-3), 0.3 + 0.05 * k);
    CHECK(same(pack.normal, k, one.normal));
    CHECK(same(pack.shear, k, one.shear));
    CHECK(same(pack.bend, k, one.bend));
    CHECK(pack.length[k] == one.length);
    CHECK(pack.stretch[k] == one.stretch);
    CHECK(pack.along[k] == one.along);
    CHECK(pack.twist[k] == one.twist);
  }
}

TEMPLATE_TEST_CASE("Operators of a pack are those of its lanes", "[laws][pack]", float, double) {
  using T = TestType;
  using P = Pack<T, lanes>;
  P a, b;
  T x[lanes], y[lanes];
  for (int k = 0; k < lanes; ++k) {
    x[k] = static_cast<T>(random_number(1, static_cast<std::uint32_t>(k)));
    y[k] = k % 3 ? static_cast<T>(random_number(2, static_cast<std::uint32_t>(k))) : x[k];
    put(a, k, x[k]);
    put(b, k, y[k]);
  }
  for (int k = 0; k < lanes; ++k) {
    CHECK((a + b)[k] == x[k] + y[k]);
    CHECK((a - b)[k] == x[k] - y[k]);
    CHECK((a * b)[k] == x[k] * y[k]);
    CHECK((a / b)[k] == x[k] / y[k]);
    CHECK((-a)[k] == -x[k]);
    CHECK((a < b)[k] == (x[k] < y[k]));
    CHECK((a > b)[k] == (x[k] > y[k]));
    CHECK((a <= b)[k] == (x[k] <= y[k]));
    CHECK((a >= b)[k] == (x[k] >= y[k]));
    CHECK((~(a < b) & (a <= b))[k] == (x[k] == y[k]));
    CHECK(((a < b) | (a > b))[k] == (x[k] != y[k]));
    CHECK(sqrt(a * a)[k] == std::sqrt(x[k] * x[k]));
    CHECK(larger(a, b)[k] == std::max(x[k], y[k]));
    CHECK(smaller(a, b)[k] == std::min(x[k], y[k]));
    CHECK(positive(a)[k] == std::max(x[k], T(0)));
    CHECK(magnitude(a)[k] == std::abs(x[k]));
    CHECK(select(a < b, a, b)[k] == (x[k] < y[k] ? x[k] : y[k]));
    CHECK(P(T(3))[k] == T(3));
    CHECK(pack_cast<float>(a)[k] == static_cast<float>(x[k]));
  }
}

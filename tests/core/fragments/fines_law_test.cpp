// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fines_law.hpp"

#include "core/fragments/incomplete_beta.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

using namespace gyro;

namespace {

constexpr double kwh_per_t = 3600;                            // [J/kg]
const BreakageFines itabirite{.A = 0.645, .b = 10.5 / 3600};  // Minas-Rio, compact: 64.5 %, 10.5 t/kWh

double share(double t10, double n) {
  return tn_of(tn_family(t10), n);
}

}  // namespace

TEST_CASE("The incomplete beta function has its closed forms and recurrence", "[fines]") {
  for (const double x : {1e-9, 0.001, 0.1, 0.3, 0.5, 0.8, 0.999}) {
    CAPTURE(x);
    CHECK(incomplete_beta(x, 1, 1) == Approx(x).epsilon(1e-13));
    CHECK(incomplete_beta(x, 2.5, 1) == Approx(std::pow(x, 2.5)).epsilon(1e-13));
    CHECK(incomplete_beta(x, 1, 0.3) == Approx(-std::expm1(0.3 * std::log1p(-x))).epsilon(1e-12));
    CHECK(incomplete_beta(x, 2, 3) == Approx(x * x * (6 - 8 * x + 3 * x * x)).epsilon(1e-13));
    CHECK(incomplete_beta(x, 0.5, 0.5) == Approx(2 / std::numbers::pi * std::asin(std::sqrt(x))).epsilon(1e-13));
    for (const auto& [a, b] : {std::pair{0.51, 11.95}, {1.07, 13.87}, {1.08, 3.03}, {1.01, 0.53}, {1.03, 0.3}}) {
      // NIST DLMF 8.17.4 and 8.17.21
      if (x > 1e-6)  // else 1 - x has lost x
        CHECK(incomplete_beta(x, a, b) + incomplete_beta(1 - x, b, a) == Approx(1).epsilon(1e-12));
      const double step =
          std::exp(a * std::log(x) + b * std::log1p(-x) - std::lgamma(a) - std::lgamma(b) + std::lgamma(a + b)) / b;
      CHECK(incomplete_beta(x, a, b + 1) == Approx(incomplete_beta(x, a, b) + step).epsilon(1e-11));
    }
  }
  CHECK(incomplete_beta(0, 0.5, 2) == 0);
  CHECK(incomplete_beta(1, 0.5, 2) == 1);
}

TEST_CASE("t10 rises with A b from zero and ends at A", "[fines]") {
  CHECK(t10_of(itabirite, 0) == 0);
  CHECK(t10_of(itabirite, -5) == 0);
  CHECK(t10_of(itabirite, 1e-6) == Approx(itabirite.A * itabirite.b * 1e-6));
  CHECK(t10_of(itabirite, std::numbers::ln2 / itabirite.b) == Approx(itabirite.A / 2));
  CHECK(t10_of(itabirite, 1e9) == itabirite.A);
  CHECK(t10_of({itabirite.A, itabirite.b, 0.05}, 3) == Approx(t10_of(itabirite, 60)).epsilon(1e-14));
  CHECK(t10_of(itabirite, 0.1 * kwh_per_t) == Approx(0.645 * (1 - std::exp(-1.05))));  // 42 % at 0.1 kWh/t
}

TEST_CASE("The family of t_n contains t10 itself, and the published values of a t10 of 20 %", "[fines]") {
  CHECK(share(0.2, 10) == Approx(0.2).epsilon(1e-14));
  CHECK(share(0.2, 25) == Approx(0.11).margin(0.002));
  CHECK(share(0.2, 4) == Approx(0.4576).margin(1e-4));  // by numerical integration
  CHECK(share(0.2, 75) == Approx(0.0607).margin(1e-4));
  CHECK(share(0.5, 2) == Approx(0.9963).margin(1e-4));
  for (const double t10 : {0.0, 1e-12, 1e-7, 1e-5, 1e-3, 0.05, 0.4, 0.645, 1.0}) {
    CAPTURE(t10);
    double before = 1;
    for (double n = 1; n < 1000; n *= 1.07) {
      CAPTURE(n);
      const double now = share(t10, n);
      CHECK((now >= 0 && now <= before));
      before = now;
    }
    CHECK(share(t10, 10) == Approx(t10).epsilon(1e-4));
  }
}

TEST_CASE("Between its values the family is a power law, which goes on beyond n = 75", "[fines]") {
  const TnFamily family = tn_family(0.3);
  for (std::size_t k = 1; k < family.t.size(); ++k) {
    const double n0 = TnFamily::n_values[k - 1], n1 = TnFamily::n_values[k];
    CHECK(tn_of(family, n1) == Approx(family.t[k]).epsilon(1e-14));
    CHECK(tn_of(family, std::sqrt(n0 * n1)) == Approx(std::sqrt(family.t[k - 1] * family.t[k])).epsilon(1e-14));
  }
  CHECK(tn_of(family, 1) == family.t[0]);
  const double slope = std::log(family.t[6] / family.t[7]) / std::log(75.0 / 50);
  CHECK(tn_of(family, 750) == Approx(family.t[7] * std::pow(10, -slope)).epsilon(1e-13));
}

TEST_CASE("A fragment has the fines of its rock's size, and only those below its resolution", "[fines]") {
  const double energy = 0.05 * kwh_per_t, t10 = t10_of(itabirite, energy);
  const FragmentFines fines(itabirite, {.rock_size = 0.1, .resolution = 0.02, .energy = energy});
  REQUIRE(fines.any());
  CHECK(*fines.t10() == t10);
  CHECK(fines.finer_than(0.01) == Approx(t10).epsilon(1e-13));
  CHECK(fines.finer_than(0.004) == Approx(incomplete_beta(t10, 1.01, 0.53)).epsilon(1e-13));
  CHECK(fines.finer_than(0.02) == Approx(share(t10, 5)).epsilon(1e-13));
  CHECK(fines.finer_than(0.09) == fines.finer_than(0.02));
  // Nothing that has not broken has fines.
  CHECK_FALSE(FragmentFines(itabirite, {.rock_size = 0.1, .resolution = 0.02, .energy = 0}).any());
  CHECK_FALSE(FragmentFines(itabirite, {.rock_size = 0.02, .resolution = 0.02, .energy = energy}).any());
}

TEST_CASE("A tail of Gates, Gaudin and Schuhmann begins at the size of a particle that has broken off", "[fines]") {
  const SchuhmannFines law{.m = 0.8};
  const FragmentFines single(law, {.rock_size = 0.1, .resolution = 0.02, .energy = 5, .single = true});
  REQUIRE(single.any());
  CHECK_FALSE(single.t10());
  CHECK(single.finer_than(0.02) == 1);
  CHECK(single.finer_than(0.05) == 1);
  CHECK(single.finer_than(0.01) == Approx(std::pow(0.5, 0.8)).epsilon(1e-14));
  CHECK_FALSE(FragmentFines(law, {.rock_size = 0.1, .resolution = 0.02, .energy = 5, .single = false}).any());
  CHECK_FALSE(FragmentFines(law, {.rock_size = 0.02, .resolution = 0.02, .energy = 0, .single = true}).any());
}

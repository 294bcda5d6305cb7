// SPDX-License-Identifier: GPL-3.0-or-later
// The ceiling of the bond kernel: its count of operations, its sum of times, and its shape in `gyrosim bench speed`.
#include "app/bench/ceiling/ceiling.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::bench;

namespace {

/// Records expressions while it lives.
struct Recording {
  Expressions expressions;
  double memory[3] = {};
  Recording() { recorded = &expressions; }
  ~Recording() { recorded = nullptr; }
  Traced<double> input(int k) { return Traced<double>::of(expressions.input(memory + k, 0)); }
};

int total(const OperationCounts& n) {
  return n.add + n.multiply + n.divide + n.root;
}

}  // namespace

TEST_CASE("Operations of an expression that stands twice are counted once, and what no result needs is left out") {
  Recording r;
  const Traced<double> a = r.input(0), b = r.input(1), c = r.input(2);
  const Traced<double> product = a * b, same = b * a, unused = a / c;
  static_cast<void>(unused);
  const Traced<double> result = (product + c) * (c + same) - sqrt(a);
  r.expressions.need(result.expression);
  const OperationCounts n = r.expressions.counts(true);
  CHECK(n.multiply == 2);  // a b, and the square of the sum
  CHECK(n.add == 2);
  CHECK(n.root == 1);
  CHECK(n.divide == 0);
  CHECK(total(r.expressions.counts(false)) == 0);
}

TEST_CASE("Operations on constants, conversions and choices are not counted") {
  Recording r;
  const Traced<double> a = r.input(0), b = r.input(1);
  const Traced<double> twice = Traced<double>(0.3) * Traced<double>(2.0);
  const Traced<float> chosen = lane_cast<float>(select(a < b, a, -b)) * lane_cast<float>(twice);
  r.expressions.need(chosen.expression);
  CHECK(total(r.expressions.counts(true)) == 0);
  CHECK(r.expressions.counts(false).multiply == 1);
}

TEST_CASE("The operations of a bond are those of its text, in either precision") {
  const BondOperations mixed = bond_operations(Precision::mixed), both = bond_operations(Precision::double_);
  CHECK(total(both.in_single) == 0);
  // Divided by: |q|^2, L (double); L, L0 twice for the stiffnesses, the two strengths, N of the mean rotation.
  CHECK(mixed.in_double.divide + mixed.in_single.divide == both.in_double.divide);
  CHECK(mixed.in_double.root + mixed.in_single.root == both.in_double.root);
  CHECK(mixed.in_double.root == 1);     // L
  CHECK(both.in_double.root == 1 + 5);  // w; two of the dashpots; bending and shear of the stresses
  CHECK(mixed.in_double.multiply + mixed.in_single.multiply >= both.in_double.multiply);
  CHECK(both.in_double.multiply > 150);
  CHECK(both.in_double.add > 100);
}

TEST_CASE("The ceiling is the longer of sums and quotients, with pairs of an addition and a multiplication") {
  const UnitTimes times{{.add = 3, .multiply = 5, .pair = 6, .divide = 10, .root = 20},
                        {.add = 1, .multiply = 2, .pair = 2.5, .divide = 4, .root = 8}};
  const BondOperations n{.in_double = {.add = 2, .multiply = 5, .divide = 1, .root = 0},
                         .in_single = {.add = 4, .multiply = 1, .divide = 0, .root = 2}};
  const ArithmeticTime t = arithmetic_time(n, times);
  CHECK(t.sums == Approx(2 * 6 + 3 * 5 + 1 * 2.5 + 3 * 1));
  CHECK(t.quotients == Approx(10 + 2 * 8));
  CHECK(t.least() == Approx(t.sums));
}

TEST_CASE("No bond is faster than its ceiling, and all passes do their work") {
  const std::vector<Precision> both{Precision::mixed, Precision::double_};
  for (const BondCeiling& c : measure_bond_ceiling(both, 5)) {
    CAPTURE(c.ceiling().least(), c.measured, c.one_by_one);
    CHECK(c.ceiling().least() > 0);
    CHECK(c.ratio() > 1);
  }
}

TEST_CASE("bench speed gives the ceiling of bonds alone where it is asked for") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("bench speed --ceiling --precision double --json");
  REQUIRE(outcome.code == 0);
  const nlohmann::json j = nlohmann::json::parse(outcome.out);
  CHECK(j.at("scenes").empty());
  REQUIRE(j.at("bond_ceiling").size() == 1);
  const nlohmann::json& bond = j.at("bond_ceiling").at(0);
  CHECK(bond.at("precision") == "double");
  CHECK(bond.at("ratio").get<double>() ==
        Approx(bond.at("ns_per_bond").get<double>() / bond.at("ceiling_ns_per_bond").get<double>()));
  CHECK(bond.at("operations").at("double").at("multiply") > 100);
  CHECK(bond.at("operations_per_ns").at("double").at("add") > 0);
  CHECK(place.gyrosim("bench speed --ceiling --precision double").out.find("ceiling [ns]") != std::string::npos);
}

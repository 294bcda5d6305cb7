// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/size_distribution.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;

TEST_CASE("A passing table is linear between its sieves") {
  const SizeDistribution sizes(PassingTable{{{0.05, 0}, {0.1, 0.2}, {0.2, 0.2}, {0.5, 1}}});
  CHECK(sizes.passing(0.01) == 0);
  CHECK(sizes.passing(0.075) == Approx(0.1));
  CHECK(sizes.passing(0.15) == Approx(0.2));
  CHECK(sizes.passing(0.6) == 1);
  CHECK(sizes.size_at(0.1) == Approx(0.075));
  CHECK(sizes.size_at(0.2) == Approx(0.1));  // the smallest size of the flat part
  CHECK(sizes.size_at(0.6) == Approx(0.35));
  CHECK(sizes.smallest() == 0.05);
  CHECK(sizes.largest() == 0.5);
}

TEST_CASE("No rock passes the sieves up to the last zero of a table") {
  const SizeDistribution sizes(PassingTable{{{0.01, 0}, {0.05, 0}, {0.1, 1}}});
  CHECK(sizes.smallest() == 0.05);
}

TEST_CASE("Rosin-Rammler without effective cut-offs passes 63.2 % at x63 and 80 % at F80") {
  const SizeDistribution sizes(RosinRammler{0.1, 1.2, 1e-9, 10});
  CHECK(sizes.passing(0.1) == Approx(1 - std::exp(-1.0)).epsilon(1e-6));
  CHECK(sizes.size_at(0.8) == Approx(0.1 * std::pow(std::log(5.0), 1 / 1.2)).epsilon(1e-6));
}

TEST_CASE("Cut distributions are scaled to run from 0 to 1, and quantile and passing are inverse functions") {
  const SizeLaw law =
      GENERATE(SizeLaw{RosinRammler{0.1, 0.9, 0.02, 0.3}}, SizeLaw{GatesGaudinSchuhmann{0.5, 0.7, 0.05}},
               SizeLaw{PassingTable{{{0.02, 0}, {0.1, 0.7}, {0.4, 1}}}});
  const SizeDistribution sizes(law);
  for (const double p : {0.0, 1e-6, 0.1, 0.5, 0.9, 1.0})
    CHECK(sizes.passing(sizes.size_at(p)) == Approx(p).margin(1e-12));
  CHECK(sizes.passing(sizes.smallest()) == 0);
  CHECK(sizes.passing(sizes.largest()) == 1);
}

TEST_CASE("Gates-Gaudin-Schuhmann is a power law") {
  const SizeDistribution sizes(GatesGaudinSchuhmann{0.5, 0.7, 1e-12});
  CHECK(sizes.passing(0.25) == Approx(std::pow(0.5, 0.7)).epsilon(1e-6));
}

TEST_CASE("The vendor's feed has the passing shares of the brochures") {
  const SizeDistribution sizes(vendor_feed(1.575, 0.05));
  CHECK(sizes.largest() == Approx(0.8 * 1.575));
  CHECK(sizes.f80() == Approx(0.6 * 1.575));
  CHECK(sizes.f50() == Approx(0.1 * 1.575));
  CHECK(sizes.smallest() == 0.05);
  CHECK_THROWS_AS(vendor_feed(1, 0.1), BadInput);
  CHECK_THROWS_AS(vendor_feed(1, 0), BadInput);
  CHECK_THROWS_AS(vendor_feed(NAN, 0.1), BadInput);
}

TEST_CASE("Numbers that do not define a distribution are refused") {
  const SizeLaw law = GENERATE(
      SizeLaw{PassingTable{}}, SizeLaw{PassingTable{{{0.1, 0}}}}, SizeLaw{PassingTable{{{0.1, 0.1}, {0.2, 1}}}},
      SizeLaw{PassingTable{{{0.1, 0}, {0.2, 0.9}}}}, SizeLaw{PassingTable{{{0.2, 0}, {0.1, 1}}}},
      SizeLaw{PassingTable{{{0.1, 0}, {0.2, 0.6}, {0.3, 0.5}, {0.4, 1}}}}, SizeLaw{PassingTable{{{-0.1, 0}, {0.2, 1}}}},
      SizeLaw{PassingTable{{{0.1, 0}, {NAN, 1}}}}, SizeLaw{RosinRammler{0, 1, 0.1, 0.2}},
      SizeLaw{RosinRammler{0.1, 1, 0.2, 0.1}}, SizeLaw{RosinRammler{0.1, 1, 0, 0.1}},
      SizeLaw{GatesGaudinSchuhmann{0.1, 1, 0.1}}, SizeLaw{GatesGaudinSchuhmann{0.1, -1, 0.01}});
  CHECK_THROWS_AS(SizeDistribution(law), BadInput);
}

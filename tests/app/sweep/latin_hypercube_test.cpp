// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/latin_hypercube.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cstdlib>

namespace {

using namespace gyro;

std::vector<int> sorted_strata(const SampledRange& range, int points, const std::vector<std::string>& samples) {
  std::vector<int> strata;
  for (const std::string& sample : samples)
    strata.push_back(stratum_of(std::strtod(sample.c_str(), nullptr), range, points));
  std::sort(strata.begin(), strata.end());
  return strata;
}

}  // namespace

TEST_CASE("A Latin hypercube has each stratum of each range exactly once, also after rounding") {
  const int points = GENERATE(1, 2, 7, 20, 3000);
  // The last range is narrow: four digits would put its samples into other strata, or on the same number.
  const SampledRange range =
      GENERATE(SampledRange{0, 1}, SampledRange{-3, 5}, SampledRange{1e-6, 1e3, true}, SampledRange{100, 100.01});
  const std::vector<int> strata = sorted_strata(range, points, latin_hypercube(range, points, 3, 0));
  REQUIRE(strata.size() == static_cast<std::size_t>(points));
  for (int k = 0; k < points; ++k) CHECK(strata[static_cast<std::size_t>(k)] == k);
}

TEST_CASE("A Latin hypercube depends on its seed and the number of the range only") {
  const SampledRange range{0, 1};
  CHECK(latin_hypercube(range, 20, 1, 0) == latin_hypercube(range, 20, 1, 0));
  CHECK(latin_hypercube(range, 20, 1, 0) != latin_hypercube(range, 20, 2, 0));
  CHECK(latin_hypercube(range, 20, 1, 0) != latin_hypercube(range, 20, 1, 1));
}

TEST_CASE("Samples of a Latin hypercube have four digits where these keep the strata apart") {
  for (const std::string& sample : latin_hypercube({90, 150}, 20, 1, 0)) CHECK(sample.size() <= 5);
}

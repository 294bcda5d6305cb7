// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/feed.hpp"
#include "core/rocks/size_distribution.hpp"
#include "scenes.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

/// Spheres at the mass quantiles (k + 1/2)/n, as a library takes its sizes.
RockLibrary spheres_of(const SizeDistribution& sizes, int n) {
  RockLibrary library;
  for (int k = 0; k < n; ++k) library.rocks.push_back(sphere_rock(sizes.size_at((k + 0.5) / n) / 2));
  return library;
}

/// Diameters of all rocks that a feed of this mass gives.
std::vector<double> fed_sizes(const RockLibrary& library, double mass) {
  FeedPlan plan;
  plan.batch = mass;
  plan.entry = BoxRegion{{-5, -5, 0}, {5, 5, 2}};
  plan.positions = 1;
  plan.seed = 11;
  Feed feed(library, plan, {});
  std::vector<double> sizes;
  for (double time = 0; feed.wants(time) && sizes.size() < 100000; time += 1) {
    for (const NewRock& rock : feed.due(time, {}, {})) sizes.push_back(2 * rock.particles[0].radius);
  }
  return sizes;
}

}  // namespace

TEST_CASE("The mass curve of the rocks fed is that of the size law, within its statistical error", "[feed]") {
  const SizeDistribution sizes(
      GENERATE(SizeLaw{PassingTable{{{0.05, 0}, {0.5, 1}}}}, SizeLaw{RosinRammler{0.2, 1.4, 0.05, 0.5}},
               SizeLaw{GatesGaudinSchuhmann{0.5, 1.5, 0.05}}, SizeLaw{vendor_feed(0.6, 0.03)}));
  constexpr int samples = 24;
  const RockLibrary library = spheres_of(sizes, samples);
  const std::vector<double> fed = fed_sizes(library, 60000);
  const double n = static_cast<double>(fed.size());
  REQUIRE(n > 500);

  double total = 0;
  for (const double d : fed) total += d * d * d;
  double worst = 0;
  for (int k = 1; k < samples; ++k) {
    // A mass share is a ratio of sums over independent draws; its variance by the delta method.
    const double size = (library.rocks[k - 1].diameter + library.rocks[k].diameter) / 2;
    double finer = 0, variance = 0;
    for (const double d : fed) finer += d < size ? d * d * d : 0;
    const double share = finer / total;
    for (const double d : fed) variance += std::pow((d < size ? 1 - share : -share) * d * d * d / total, 2);
    worst = std::max(worst, std::abs(share - static_cast<double>(k) / samples) / std::sqrt(variance));
    // The law itself at this size: the library's steps are 1/24 high.
    CHECK(std::abs(share - sizes.passing(size)) < 0.5 / samples + 4 * std::sqrt(variance));
  }
  CHECK(worst < 3.5);  // the largest of 23 correlated normal deviates, p below 0.01
  CHECK(worst > 0.1);  // the sample is random
}

TEST_CASE("The numbers of rocks fed pass a Kolmogorov-Smirnov test", "[feed]") {
  const SizeDistribution sizes(GatesGaudinSchuhmann{0.5, 1.5, 0.05});
  const RockLibrary library = spheres_of(sizes, 50);
  std::vector<double> fed = fed_sizes(library, 60000);
  double expected = 0, distance = 0, whole = 0;
  for (const RockTemplate& rock : library.rocks) whole += std::pow(rock.diameter, -3);
  for (const RockTemplate& rock : library.rocks) {
    expected += std::pow(rock.diameter, -3) / whole;
    const auto finer = std::count_if(fed.begin(), fed.end(), [&](double d) { return d < rock.diameter * (1 + 1e-9); });
    distance = std::max(distance, std::abs(static_cast<double>(finer) / static_cast<double>(fed.size()) - expected));
  }
  CHECK(distance * std::sqrt(static_cast<double>(fed.size())) < 1.628);  // p = 0.01
}

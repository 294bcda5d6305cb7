// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/size_distribution.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

bool positive(double x) {
  return std::isfinite(x) && x > 0;
}

void check(const PassingTable& law) {
  const auto& p = law.points;
  if (p.size() < 2) {
    throw BadInput("passing table: has " + std::to_string(p.size()) + " rows; at least 2 are needed");
  }
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (!positive(p[k].size)) throw BadInput("passing table: every size must be > 0");
    if (!(p[k].fraction >= 0 && p[k].fraction <= 1))
      throw BadInput("passing table: every fraction must be between 0 and 1");
    if (k > 0 && !(p[k].size > p[k - 1].size)) throw BadInput("passing table: sizes must increase from row to row");
    if (k > 0 && p[k].fraction < p[k - 1].fraction)
      throw BadInput("passing table: fractions must not decrease from row to row");
  }
  if (p.front().fraction != 0) throw BadInput("passing table: the first fraction must be 0, for the smallest rock");
  if (p.back().fraction != 1) throw BadInput("passing table: the last fraction must be 1, for the largest rock");
}

void check(const RosinRammler& law) {
  if (!positive(law.x63) || !positive(law.exponent)) {
    throw BadInput("Rosin-Rammler law: x63 and exponent must be > 0");
  }
  if (!(positive(law.smallest) && positive(law.largest) && law.smallest < law.largest)) {
    throw BadInput("Rosin-Rammler law: the cut-offs must be 0 < smallest < largest");
  }
}

void check(const GatesGaudinSchuhmann& law) {
  if (!positive(law.largest) || !positive(law.exponent)) {
    throw BadInput("Gates-Gaudin-Schuhmann law: largest size and exponent must be > 0");
  }
  if (!(positive(law.smallest) && law.smallest < law.largest)) {
    throw BadInput("Gates-Gaudin-Schuhmann law: the sizes must be 0 < smallest < largest");
  }
}

double passing_of(const PassingTable& law, double x) {
  const auto& p = law.points;
  if (x <= p.front().size) return 0;
  if (x >= p.back().size) return 1;
  const auto above =
      std::upper_bound(p.begin(), p.end(), x, [](double size, const PassingPoint& q) { return size < q.size; });
  const auto below = above - 1;
  return below->fraction + (above->fraction - below->fraction) * (x - below->size) / (above->size - below->size);
}

double size_of(const PassingTable& law, double fraction) {
  const auto& q = law.points;
  if (fraction <= 0) {  // the largest size that nothing passes: the last row with 0
    const auto first = std::find_if(q.begin(), q.end(), [](const PassingPoint& a) { return a.fraction > 0; });
    return (first - 1)->size;
  }
  const auto above = std::lower_bound(q.begin(), q.end(), std::min(fraction, 1.0),
                                      [](const PassingPoint& a, double f) { return a.fraction < f; });
  const auto below = above - 1;
  return below->size + (above->size - below->size) * (std::min(fraction, 1.0) - below->fraction) /
                           (above->fraction - below->fraction);
}

// The two analytic laws: g(x) rises with x and is scaled to 0..1 between the cut-offs.
double power(double x, double scale, double exponent) {
  return std::pow(x / scale, exponent);
}

double passing_of(const RosinRammler& law, double x) {
  if (x <= law.smallest) return 0;
  if (x >= law.largest) return 1;
  const double t0 = power(law.smallest, law.x63, law.exponent);
  const auto uncut = [&](double size) { return -std::expm1(t0 - power(size, law.x63, law.exponent)); };
  return uncut(x) / uncut(law.largest);
}

double size_of(const RosinRammler& law, double p) {
  if (p <= 0) return law.smallest;
  if (p >= 1) return law.largest;
  const double t0 = power(law.smallest, law.x63, law.exponent);
  const double whole = -std::expm1(t0 - power(law.largest, law.x63, law.exponent));
  return law.x63 * std::pow(t0 - std::log1p(-p * whole), 1 / law.exponent);
}

double passing_of(const GatesGaudinSchuhmann& law, double x) {
  if (x <= law.smallest) return 0;
  if (x >= law.largest) return 1;
  const double low = power(law.smallest, law.largest, law.exponent);
  return (power(x, law.largest, law.exponent) - low) / (1 - low);
}

double size_of(const GatesGaudinSchuhmann& law, double p) {
  if (p <= 0) return law.smallest;
  if (p >= 1) return law.largest;
  const double low = power(law.smallest, law.largest, law.exponent);
  return law.largest * std::pow(low + p * (1 - low), 1 / law.exponent);
}

}  // namespace

PassingTable vendor_feed(double feed_opening, double smallest) {
  if (!(positive(feed_opening) && positive(smallest) && smallest < 0.1 * feed_opening))
    throw BadInput("vendor's feed: the smallest size must be above 0 and below 0.1 of the feed opening");
  return {{{smallest, 0}, {0.1 * feed_opening, 0.5}, {0.6 * feed_opening, 0.8}, {0.8 * feed_opening, 1}}};
}

SizeDistribution::SizeDistribution(SizeLaw law) : law_(std::move(law)) {
  std::visit([](const auto& l) { check(l); }, law_);
}

double SizeDistribution::passing(double size) const {
  return std::visit([&](const auto& l) { return passing_of(l, size); }, law_);
}

double SizeDistribution::size_at(double p) const {
  return std::visit([&](const auto& l) { return size_of(l, p); }, law_);
}

}  // namespace gyro

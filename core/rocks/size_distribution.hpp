// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// A sieve and the mass fraction of the rock that passes it.
struct PassingPoint {
  double size;      ///< [m]
  double fraction;  ///< passing, in [0, 1] [-]
};

/// Linear between sieves. Sizes increase, fractions do not decrease; the first fraction is 0 and the last 1.
struct PassingTable {
  std::vector<PassingPoint> points;
};

/// 1 - exp(-(x/x63)^exponent), cut off at both ends and scaled to run from 0 to 1 between them.
struct RosinRammler {
  double x63;                ///< size that 63.2 % of the uncut distribution passes [m]
  double exponent;           ///< [-]
  double smallest, largest;  ///< cut-offs [m]
};

/// (x/largest)^exponent, cut off below `smallest` and scaled to run from 0 to 1.
struct GatesGaudinSchuhmann {
  double largest;   ///< [m]
  double exponent;  ///< [-]
  double smallest;  ///< cut-off, above 0 [m]
};

/// The feed for which manufacturers state capacities (brochures of primary gyratory crushers): 100 % passes 0.8, 80 %
/// passes 0.6 and 50 % passes 0.1 of the feed opening. Linear between these sizes and from the smallest size on. Sizes
/// in [m].
/// @throws BadInput unless 0 < smallest < 0.1 feed_opening
PassingTable vendor_feed(double feed_opening, double smallest);

using SizeLaw = std::variant<PassingTable, RosinRammler, GatesGaudinSchuhmann>;

/// Distribution of rock sizes by mass. The size of a rock is the diameter of the sphere of its
/// solid volume.
class SizeDistribution {
 public:
  /// @throws BadInput if the numbers of the law do not define a distribution
  explicit SizeDistribution(SizeLaw law);

  /// Mass fraction smaller than the size [m], in [0, 1].
  double passing(double size) const;
  /// Size [m] that the mass fraction p in [0, 1] passes; the smallest such size if the law is flat there.
  double size_at(double p) const;
  double smallest() const { return size_at(0); }  ///< [m]
  double largest() const { return size_at(1); }   ///< [m]
  double f80() const { return size_at(0.8); }     ///< [m]
  double f50() const { return size_at(0.5); }     ///< [m]
  const SizeLaw& law() const { return law_; }

 private:
  SizeLaw law_;
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gyro {

/// A range that is sampled.
struct SampledRange {
  double low = 0, high = 1;  ///< low < high, and 0 < low where logarithmic
  bool logarithmic = false;
};

/// A Latin hypercube (McKay, Beckman & Conover, Technometrics 21 (1979) 239): each range is divided into as many strata
/// of equal width (of equal ratio where logarithmic) as there are points. Each stratum of each range has exactly one
/// point, at a random place in it, and the strata of the ranges are combined at random.
///
/// Numbers have as few digits as keep all samples of a range in their strata, and at least four, so that the names of
/// points and the lines of jobs hold them exactly.
/// @param number  of the range; it decides which random numbers are drawn, so that a range keeps its samples whatever
///                other ranges there are
/// @returns one number for each point, as text
std::vector<std::string> latin_hypercube(const SampledRange& range, int points, std::uint64_t seed, int number);

/// The stratum of a value, from 0; below 0 or at least `points` outside of the range.
int stratum_of(double value, const SampledRange& range, int points);

}  // namespace gyro

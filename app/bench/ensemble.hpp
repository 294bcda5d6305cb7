// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace gyro::bench {

/// Mean of a sample and its standard error.
struct Mean {
  double value = 0;
  double error = 0;  ///< s/sqrt(n), s with n - 1 degrees of freedom; NaN with fewer than two members
  int count = 0;
};

/// Members that are NaN (there was nothing to measure) are left out; if none is left, the mean is NaN.
Mean mean_of(std::span<const double> sample);

/// How a quantity is compared with its reference.
enum class Family {
  path,       ///< the same in every run until the first break: mean over seeds of |x/x_ref - 1|
  identity,   ///< a name, such as a bond: share of seeds in which it differs
  ensemble,   ///< chaotic after breakage: |mean of paired differences| / |mean of the reference|
  invariant,  ///< zero in exact arithmetic: mean of |x|
};

/// An error with its uncertainty and the error of the reference.
struct Deviation {
  double error = 0;
  double error_se = 0;   ///< standard error of `error` over the seeds
  double noise = 0;      ///< ensemble: standard error of the reference's mean; others: error of the reference
  double bias = 0;       ///< mean relative difference, with its sign; 0 for an identity
  double mean = 0;       ///< of the quantity
  double reference = 0;  ///< mean of the reference
  int seeds = 0;         ///< number of pairs with two values
};

/// Values of one quantity by seed, in the same order.
struct Paired {
  std::span<const double> measured, reference;
  std::span<const double> coarse;  ///< reference at twice its step, which bounds the error of the reference
};

/// @pre all three are equally long
Deviation deviation(Family family, const Paired& values);

}  // namespace gyro::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/run_data.hpp"

#include <optional>
#include <span>
#include <vector>

/// Curves that follow from the tables of a run.
namespace gyro::report {

struct Points {
  std::vector<double> x, y;
};

/// Running mean: at each row the mean over `span` seconds around it, where the rows reach as far. Values that are not
/// finite are left out. Rows stand for equal times; `time` is rising.
Points running_mean(std::span<const double> time, std::span<const double> values, double span);

/// Mean over the rows after `begin` by the angle of the eccentric: middles of the bins [degrees] and means; bins
/// without rows are left out. A row that is a mean belongs to the middle of the angles at its ends.
Points by_angle(const Table& series, const Column& column, double begin);

/// Duration of a gyration at the end of the run [s]; nothing without a whole one.
std::optional<double> gyration_time(const RunData& run);

/// When the last `count` whole gyrations begin, or the steady part if that is later or the run is shorter [s].
double last_gyrations(const RunData& run, double count);

/// Share of the mass that passes each sieve.
struct SizeCurve {
  std::vector<double> sizes, passing;  ///< [m], [-]
  double mass = 0;                     ///< [kg]; 0: of a law
};

/// The rock that came to a table after `begin`; nothing without such rock. @param column  passing or passing_with_fines
std::optional<SizeCurve> size_curve(const Sieved& sieved, double begin, const char* column = "passing");

/// The feed as its law states it; nothing without a law.
std::optional<SizeCurve> feed_curve(const CaseFacts& facts);

/// Size that a share passes, linear on the logarithm of the size between two sieves; nothing outside of the curve.
std::optional<double> passing_size(const SizeCurve& curve, double share);

/// Values times a factor.
std::vector<double> scaled(std::vector<double> values, double factor);

/// Largest magnitude of finite values; 0 without any.
double largest(std::span<const double> values);

}  // namespace gyro::report

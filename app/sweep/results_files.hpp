// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/results.hpp"

#include <filesystem>
#include <string>

namespace gyro {

/// One row a point: name, keys and figures. Names of figures are those of summary.json, values are in SI units unless
/// the name has another one; a figure that a point lacks is empty.
std::string results_csv(const SweepResults& results);

/// The same and the means of the settings as HDF5: /points has a dataset for each column, /settings for each key, and
/// /settings/mean and /settings/standard_error for each figure. Datasets have the attributes `units` and `description`.
/// @throws OutputError
void write_results_h5(const SweepResults& results, const std::filesystem::path& file);

}  // namespace gyro

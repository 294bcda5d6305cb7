// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace gyro {

/// The end of a run as `--until` gives it: a time, or `steady`, perhaps with a relative standard error.
struct RunEnd {
  std::optional<double> until = {};   ///< simulated time [s]
  std::optional<double> steady = {};  ///< relative standard error at which the run ends [-]
};

/// A RunEnd, or the reason why a text is none.
struct ParsedRunEnd {
  std::optional<RunEnd> end = {};
  std::string problem = {};  ///< "problem; what to do"
};

/// Reads `2.5`, `500 ms`, `steady` or `steady=3%`.
ParsedRunEnd parse_run_end(const std::string& text);

}  // namespace gyro

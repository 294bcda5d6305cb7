// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/run_data.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gyro::report {

/// A figure of a run, for the tiles on top of the page and for the table that compares runs.
struct Headline {
  std::string key;              ///< as in summary.json; of a steady run with "steady."
  std::string label;            ///< what a reader sees
  std::string units;            ///< SI; "%" for shares in percent
  double value = 0;             ///< in these units
  std::optional<double> error;  ///< standard error
  std::string about;            ///< a sentence that says what it is
  bool big = false;             ///< a tile
};

/// The figures that a run has, those of its steady part if there is one.
std::vector<Headline> headlines(const Summary& summary);

/// "27.9 ± 0.4 kW".
std::string text_of(const Headline& figure);

/// Description of a figure of summary.json from the table that writes it.
std::string about_figure(const std::string& name);

}  // namespace gyro::report

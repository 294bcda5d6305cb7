// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/run_data.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The sections of the page, in its order. With one run a section shows all of it; with several it lays their curves
/// over each other. A section of which the runs have nothing is an empty text.
namespace gyro::report {

using Runs = std::vector<RunData>;

std::string verdict_section(const Runs& runs);
std::string size_section(const Runs& runs);
std::string time_section(const Runs& runs);
std::string load_section(const Runs& runs);  ///< over the angle, polar plot and maps of the liners
std::string energy_section(const Runs& runs);
std::string breakage_section(const Runs& runs);
std::string view_section(const Runs& runs);  ///< reads the snapshots
std::string performance_section(const Runs& runs);
std::string provenance_section(const Runs& runs);

// Parts of sections.

/// @param content  empty: no section
std::string section(std::string_view id, std::string_view title, const std::string& content);

/// Figures side by side where the page is wide enough.
std::string side_by_side(const std::string& figures);

/// A part for each run: as it is for one run, behind its name for several.
template <class Part>
std::string by_run(const Runs& runs, Part&& part);

/// A part of one run that is shown when its name is clicked.
std::string folded(std::string_view name, const std::string& content, bool open = false);

/// A table with a heading for each column; cells are HTML. The first column is text, the others numbers.
std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);

template <class Part>
std::string by_run(const Runs& runs, Part&& part) {
  if (runs.size() == 1) return part(runs.front());
  std::string all;
  for (const RunData& run : runs)
    if (const std::string content = part(run); !content.empty()) all += folded(run.name, content);
  return all;
}

}  // namespace gyro::report

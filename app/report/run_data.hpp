// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/case_facts.hpp"
#include "app/report/table.hpp"
#include "io/run/summary.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gyro::report {

/// /product or /holdup.
struct Sieved {
  Table table;
  std::vector<double> sizes;                 ///< openings of the sieves [m]
  std::optional<double> resolution, finest;  ///< sizes of the coarsest and the finest particle [m]
};

/// Maps of one liner over time.
struct LinerMaps {
  std::string wall;
  Table table;                            ///< pressure and work by cell
  std::vector<double> heights, azimuths;  ///< edges of the cells [m], [rad]
  std::vector<double> area;               ///< of the surface in each cell [m2]
};

/// What /breakage has of each broken bond.
struct Breaks {
  std::vector<double> time, height;  ///< [s], [m]
  std::vector<int> mode;             ///< 1: in tension, 2: in shear
  std::vector<double> energy;        ///< released [J]
};

/// /case.
struct Provenance {
  std::string yaml, version, git, device, precision, seed;
};

/// Everything that the page shows of a run, except for its snapshots. What the run does not have is empty.
struct RunData {
  std::filesystem::path directory;
  std::string name;  ///< short, different from that of other runs on the page
  Summary summary;
  CaseFacts facts;
  Provenance provenance;
  std::optional<Table> series, ledger, performance;
  std::optional<Sieved> product, holdup;
  std::optional<Breaks> breaks;
  std::vector<LinerMaps> liners;
  std::vector<std::pair<std::string, double>> phases;  ///< of the engine and the seconds that they took, longest first

  /// When the part of the run begins whose figures are shown: the steady part, or all of it [s].
  double begin() const { return summary.steady ? summary.steady->from : 0; }
  double end() const;  ///< [s]
  /// Turns of the eccentric in the whole run; none without a drivetrain.
  std::optional<double> gyrations() const;
};

/// Reads a run that has ended. @throws BadInput with the path for a directory without a run, or with a damaged one
RunData read_run(const std::filesystem::path& directory);

/// Short names for runs on one page: the names of the directories, and where these are equal with those above them.
void name_runs(std::vector<RunData>& runs);

/// Time by phase from the text of log.txt, summed over the parts of a run; the longest first.
std::vector<std::pair<std::string, double>> phases_of(const std::string& log);

}  // namespace gyro::report

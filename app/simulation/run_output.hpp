// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/simulation/liner_maps.hpp"
#include "app/simulation/readings.hpp"
#include "app/simulation/simulation.hpp"
#include "io/run/results.hpp"
#include "io/run/snapshots.hpp"
#include "io/run/summary.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gyro {

/// What a run writes while it runs: the series, the ledger, breakages, product curves and snapshots.
/// What a case does not have gets no column.
class RunOutput {
 public:
  /// @param saved  of an output to go on with, else null; what the directory holds beyond it is dropped
  /// @throws BadInput for a directory that does not hold what was written until then
  RunOutput(const Case& input, const Assembly& assembly, const CaseRecord& record,
            const std::filesystem::path& directory, const SavedState* saved = nullptr);

  /// Writes the snapshot of the start, if the case asks for snapshots.
  void begin(const Simulation& simulation);
  /// Adds a window to the means; writes the row and the snapshot that are due.
  void take(const WindowResult& result, const Simulation& simulation);
  /// Sums and places in the files between two windows.
  void save(SavedState& to) const;
  /// Waits until the disk has all rows: a checkpoint must never be ahead of them.
  void sync() { results_.sync(); }
  double earlier_seconds() const { return earlier_seconds_; }  ///< wall clock of the run's earlier parts
  /// Writes what is left and closes the files. @param simulation  inspected at its end
  void close(const Simulation& simulation);

  double mean_crushing_power() const { return time_ > 0 ? crushing_work_ / time_ : 0; }  ///< over the run [W]
  double crushing_work() const { return crushing_work_; }                                ///< [J]
  const std::vector<GyrationMeans>& gyrations() const { return gyrations_.gyrations(); }

 private:
  using Row = std::map<std::string, std::vector<double>>;

  std::vector<Channel> series_channels() const;
  ResultsContent content(const CaseRecord& record) const;
  void restore(const SavedState& saved);
  double wall_seconds() const;
  void add_probes(const Simulation& simulation, Row& now) const;
  void add_means(const WindowResult& result, const Simulation& simulation);
  void write_row(const Simulation& simulation);
  void write_curves(const Simulation& simulation);
  void write_ledger(const Simulation& simulation);
  void write_snapshot(const Simulation& simulation);
  bool due(double interval, std::int64_t written, double time) const;

  const Case& input_;
  const Assembly& assembly_;
  Index gyrating_;
  bool has_mantle_, has_drive_;
  DriveKnowledge drive_knows_;
  bool has_bonds_, has_feed_, has_product_;
  std::vector<Channel> series_;
  LinerMaps maps_;
  GyrationReader gyrations_;
  ResultsFile results_;
  SnapshotWriter snapshots_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double earlier_seconds_ = 0;

  Row sums_;                ///< of window value x window length since the last row
  double summed_time_ = 0;  ///< [s]
  double discharged_before_ = 0, crushing_work_ = 0, time_ = 0;
  std::int64_t frames_ = 0;  ///< intervals of output.snapshots that are over
};

}  // namespace gyro

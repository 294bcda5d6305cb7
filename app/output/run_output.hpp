// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/output/gyrations.hpp"
#include "app/output/liner_maps.hpp"
#include "app/output/motor_rows.hpp"
#include "app/output/rows.hpp"
#include "app/simulation/simulation.hpp"
#include "io/fields/fields_file.hpp"
#include "io/run/results.hpp"
#include "io/run/snapshots.hpp"
#include "io/run/writer_thread.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace gyro {

/// The files that a run writes while it runs: results.h5 and the snapshots. Only parts that the case has get output.
/// Snapshots are written by a thread of their own, so that compressing them takes no time of the run.
class RunOutput {
 public:
  /// Throws if the directory is another run's now. It is called by the thread that writes snapshots, before each,
  /// and by sync().
  using RequireOwn = std::function<void()>;

  /// @param saved  state of the output of a resumed run, otherwise null; later rows and snapshots are removed
  /// @throws BadInput if the directory lacks output that was written before the saved state
  RunOutput(const Case& input, const Assembly& assembly, const CaseRecord& record,
            const std::filesystem::path& directory, RequireOwn require_own, const SavedState* saved = nullptr);

  /// Writes what there is at the start: the snapshot, if the case asks for snapshots, and rock that lies outside.
  void begin(Simulation& simulation);
  /// Adds a window; writes the row, and has the snapshot written, if they are due. A window with numbers that are not
  /// finite is left out, and all that follows: no table has such numbers.
  void take(const WindowResult& result, const Simulation& simulation);
  /// Saves the state that a resumed run needs, between two windows.
  void save(SavedState& to) const;
  /// Waits until all snapshots are written and the disk has all rows: a checkpoint must never be ahead of them. Throws
  /// if the directory is another run's now.
  void sync();
  double earlier_seconds() const { return state_.wall_seconds; }  ///< wall clock of the run's earlier parts [s]
  /// Whether windows were left out, or the present state is not finite.
  bool lost(const Simulation& simulation);
  /// Writes the last row, unless it is lost, and the fragments that are left in the scene, and closes the files.
  /// @param simulation  inspected at its end
  void close(Simulation& simulation);
  /// Closes the files without the row of an interval that is not complete.
  void close();

  double mean_crushing_power() const { return state_.time > 0 ? state_.crushing_work / state_.time : 0; }  ///< [W]
  double crushing_work() const { return state_.crushing_work; }                                            ///< [J]
  const GyrationRecord& gyrations() const { return gyrations_.record(); }
  /// The same with the fines of the product; empty unless the case asks for them.
  const GyrationRecord* gyrations_with_fines() const { return with_fines_ ? &with_fines_->record() : nullptr; }
  const MotorRows& motor() const { return motor_; }

 private:
  /// Everything that a checkpoint must keep in addition to the states of its parts.
  struct State {
    double time = 0;                     ///< [s]
    double crushing_work = 0;            ///< since the start [J]
    double wall_seconds = 0;             ///< of the earlier parts of the run [s]
    double snapshot_interval = 0;        ///< interval with which `frames` was counted [s]
    std::int64_t frames = 0;             ///< completed intervals of output.snapshots
    std::vector<double> snapshot_times;  ///< [s]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("time", s.time...);
      f("crushing_work", s.crushing_work...);
      f("wall_seconds", s.wall_seconds...);
      f("snapshot_interval", s.snapshot_interval...);
      f("frames", s.frames...);
      f("snapshot_times", s.snapshot_times...);
    }
  };

  /// A snapshot with all that its files need: 124 bytes a particle, 32 a bond, 128 a fragment, and the moved walls. At
  /// most two exist: one that is written, and one that waits or is being made. The writer of .vtp files has one file at
  /// a time as 32-bit numbers as well, that of fields.h5 a whole frame, and the one before.
  struct Frame {
    double time;  ///< [s]
    ParticleSnapshot particles;
    std::optional<BondSnapshot> bonds;
    std::vector<PosedWall> walls;
    std::optional<FragmentSnapshot> fragments;
    std::vector<PosedWall> fixed;  ///< only in the first frame of this process
  };

  ResultsContent content(const CaseRecord& record) const;
  double wall_seconds() const;
  void note_drive(const WindowResult& result, const Simulation& simulation);
  void write_row(const Simulation& simulation);
  void write_snapshot(const Simulation& simulation);
  void write_files(const Frame& frame);
  void add_walls(Frame& frame, const Simulation& simulation);

  const Case& input_;
  const Assembly& assembly_;
  State state_;
  RowWriter rows_;
  LinerMaps maps_;
  RequireOwn require_own_;
  FragmentHistory history_;
  bool lost_ = false;         ///< a number was not finite
  bool fixed_given_ = false;  ///< the writer has the walls that are the same in all frames
  GyrationReader gyrations_;
  std::optional<GyrationReader> with_fines_;
  MotorRows motor_;
  ResultsFile results_;
  std::optional<SnapshotWriter> snapshots_;  ///< output.formats has vtp; used by the writer's thread only
  std::optional<FieldsFile> fields_;         ///< the same for hdf5
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  WriterThread writer_;  ///< ends first: its jobs use the members above
};

}  // namespace gyro

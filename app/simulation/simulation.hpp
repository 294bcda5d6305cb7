// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/ledger.hpp"
#include "app/simulation/momentum_balance.hpp"
#include "app/simulation/setup.hpp"
#include "app/simulation/thin_wall_check.hpp"
#include "core/fragments/fines.hpp"
#include "core/fragments/hold_up.hpp"
#include "core/scene/dem.hpp"
#include "mbd/drivetrain.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// What happened in one window.
struct WindowResult {
  Window window;
  MantleLoad load;                         ///< on the drive
  Vec3d mantle_force{0, 0, 0};             ///< of the rock on the first gyrating wall, mean [N]
  double crushing_power = 0;               ///< mean [W]
  std::vector<WallLoad> walls;             ///< one per wall
  std::vector<Breakage> breakages;         ///< of bonds, by time
  std::vector<WallImpulse> wall_impulses;  ///< empty unless scene.wall_impulses
  std::vector<FragmentRecord> left;        ///< fragments that its inspection found to have left the chamber
  double holdup_mass = 0;                  ///< at the end of the window, before its inspection [kg]
  double discharged_mass = 0;              ///< likewise, since the start [kg]
  bool inspected = false;                  ///< it ended with an inspection
};

/// The coupled run: DEM, drivetrain, feed, product and ledger, one window at a time.
///
/// Serial staggered exchange (cf. Lommen, Lodewijks & Schott 2018): the drivetrain leads with a path, the rock responds
/// with the work done along it, the drivetrain catches up.
class Simulation {
 public:
  /// @param setup       see setup.hpp
  /// @param dem         empty scene made from setup.scene, on any device
  /// @param drivetrain  moves the gyrating walls; without one they stand still
  /// @param saved       what a simulation of the same setup has saved, to continue from; null: starts at t = 0
  /// @throws BadSetup for a setup that cannot be run; BadInput for the saved state of another run
  Simulation(Setup setup, std::unique_ptr<Dem> dem, std::optional<Drivetrain> drivetrain = {},
             const SavedState* saved = nullptr);
  Simulation(const Simulation&) = delete;  // the feed refers to the setup
  Simulation& operator=(const Simulation&) = delete;

  /// Advances by one window, and inspects when setup.inspection_interval asks for it. Ask for the verdict before the
  /// next.
  /// @param max_steps  makes the window shorter than setup.steps_per_window; at least one step is done
  WindowResult advance(int max_steps = std::numeric_limits<int>::max());
  /// A window that this condition gives up ends advance() with WindowGivenUp: it never was, the figures stay those of
  /// its beginning, and the simulation cannot go on but from a saved state. Bits of windows that end are not changed.
  void give_up_windows_when(GiveUp condition) { dem_->give_up_when(std::move(condition)); }
  /// Why the last window must be the last; empty while all is well.
  const std::optional<std::string>& verdict() const { return verdict_; }
  /// @throws StoppedByGuard with the verdict, if there is one
  void require_sound() const;

  /// Looks at the fragments now: counts those that have left the chamber and removes those far below it. Two
  /// particles that touch through a mesh wall are a verdict. Does nothing where any position is not finite.
  void inspect();

  /// Without `start` and the pieces of `filling`, which are in the scene.
  const Setup& setup() const { return setup_; }
  /// What setup.filling has come to, without the rocks; none without it, and where the simulation continues.
  const std::optional<Filled>& filled() const { return filled_; }
  double time() const { return static_cast<double>(state_.step) * setup_.scene.dt; }  ///< [s]
  const Dem& dem() const { return *dem_; }
  const Ledger& ledger() const { return ledger_; }
  const MomentumBalance& momentum() const { return momentum_; }
  const std::optional<Drivetrain>& drivetrain() const { return drivetrain_; }
  const std::optional<Feed>& feed() const { return feed_; }
  const std::optional<Product>& product() const { return product_; }
  /// Content of the chamber at the last inspection.
  const std::optional<HoldUp>& hold_up() const { return hold_up_; }
  /// The estimate of what is finer than particles; empty unless setup.discharge asks for it.
  const std::optional<Fines>& fines() const { return fines_; }
  FeedAccount fed() const;
  double start_mass() const { return state_.start_mass; }  ///< of setup.start and setup.filling [kg]
  double discharged_mass() const;                          ///< since the start [kg]
  double escaped_mass() const;                             ///< over the rim since the start [kg]
  double escaped_fraction() const;                         ///< of the mass fed or there at the start [-]
  double holdup() const;                                   ///< mass fed or there at the start that has not left [kg]
  /// Whether the chamber takes less than the feed gives: more rock waits for room than one gyration feeds.
  bool choked() const;
  /// Why this run can have no checkpoints; empty when it can.
  std::string unsaveable() const { return drivetrain_ ? drivetrain_->unsaveable() : std::string(); }
  /// Messages of the drive since the last call, for the log.
  std::vector<std::string> take_drive_notes() {
    return drivetrain_ ? drivetrain_->take_notes() : std::vector<std::string>{};
  }
  /// Particles fed, and where they are; after a window was given up, those of the last inspection.
  MassCount mass_count() const;
  std::int64_t fragments() const { return state_.fragments; }          ///< at the last inspection
  double largest_fragment() const { return state_.largest_fragment; }  ///< mass of the heaviest at that time [kg]
  /// Fragments that inspections outside of advance() found to have left, since the last call.
  std::vector<FragmentRecord> take_left() { return std::exchange(left_, {}); }
  /// The fragments that are in the scene now and have not left; none where a position is not finite.
  std::vector<FragmentRecord> fragments_inside() const { return fragments_inside(dem_->particles()); }
  /// The same. @param particles  as they are now
  std::vector<FragmentRecord> fragments_inside(const ParticleSnapshot& particles) const;
  std::int64_t bonds_initial() const { return state_.bonds_inserted; }
  /// What must be kept to continue bit for bit, between windows of a sound run.
  SavedState save() const;

 private:
  /// What a checkpoint keeps besides the parts that keep their own.
  struct State {
    double time_step = 0, inspection_interval = 0;  ///< [s]
    std::int32_t substeps = 1;                      ///< largest of a rock
    std::int64_t step = 0;
    std::int64_t inspections = 0;  ///< that were due so far
    std::int64_t particles_inserted = 0, bonds_inserted = 0, fragments = 0;
    double start_mass = 0, mass_inside = 0, largest_fragment = 0;  ///< [kg]
    std::vector<RockId> fed_rocks;                                 ///< that came after the start, ascending
    std::vector<double> fed_times;                                 ///< when each of them came [s]

    template <class F, class S>
    static constexpr void for_each_field(F&& f, S& s) {
      f("time_step", s.time_step);
      f("substeps", s.substeps);
      f("inspection_interval", s.inspection_interval);
      f("step", s.step);
      f("inspections", s.inspections);
      f("particles_inserted", s.particles_inserted);
      f("bonds_inserted", s.bonds_inserted);
      f("fragments", s.fragments);
      f("start_mass", s.start_mass);
      f("mass_inside", s.mass_inside);
      f("largest_fragment", s.largest_fragment);
      f("fed_rocks", s.fed_rocks);
      f("fed_times", s.fed_times);
    }
  };

  void start();
  void fill_chamber();
  void restore(const SavedState& saved);
  int steps_ahead(int max_steps) const;
  void advance_rock(const Window& window, const MantlePath& path);
  void insert(std::span<const NewRock> rocks);
  void feed_rock();
  void note_load(WindowResult& result, const MantlePath& path) const;
  void close_balances(const WindowResult& result);
  void open_balances();
  bool inspection_due() const;
  double fed_at(RockId rock) const;  ///< time at which a rock came [s]; 0 for all that there was at the start
  void count_product(const ParticleSnapshot& particles, const FragmentTable& table);
  MassCount mass_count(std::int64_t inside) const;

  Setup setup_;
  double rock_density_;  ///< [kg/m3]
  std::unique_ptr<Dem> dem_;
  std::optional<Drivetrain> drivetrain_;
  std::optional<Feed> feed_;
  std::optional<Filled> filled_;
  std::optional<Product> product_;
  std::optional<HoldUp> hold_up_;
  std::optional<Fines> fines_;
  Ledger ledger_;
  MomentumBalance momentum_;
  ThinWallCheck thin_walls_;
  std::optional<std::string> verdict_;
  State state_;
  std::vector<FragmentRecord> left_;
  MassCount counted_;               ///< by the last inspection, or when the state was restored
  bool given_up_ = false;           ///< the scene is in the middle of a window
  std::int64_t inspected_at_ = -1;  ///< step of the last inspection
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/assembly.hpp"
#include "app/simulation/ledger.hpp"
#include "app/simulation/momentum_balance.hpp"
#include "app/simulation/thin_wall_check.hpp"
#include "core/feed/feed.hpp"
#include "core/fragments/hold_up.hpp"
#include "mbd/drivetrain.hpp"

#include <memory>
#include <optional>

namespace gyro {

/// What one window did, for the series.
struct WindowResult {
  Window window;
  MantleLoad load;              ///< on the drive
  Vec3d mantle_force{0, 0, 0};  ///< of the rock on the gyrating wall, mean [N]
  double crushing_power = 0;    ///< [W]
  std::vector<WallLoad> walls;  ///< one per wall
};

/// The coupled run: DEM, drivetrain, feed, product and ledger, one window at a time.
///
/// Serial staggered exchange (cf. Lommen, Lodewijks & Schott 2018): the drivetrain leads with a
/// path, the rock answers with the work done along it, the drivetrain catches up.
class Simulation {
 public:
  /// @param dem  empty scene made from `assembly.scene`
  /// @throws BadKey for a start state or a feed that cannot be had
  Simulation(const Case& input, const Assembly& assembly, std::unique_ptr<Dem> dem);
  /// Goes on from what a simulation of the same case has saved. @throws BadInput for another one's
  Simulation(const Case& input, const Assembly& assembly, std::unique_ptr<Dem> dem, const SavedState& saved);

  /// Advances by one window. Ask for the verdict before the next one.
  WindowResult advance();
  /// Why the last window must be the last; nothing while all is well.
  const std::optional<std::string>& verdict() const { return verdict_; }
  /// @throws StoppedByGuard with the verdict, if there is one
  void require_sound() const;

  /// Looks at the fragments: counts what has passed the discharge plane, takes out what has left. Particles that touch
  /// through a sheet are a verdict.
  /// Called once per row of the series.
  void inspect();

  double time() const { return static_cast<double>(step_) * assembly_.scene.dt; }
  const Dem& dem() const { return *dem_; }
  Dem& dem() { return *dem_; }
  const Ledger& ledger() const { return ledger_; }
  const MomentumBalance& momentum() const { return momentum_; }
  const std::optional<Drivetrain>& drivetrain() const { return drivetrain_; }
  const std::optional<Feed>& feed() const { return feed_; }
  const std::optional<Product>& product() const { return product_; }
  /// What the chamber held at the last inspection.
  const std::optional<HoldUp>& hold_up() const { return hold_up_; }
  FeedAccount fed() const;
  double start_mass() const { return start_mass_; }  ///< of the case's `particles` [kg]
  double holdup() const;                             ///< mass between feed and discharge [kg]
  /// Whether the chamber takes less than the feed gives: more rock waits for room than one gyration feeds.
  bool choked() const;
  /// Why there can be no checkpoints of this run; empty when there can.
  std::string unsaveable() const { return drivetrain_ ? drivetrain_->unsaveable() : std::string(); }
  /// What the drivetrain has to say since it was asked last, for the log.
  std::vector<std::string> take_drive_notes() {
    return drivetrain_ ? drivetrain_->take_notes() : std::vector<std::string>{};
  }
  MassCount mass_count() const;
  std::int64_t fragments() const { return fragments_; }
  double largest_fragment() const { return largest_fragment_; }  ///< mass of the heaviest [kg]
  std::int64_t bonds_initial() const { return bonds_put_in_; }
  /// What must be kept to go on bit for bit, between windows of a sound run.
  SavedState save() const;

 private:
  void make_parts();
  void restore(const SavedState& saved);
  int steps_ahead() const;
  void put_in(std::span<const NewRock> rocks);
  void feed_rock();
  void close_balances(const WindowResult& result);
  void open_balances();
  MantleLoad mantle_load(const std::vector<WallLoad>& walls, const MantlePath& path, double length) const;

  const Case& input_;
  const Assembly& assembly_;
  std::unique_ptr<Dem> dem_;
  std::optional<Drivetrain> drivetrain_;
  std::optional<Feed> feed_;
  std::optional<Product> product_;
  std::optional<HoldUp> hold_up_;
  Ledger ledger_;
  MomentumBalance momentum_;
  ThinWallCheck thin_walls_;
  std::optional<std::string> verdict_;
  std::int64_t step_ = 0;
  std::int64_t particles_put_in_ = 0, bonds_put_in_ = 0, fragments_ = 0;
  double start_mass_ = 0, mass_inside_ = 0, largest_fragment_ = 0;  ///< [kg]
};

}  // namespace gyro

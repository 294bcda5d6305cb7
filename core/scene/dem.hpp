// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/scene/accounts.hpp"
#include "core/scene/new_rock.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/snapshot.hpp"
#include "core/scene/window.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// A discrete element scene on one executor and in one precision. Calls are cheap at the
/// scale of a window and virtual only there.
class Dem {
 public:
  virtual ~Dem() = default;
  /// Adds rocks between windows. Ids must be new.
  virtual void insert(std::span<const NewRock> rocks) = 0;
  /// Removes particles between windows. @param ids particles, whole fragments.
  virtual void remove(std::span<const ParticleId> ids) = 0;
  /// Where the walls stand now. One per wall; before the first window as at time 0.
  virtual std::vector<WallPose> wall_poses() const = 0;
  /// Wall seconds by phase of the step, since the start.
  virtual std::vector<std::pair<std::string, double>> phase_seconds() const = 0;
  /// What has passed between the host and a device since the program's start, by name: launches, reads, bytes. Empty
  /// without a device.
  virtual std::vector<std::pair<std::string, std::int64_t>> traffic() const { return {}; }
  /// Advances by one window; every wall moves as its motion says, gyrating ones along `path`.
  /// @throws StoppedByGuard when particles crowd or have too many neighbours; WindowGivenUp, after which nothing but
  /// restore() makes the scene usable again. Counts, breakages and wall loads are still those of the last whole window.
  virtual void advance(const Window& window, const MantlePath& path) = 0;

  /// Asks this in all windows from now on.
  virtual void give_up_when(GiveUp condition) = 0;

  virtual std::vector<WallLoad> wall_loads() const = 0;  ///< of the last window, one per wall
  virtual EnergyTerms energy() const = 0;                ///< now
  virtual Extremes extremes() const = 0;                 ///< now
  virtual Counts counts() const = 0;
  virtual Vec3d momentum() const = 0;  ///< [kg m/s]
  /// energy(), extremes() and momentum() of now, to the bit; a solver adds up the scene once for all of them.
  virtual Balance balance() const { return {energy(), extremes(), momentum()}; }
  virtual ParticleSnapshot particles() const = 0;      ///< now, fragments labelled
  virtual BondSnapshot bonds() const = 0;              ///< now
  virtual std::vector<Breakage> take_breakages() = 0;  ///< since the last call, ordered by time, i, j
  /// Since the last call; empty unless Scene::wall_impulses. They add up to the loads of the walls, except for half of
  /// the last step, which the loads count in the next window.
  virtual std::vector<WallImpulse> take_wall_impulses() = 0;

  /// The state between two windows, enough to continue bit for bit on any executor in this precision.
  virtual SavedState save() const = 0;
  /// Replaces the state by one that a scene of the same case has saved. @throws BadInput as SavedState::get
  virtual void restore(const SavedState& saved) = 0;
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/base/saved_state.hpp"
#include "core/kernels/accounts.hpp"
#include "core/scene/accounts.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace gyro {

/// Owns what rock and walls do to each other: exact sums over the steps of a window, the share of the last step's loads
/// that acts in the next window, the mean loads of the last window and, if asked for, the impulse of each particle.
template <class Exec>
class WallAccounts {
 public:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  /// Columns that say where the particles are.
  struct Rock {
    const Buffer<Sphere>& position;
    const Buffer<ParticleId>& id;
  };

  /// @param impulses  whether the impulse of each particle is kept
  WallAccounts(std::size_t walls, bool impulses) : with_impulses_(impulses), sums_(walls), loads_(walls) {}

  const std::vector<WallLoad>& loads() const { return loads_; }  ///< of the last window
  std::vector<WallImpulse> take_impulses() { return std::exchange(impulses_, {}); }

  /// Where wall forces book; as many rows as the wall list has.
  WallBooking booking() { return {entry_sums_.data(), entry_carried_over_.data()}; }
  /// A new wall list. What was booked at the old one has been added up.
  void set_entries(Index count) {
    entry_sums_.resize(static_cast<std::size_t>(count));  // all zero
    entry_carried_over_.resize(static_cast<std::size_t>(count));
  }

  /// Adds what the entries have booked to the sums of the walls.
  void add_up(Exec& exec, const Buffer<WallEntry>& entries) {
    GYRO_EXPECT(entries.size() == entry_sums_.size());
    if (entries.size() == 0) return;
    if (with_impulses_) keep_impulses(entries, entry_sums_);
    for (std::size_t w = 0; w < sums_.size(); ++w) sums_[w] = sums_[w] + sum(exec, entries, entry_sums_, w);
    exec.for_each("clear walls", static_cast<Index>(entries.size()), ClearWallSums{entry_sums_.data()});
  }

  /// Turns the sums of a window into its loads.
  /// @param poses   at its end
  /// @param length  of the window [s]
  void close(Exec& exec, const Buffer<WallEntry>& entries, const Rock& rock, const std::vector<WallPose>& poses,
             double length) {
    add_up(exec, entries);
    note_impulses(rock, poses);
    GYRO_EXPECT(length > 0 && poses.size() == sums_.size());
    const double mean = wall_quantum / length;
    for (std::size_t w = 0; w < sums_.size(); ++w) {
      loads_[w].force = mean * cast<double>(sums_[w].force);
      loads_[w].torque = mean * cast<double>(sums_[w].torque);
      loads_[w].work = wall_quantum * static_cast<double>(sums_[w].work);
    }
  }
  /// The sums of the next window begin with what the last step's loads will do in its first half kick.
  void carry_over(Exec& exec, const Buffer<WallEntry>& entries, const Rock& rock, const std::vector<WallPose>& poses) {
    GYRO_EXPECT(entries.size() == entry_carried_over_.size());
    if (with_impulses_) keep_impulses(entries, entry_carried_over_);
    note_impulses(rock, poses);
    for (std::size_t w = 0; w < sums_.size(); ++w) sums_[w] = sum(exec, entries, entry_carried_over_, w);
  }
  /// A window begins: what is carried over into it acts while the walls move as they do in it. A wall is rigid, so the
  /// work follows from the impulse: -(p . v + (l - x x p) . w), p and l the impulses on the wall.
  /// @param poses  at its begin
  void begin_window(const std::vector<WallPose>& poses) {
    for (std::size_t w = 0; w < sums_.size(); ++w) {
      const Vec3d force = cast<double>(sums_[w].force), torque = cast<double>(sums_[w].torque);
      const WallPose& pose = poses[w];
      sums_[w].work =
          -quanta(dot(force, pose.velocity) + dot(torque - cross(pose.origin, force), pose.angular_velocity));
    }
  }
  /// Forgets what has been booked: no time has passed.
  void discard(Exec& exec, const Buffer<WallEntry>& entries) {
    add_up(exec, entries);
    kept_.clear();
  }

  void save(SavedState& to) const {
    to.put("walls/sum", sums_);
    to.put("walls/load", loads_);
  }
  /// @param entries  rows of the wall list
  void restore(const SavedState& from, Index entries) {
    sums_ = from.get<WallSum>("walls/sum", sums_.size());
    loads_ = from.get<WallLoad>("walls/load", loads_.size());
    kept_.clear();
    impulses_.clear();
    Exec::upload(entry_sums_, std::vector<WallSum>(static_cast<std::size_t>(entries)));
    set_entries(entries);
  }

 private:
  static WallSum sum(Exec& exec, const Buffer<WallEntry>& entries, const Buffer<WallSum>& booked, std::size_t wall) {
    return exec.template reduce<WallSum>("book walls", static_cast<Index>(entries.size()),
                                         SumWall{entries.data(), booked.data(), static_cast<Index>(wall)});
  }

  /// Keeps what each entry has booked.
  void keep_impulses(const Buffer<WallEntry>& entries, const Buffer<WallSum>& booked) {
    const auto& entry = Exec::host(entries);
    const auto& sums = Exec::host(booked);
    for (std::size_t n = 0; n < entry.size(); ++n) {
      const WallSum& s = sums[n];
      if (s.force.x != 0 || s.force.y != 0 || s.force.z != 0 || s.slip != 0)
        kept_.push_back({entry[n].particle, entry[n].wall, s});
    }
  }

  /// Notes what was kept at the present positions of its particles, in the frames of the walls: so the times at which
  /// lists were rebuilt change nothing. Ordered by the particles' ids, as sums of them must be.
  void note_impulses(const Rock& rock, const std::vector<WallPose>& poses) {
    if (kept_.empty()) return;
    const auto& position = Exec::host(rock.position);
    const auto& ids = Exec::host(rock.id);
    const auto key = [&](const KeptImpulse& k) { return std::pair{ids[static_cast<std::size_t>(k.particle)], k.wall}; };
    std::sort(kept_.begin(), kept_.end(), [&](const KeptImpulse& a, const KeptImpulse& b) { return key(a) < key(b); });
    for (auto k = kept_.begin(); k != kept_.end();) {
      const KeptImpulse first = *k;
      WallSum sum;
      for (; k != kept_.end() && key(*k) == key(first); ++k) sum = sum + k->sum;
      const WallPose& pose = poses[static_cast<std::size_t>(first.wall)];
      const Sphere& sphere = position[static_cast<std::size_t>(first.particle)];
      impulses_.push_back({first.wall, to_body(pose, sphere.x), sphere.radius,
                           rotate_back(pose.orientation, wall_quantum * cast<double>(sum.force)),
                           wall_quantum * static_cast<double>(sum.slip)});
    }
    kept_.clear();
  }

  struct KeptImpulse {
    Index particle, wall;
    WallSum sum;
  };

  bool with_impulses_;
  Buffer<WallSum> entry_sums_, entry_carried_over_;  ///< one a row of the wall list
  std::vector<WallSum> sums_;      ///< of the window so far, one a wall; between windows what is left of the last step
  std::vector<WallLoad> loads_;    ///< of the last window, one a wall
  std::vector<KeptImpulse> kept_;  ///< of this window so far
  std::vector<WallImpulse> impulses_;  ///< since they were last taken
};

}  // namespace gyro

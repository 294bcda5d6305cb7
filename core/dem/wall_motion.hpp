// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/base/saved_state.hpp"
#include "core/dem/wall_surfaces.hpp"
#include "core/kernels/enter_step.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/scene/window.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace gyro {

/// Owns the walls: their surfaces, and where they stand in each step of a window. All poses of a window are known
/// before its first step, so that nothing inside it waits for the host.
template <class Exec>
class WallMotion {
 public:
  /// Poses as at time 0. @throws BadInput for a shape that cannot be used
  explicit WallMotion(const std::vector<Wall>& walls) : surfaces_(walls) {
    for (const Wall& wall : walls) poses_now_.push_back(pose_of(wall, 0, {}));
  }

  /// Computes the poses of a window. Row k of the table is the end of step k.
  void plan(const std::vector<Wall>& walls, const Window& window, const MantlePath& path) {
    const std::size_t count = walls.size();
    const auto pose_after = [&](int k, std::size_t w) {
      return pose_of(walls[w], static_cast<double>(window.first_step + k) * window.dt, mantle_at(path, k * window.dt));
    };
    table_.resize(count * static_cast<std::size_t>(window.steps + 1));
    for (int k = 0; k <= window.steps; ++k)
      for (std::size_t w = 0; w < count; ++w) table_[static_cast<std::size_t>(k) * count + w] = pose_after(k, w);
    find_fastest(walls, window.dt);
    steps_.clear();
    for (std::size_t w = 0; w < count; ++w) steps_.push_back(step_of(w, table_[w], table_[count + w]));
    upload_table();
    go_to_step(0);
  }

  /// On a device that counts the steps itself (device_steps), what it sees changes by EnterStep instead.
  /// @param step  of the planned window; 0: its begin
  void go_to_step(int step) {
    device_poses_ = device_table_.data() + (Exec::runs_ahead ? 0 : row_of(step) - table_.data());
    poses_now_.assign(row_of(step), row_of(step) + surfaces_.count());
  }
  PoseTable device_steps() {
    return {device_table_.data() + surfaces_.count(), device_table_.data(), surfaces_.count()};
  }

  /// For kernels.
  WallsNow now() const { return {surfaces_.data(), device_poses_, surfaces_.count()}; }
  const std::vector<WallPose>& poses() const { return poses_now_; }
  const std::vector<WallStep>& steps() const { return steps_; }  ///< of each wall
  /// Largest distance that a wall moves in a step, without planes and rotation about a profile's axis [m].
  double largest_step() const { return largest_step_; }
  Index fastest() const { return fastest_; }  ///< the wall that does

  /// The neighbour lists hold until a wall has moved further than these ways [m].
  void store_listed(const std::vector<double>& ways) {
    listed_poses_ = poses_now_;
    listed_ways_ = ways;
  }
  /// Whether one has.
  /// @param early  share of a step by which particles may see walls earlier
  bool moved_too_far(double early) const { return moved_too_far(early, poses_now_.data()); }
  /// The first of the planned steps [from, to] at whose end one will have; `to` + 1 if none will.
  int first_too_far(double early, int from, int to) const {
    while (from <= to && !moved_too_far(early, row_of(from))) ++from;
    return from;
  }

  void save(SavedState& to) const { to.put("walls/pose", poses_now_); }
  /// @throws BadInput as SavedState::get
  void restore(const SavedState& from) {
    const auto walls = static_cast<std::size_t>(surfaces_.count());
    table_ = poses_now_ = from.get<WallPose>("walls/pose", walls);
    Exec::upload(device_table_, table_);
    device_poses_ = device_table_.data();
  }

 private:
  /// Twice the sine of half the angle between two poses: 0 only if the wall has not rotated, but for full turns.
  static double rotated(const WallPose& from, const WallPose& to) {
    const Quatd rotation = to.orientation * conjugate(from.orientation);
    return 2 * norm(Vec3d{rotation.x, rotation.y, rotation.z});
  }
  /// How far the points of a wall move from one pose to another, at most [m].
  double moved(std::size_t wall, const WallPose& from, const WallPose& to) const {
    const double angle = rotated(from, to);
    return norm(to.origin - from.origin) + (angle > 0 ? surfaces_.extent(wall) * 1.6 * angle : 0.0);
  }
  WallStep step_of(std::size_t wall, const WallPose& from, const WallPose& to) const {
    return {moved(wall, from, to), surfaces_.bounded(wall) || !(rotated(from, to) > 0)};
  }
  const WallPose* row_of(int step) const {
    const std::ptrdiff_t walls = surfaces_.count(), row = step * walls;
    GYRO_EXPECT(row >= 0 && row + walls <= static_cast<std::ptrdiff_t>(table_.size()));
    return table_.data() + row;
  }
  /// A device that runs ahead has the row of the step that it is in before those of all steps.
  void upload_table() {
    std::vector<WallPose> rows(table_.begin(), table_.begin() + (Exec::runs_ahead ? surfaces_.count() : 0));
    rows.insert(rows.end(), table_.begin(), table_.end());
    Exec::upload(device_table_, std::move(rows));
  }

  bool moved_too_far(double early, const WallPose* poses) const {
    GYRO_EXPECT(listed_poses_.size() == poses_now_.size() && listed_ways_.size() == steps_.size());
    for (std::size_t w = 0; w < poses_now_.size(); ++w)
      if (moved(w, listed_poses_[w], poses[w]) > listed_ways_[w] - early * steps_[w].way) return true;
    return false;
  }

  /// A motion's speed changes from window to window only.
  void find_fastest(const std::vector<Wall>& walls, double dt) {
    largest_step_ = 0;
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const double moved = dt * sweep_speed(walls[w], surfaces_.extent(w), table_[w]);
      if (moved > largest_step_) largest_step_ = moved, fastest_ = static_cast<Index>(w);
    }
  }

  WallSurfaces<Exec> surfaces_;
  std::vector<WallPose> table_;                            ///< steps + 1 rows of one pose a wall
  typename Exec::template Buffer<WallPose> device_table_;  ///< as upload_table() says
  const WallPose* device_poses_ = nullptr;                 ///< row of this step
  std::vector<WallPose> poses_now_, listed_poses_;
  std::vector<WallStep> steps_;
  std::vector<double> listed_ways_;
  double largest_step_ = 0;
  Index fastest_ = none;
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/state/step_flags.hpp"

namespace gyro {

/// Where the walls stand in each step of a window.
struct PoseTable {
  const WallPose* rows;  ///< one pose a wall; row k is the end of step k
  WallPose* now;         ///< row of the present step, for kernels that do not know which step it is
  Index walls;
};

/// Between the positions of a step and its contact forces, on a device that takes steps while the host does not look:
/// counts the step, brings the walls to its end, and halts the device where the host must act. That is for every flag
/// on which the host acts between two steps; halting once too often costs time and changes nothing.
///
/// A kernel for one item.
struct EnterStep {
  PoseTable walls;
  const StepFlags* flags;
  StepProgress* progress;
  bool limits;           ///< whether an exceeded limit halts: the first of a window does
  std::int32_t stop_at;  ///< step that halts whatever the flags say: the neighbour lists do not hold for it

  GYRO_HD void operator()(Index) const {
    const std::int32_t step = progress->step + 1;
    progress->step = step;
    const WallPose* row = walls.rows + static_cast<std::int64_t>(step) * walls.walls;
    for (Index w = 0; w < walls.walls; ++w) walls.now[w] = row[w];
    const StepFlags raised = *flags;
    if (raised.moved_too_far || raised.block_cracked || (limits && raised.limit_exceeded) || step >= stop_at)
      progress->halted = 1;
  }
};

}  // namespace gyro

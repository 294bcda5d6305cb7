// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"

#include <algorithm>

// The steps of a window on a device that takes them while the host does not look.

namespace gyro {

/// A batch of steps at a time is launched. In each, EnterStep looks at what watch() would look at; where that would
/// act, all further kernels of the batch do nothing, so that the state is the one that watch() sees. The host reads
/// once a batch how far the device came, acts, and goes on from there. In which step a wall will have moved too far is
/// known before the batch starts, which then ends there.
template <class Exec, class Real>
void DemSolver<Exec, Real>::take_steps_ahead(const Window& window) {
  int done = 0;
  while (done < window.steps) {
    ask_whether_given_up(window, done);
    const int wanted = std::min(ahead_.size().steps(), window.steps - done);
    const int stop_at = lists_.valid() ? walls_.first_too_far(walls_seen_early(), done + 1, done + wanted) : done + 1;
    const int end = std::min(done + wanted, stop_at);
    launch_steps(window, {.done = done, .end = end, .stop_at = stop_at});
    const StepProgress reached = ahead_.reached();
    if (reached.halted) {
      walls_.go_to_step(reached.step);
      watch();
      ahead_.go_on_from(reached.step);
      end_step(reached.step == window.steps);
      ahead_.size().halted(reached.step - done);
    } else {
      GYRO_EXPECT(reached.step == end);
      ahead_.size().passed(end - done);
    }
    done = reached.step;
  }
  walls_.go_to_step(window.steps);
}

/// Steps between the first and the last of a window have the same arguments. Of a step for which the lists do not hold,
/// the contact forces are left to the host.
template <class Exec, class Real>
void DemSolver<Exec, Real>::launch_steps(const Window& window, const Batch& batch) {
  const EnterStep enter{.walls = walls_.device_steps(),
                        .flags = monitor_.flags(),
                        .progress = ahead_.progress(),
                        .limits = !monitor_.has_excess(),
                        .stop_at = batch.stop_at};
  for (int done = batch.done; done < batch.end;) {
    const bool last = done + 1 == window.steps, stops = done + 1 == batch.stop_at;
    const int end_of_alike = std::min({batch.end, window.steps - 1, batch.stop_at - 1});
    const int alike = done == 0 ? 1 : std::max(1, end_of_alike - done);
    exec_.repeat(alike, ahead_.halted(), [&] {
      begin_step(window, done, done == 0);
      exec_.for_each("enter step", 1, enter);
      if (!stops) end_step(last);
    });
    done += alike;
  }
}

}  // namespace gyro

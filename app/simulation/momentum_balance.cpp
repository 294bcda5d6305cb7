// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/momentum_balance.hpp"

namespace gyro {

void MomentumBalance::close(const Vec3d& momentum, std::span<const Vec3d> impulses) {
  state_.residual += momentum - state_.before;
  for (const Vec3d& impulse : impulses) {
    state_.residual = state_.residual - impulse;
    state_.turnover += norm(impulse);
  }
  state_.before = momentum;
}

}  // namespace gyro

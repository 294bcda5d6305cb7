// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/momentum_balance.hpp"

#include <vector>

namespace gyro {

void MomentumBalance::close(const Vec3d& momentum, std::span<const Vec3d> impulses) {
  residual_ += momentum - before_;
  for (const Vec3d& impulse : impulses) {
    residual_ = residual_ - impulse;
    turnover_ += norm(impulse);
  }
  before_ = momentum;
}

void MomentumBalance::save(SavedState& to) const {
  to.put("ledger/momentum",
         std::vector<double>{before_.x, before_.y, before_.z, residual_.x, residual_.y, residual_.z, turnover_});
}

void MomentumBalance::restore(const SavedState& from) {
  const std::vector<double> m = from.get<double>("ledger/momentum", 7);
  before_ = {m[0], m[1], m[2]};
  residual_ = {m[3], m[4], m[5]};
  turnover_ = m[6];
}

}  // namespace gyro

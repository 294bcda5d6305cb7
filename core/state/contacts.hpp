// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/laws/contact/contact.hpp"

namespace gyro {

/// Notes contacts that are pressed in too deep.
struct OverlapCheck {
  double limit;                  ///< overlap / radius [-]
  std::int32_t* limit_exceeded;  ///< set to 1 by any contact beyond it

  GYRO_HD void check_overlap(double overlap, double radius) const {
    if (overlap > limit * radius) raise_flag(limit_exceeded);
  }
};

/// Two particles near each other. The one with the lower id is i, so that a pair is evaluated the
/// same way whatever the order of the arrays.
struct Pair {
  Index i, j;
  Index bond;  ///< bond of the same two particles, or none: while it holds, the pair is no contact
};

/// Result of a pair for this step.
template <class Real>
struct PairResult {
  Vec3<Real> force;               ///< on i; j receives the opposite [N]
  Vec3<Real> torque_i, torque_j;  ///< [N m]
  Real damped, slipped;           ///< work lost in this step [J]
};

/// One end of a pair, in the row of a particle.
struct PairEnd {
  Index pair;
  std::int32_t side;  ///< 0: the particle is i; 1: it is j
};

/// Neighbour lists as kernels see them. Rows of ends are ordered by the partner's id.
template <class Real>
struct PairView {
  Pair* pairs;
  ContactHistory<Real>* history;  ///< zero while the pair does not touch
  ExtraHistory<Real>* extra;      ///< likewise; null unless the contact law keeps it
  PairResult<Real>* result;
  std::int8_t* touching;
  Index* row_begin;  ///< per particle, into ends; one past the end at the last
  PairEnd* ends;
  Index count;
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/base/shared_counter.hpp"
#include "core/laws/contact/contact.hpp"
#include "core/state/columns.hpp"

namespace gyro {

/// Raises a flag for contacts whose overlap exceeds the limit.
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

  template <class F, class... P>
  static constexpr void for_each_field(F&& f, P&... p) {
    f("i", p.i...);
    f("j", p.j...);
    f("bond", p.bond...);
  }
};
static_assert(declares_every_field<Pair>);

/// What a pair does to one of its particles in this step. Work that the pair loses is booked at i.
template <class Real>
struct alignas(8 * sizeof(Real)) EndLoad {
  Vec3<Real> force;      ///< [N]
  Vec3<Real> torque;     ///< [N m]
  Real damped, slipped;  ///< work lost in this step [J]
};

/// One end of a pair, in the row of a particle.
struct PairEnd {
  Index pair;
  std::int32_t side;  ///< 0: the particle is i; 1: it is j
};

/// Where the two ends of a pair stand in the rows of its particles.
struct PairEnds {
  Index i, j;
};

/// Columns of the pair list: pairs of particles whose close bounds overlap.
template <template <class> class Column, class Real>
struct Pairs {
  Column<Pair> pair;
  Column<ContactHistory<Real>> history;  ///< zero while the pair does not touch
  Column<ExtraHistory<Real>> extra;      ///< likewise; empty unless the contact law keeps it
  Column<std::int8_t> touching;          ///< 1: in contact in this step
  Column<PairEnds> at;                   ///< into ends
  Column<Index> row_begin;               ///< per particle, into ends; one past the end at the last
  Column<PairEnd> ends;                  ///< rows ordered by the partner's id
  Column<EndLoad<Real>> load;            ///< of each end: a particle's loads lie side by side
  Column<std::int8_t> loaded;            ///< of each end, 1: its pair is in contact in this step
  Column<Real> dashpot;                  ///< of each end: ContactLoad::dashpot of its pair [N s/m]

  template <class F, class... P>
  static constexpr void for_each_column(F&& f, P&... p) {
    f("pair", p.pair...);
    f("history", p.history...);
    f("extra", p.extra...);
    f("touching", p.touching...);
    f("at", p.at...);
    f("row_begin", p.row_begin...);
    f("ends", p.ends...);
    f("load", p.load...);
    f("loaded", p.loaded...);
    f("dashpot", p.dashpot...);
  }
};

template <class Real>
using PairView = Pairs<Pointer, Real>;
template <class Real>
using ConstPairView = Pairs<ConstPointer, Real>;
static_assert(declares_every_column<PairView<float>>());

}  // namespace gyro

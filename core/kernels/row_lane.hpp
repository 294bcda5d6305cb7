// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/particle_row.hpp"

namespace gyro {

/// Something of both particles of a pair.
template <class T>
struct TwoEnds {
  T i, j;
};

/// What the lanes of pairs (pair_lane.hpp) and of walls (wall_lane.hpp) have in common: how one row of a list reads the
/// columns of its particles. For a GPU thread and for tests; PackOfRows (row_pack.hpp) is N rows.
struct OneRow {
  template <class T>
  using Number = T;
  static constexpr int count = 1;
  Index n;

  template <class Struct>
  GYRO_HD Index index(const Struct* column, Index Struct::*member) const {
    return column[n].*member;
  }
  /// Members i and j of a row.
  template <class Struct>
  GYRO_HD TwoEnds<Index> both_ends(const Struct* column) const {
    return {column[n].i, column[n].j};
  }
  GYRO_HD double at(const double* column, Index particle) const { return column[particle]; }
  template <class Row>
  GYRO_HD ParticleRow<double> row(const Row* rows, Index particle) const {
    return row_of(rows[particle]);
  }
  template <class Struct>
  GYRO_HD void store(Struct* column, const Struct& value) const {
    column[n] = value;
  }
  GYRO_HD bool any(bool m) const { return m; }
};

}  // namespace gyro

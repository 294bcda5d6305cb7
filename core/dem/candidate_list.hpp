// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/cell_grid.hpp"
#include "core/kernels/neighbours.hpp"

#include <string>

namespace gyro {

/// Owns the pairs of particles that may touch while they stay in their wide bounds: what pairs are chosen from.
template <class Exec>
class CandidateList {
 public:
  /// For kernels.
  CandidateTable table() { return {room_, count_.data(), partner_.data(), long_begin_.data(), long_partner_.data()}; }

  /// @param bounds  wide bounds of all particles
  /// @throws StoppedByGuard when particles crowd or there are more candidates than pairs can be numbered
  template <class Real>
  void find(Exec& exec, const ParticleStore<Exec, Real>& rock, const Sphere* bounds) {
    cells_.build(exec, rock, bounds);
    const Index particles = rock.count();
    const CandidateCount found = fill_rows(exec, rock, bounds);
    expect_few(found.total);
    Exec::renew(long_partner_, static_cast<std::size_t>(found.in_long));
    if (found.in_long > 0) {
      long_begin_.resize(static_cast<std::size_t>(particles) + 1);
      exec.for_each("find candidates", particles, LongLength{table()});
      exec.exclusive_scan(particles, long_begin_.data());
      exec.for_each("find candidates", particles, search(rock, bounds, true));
    }
    cells_.release();
  }

 private:
  template <class Real>
  FindCandidates search(const ParticleStore<Exec, Real>& rock, const Sphere* bounds, bool fills_long) {
    return {rock.read(), cells_.grid(), rock.bond_index(), bounds, table(), fills_long};
  }

  /// Rows have room for half as many again as there are on average.
  template <class Real>
  CandidateCount fill_rows(Exec& exec, const ParticleStore<Exec, Real>& rock, const Sphere* bounds) {
    const Index particles = rock.count();
    const auto fill = [&](Index room) {
      room_ = room;
      Exec::renew(count_, static_cast<std::size_t>(particles));
      Exec::renew(partner_, static_cast<std::size_t>(particles) * static_cast<std::size_t>(room_));
      exec.for_each("find candidates", particles, search(rock, bounds, false));
      return exec.template reduce<CandidateCount>("count candidates", particles, CandidateCountOf{table()});
    };
    const CandidateCount found = fill(room_);
    const auto wanted = static_cast<Index>(smaller(1.5 * static_cast<double>(found.total) / (particles + 1), 1e6)) + 4;
    const bool too_small = 4 * found.in_long > found.total, too_large = room_ > 2 * wanted;
    return too_small || too_large ? fill(wanted) : found;
  }

  static void expect_few(std::int64_t total) {
    constexpr std::int64_t maximum = 1'000'000'000;  // each has two ends, which are numbered too
    if (total > maximum)
      throw StoppedByGuard(std::to_string(total) + " pairs of particles are near each other; at most " +
                           std::to_string(maximum) + " can be listed");
  }

  CellGrid<Exec> cells_;
  Index room_ = 4;  ///< as of bonded rock that has not met any other; it grows
  typename Exec::template Buffer<Index> count_, partner_, long_begin_, long_partner_;
};

}  // namespace gyro

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
  CandidateTable table() { return {room_, count_.data(), partner_.data()}; }

  /// @param bounds  wide bounds of all particles
  /// @throws StoppedByGuard when particles crowd or there are more candidates than pairs can be numbered
  template <class Real>
  void find(Exec& exec, const ParticleStore<Exec, Real>& rock, const Sphere* bounds) {
    cells_.build(exec, rock, bounds);
    for (;;) {
      const auto rows = static_cast<std::size_t>(rock.count());
      Exec::renew(count_, rows);
      Exec::renew(partner_, rows * static_cast<std::size_t>(room_));
      const FindCandidates kernel{rock.read(), cells_.grid(), rock.bond_index(), bounds, table()};
      exec.for_each("find candidates", rock.count(), kernel);
      const CandidateCount found =
          exec.template reduce<CandidateCount>("count candidates", rock.count(), CandidateCountOf{count_.data()});
      expect_few(found.total);
      if (found.longest <= room_) return cells_.release();
      room_ = found.longest + found.longest / 4;
    }
  }

 private:
  static void expect_few(std::int64_t total) {
    constexpr std::int64_t maximum = 1'000'000'000;  // each has two ends, which are numbered too
    if (total > maximum)
      throw StoppedByGuard(std::to_string(total) + " pairs of particles are near each other; at most " +
                           std::to_string(maximum) + " can be listed");
  }

  CellGrid<Exec> cells_;
  Index room_ = 4;  ///< as of bonded rock that has not met any other; it grows
  typename Exec::template Buffer<Index> count_, partner_;
};

}  // namespace gyro

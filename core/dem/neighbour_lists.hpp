// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/pair_list.hpp"
#include "core/dem/wall_list.hpp"

namespace gyro {

/// Owns the neighbour lists: pairs of particles, and particles near walls, each with its contact history. They only say
/// who may touch: when they are rebuilt, and with which skin, changes no bit of a result.
template <class Exec, class Real>
class NeighbourLists {
 public:
  using Store = ParticleStore<Exec, Real>;

  /// @param skin  distance up to which neighbours are listed [m]; 0: 0.8 times the smallest radius
  /// @param pair_extra, wall_extra  whether the contact laws keep ExtraHistory
  NeighbourLists(double skin, bool pair_extra, bool wall_extra)
      : given_skin_(skin), pairs_(pair_extra), walls_(wall_extra) {
    extend(0);
  }

  PairList<Exec, Real>& pairs() { return pairs_; }
  const PairList<Exec, Real>& pairs() const { return pairs_; }
  WallList<Exec, Real>& walls() { return walls_; }
  const WallList<Exec, Real>& walls() const { return walls_; }

  /// False: they must be rebuilt before the next forces, whatever has moved.
  bool valid() const { return valid_; }
  double skin() const { return skin_; }                        ///< when they were built [m]
  double allowed_distance() const { return 0.5 * skin_; }      ///< that a particle or wall may move meanwhile [m]
  double smallest_radius() const { return smallest_radius_; }  ///< of the particles when they were built, 0: none [m]

  /// @throws StoppedByGuard when particles crowd or there are too many pairs
  void rebuild(Exec& exec, Store& rock, const WallsNow& walls) {
    const Extent extent = exec.template reduce<Extent>("extent", rock.count(), ExtentOf{rock.read()});
    smallest_radius_ = rock.count() > 0 ? extent.smallest : 0;
    skin_ = given_skin_ > 0 ? given_skin_ : 0.8 * extent.smallest;
    cells_.build(exec, rock, extent, skin_);
    pairs_.find(exec, rock, cells_.grid(), skin_);
    walls_.find(exec, rock, walls, skin_);
    exec.for_each("store positions", rock.count(), StorePositions{rock.view()});
    valid_ = true;
  }

  /// Particles have come: empty rows for them, until the lists are rebuilt.
  void extend(Index particles) {
    pairs_.extend_rows(particles);
    walls_.extend_rows(particles);
    valid_ = false;
  }
  /// Particles have left.
  void keep(const Remaining& remaining) {
    pairs_.keep(remaining);
    walls_.keep(remaining);
    valid_ = false;
  }

  void save(SavedState& to) const {
    pairs_.save(to);
    walls_.save(to);
  }
  /// Lists of what touches only: the next step finds the neighbours and carries the history over.
  void restore(Exec& exec, const SavedState& from, const Store& rock) {
    pairs_.restore(exec, from, rock);
    walls_.restore(from, rock.count());
    valid_ = false;
  }

 private:
  double given_skin_, skin_ = 0, smallest_radius_ = 0;
  bool valid_ = false;
  CellGrid<Exec> cells_;
  PairList<Exec, Real> pairs_;
  WallList<Exec, Real> walls_;
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/pair_list.hpp"
#include "core/dem/wall_list.hpp"

namespace gyro {

/// Owns the neighbour lists: pairs of particles, and particles near walls, each with its contact history. They only say
/// who may touch: when they are made, and how far particles may go meanwhile, changes no bit of a result.
///
/// There are two stages. Candidates and walls are sought in space and hold as long as all particles stay in their wide
/// bounds, for some hundred steps. Pairs, which every step looks at, are chosen among the candidates and hold as long
/// as all particles stay in their close bounds, for some ten steps (steps_of_lists).
template <class Exec, class Real>
class NeighbourLists {
 public:
  using Store = ParticleStore<Exec, Real>;

  /// @param way  that particles may go until candidates are sought again [m]; 0: by their speed
  /// @param pair_extra, wall_extra  whether the contact laws keep ExtraHistory
  NeighbourLists(double way, bool pair_extra, bool wall_extra)
      : given_way_(way), pairs_(pair_extra), walls_(wall_extra) {
    extend(0);
  }

  PairList<Exec, Real>& pairs() { return pairs_; }
  const PairList<Exec, Real>& pairs() const { return pairs_; }
  WallList<Exec, Real>& walls() { return walls_; }
  const WallList<Exec, Real>& walls() const { return walls_; }

  /// False: they must be rebuilt before the next forces, whatever has moved.
  bool valid() const { return valid_; }
  const Sphere* bounds() const { return close_.data(); }  ///< close ones, of all particles
  /// How far each wall may move until the next rebuild [m].
  const std::vector<double>& wall_ways() const { return wall_ways_; }
  double smallest_radius() const { return smallest_radius_; }  ///< of the particles at the last rebuild, 0: none [m]

  /// Seeks candidates, pairs and walls.
  /// @param dt          step of the scene [s]
  /// @param wall_steps  of each wall
  /// @throws StoppedByGuard when particles crowd or there are too many pairs
  void rebuild(Exec& exec, Store& rock, const WallsNow& walls, double dt, const std::vector<WallStep>& wall_steps) {
    const Index particles = rock.count();
    look_at(exec.template reduce<Flock>("sum speeds", particles, FlockOf{rock.read()}), particles, dt);
    set_wall_ways(wall_steps);
    wide_.resize(static_cast<std::size_t>(particles));
    exec.for_each("wide bounds", particles, SetWideBounds{rock.read(), dt, wide_ways(dt), wide_.data()});
    exec.for_each("list bonded pairs", static_cast<Index>(rock.blocks().size()), ListBonded{rock.block_view()});
    candidates_.find(exec, rock, wide_.data());
    walls_.find(exec, rock, walls, wide_.data(), device_wall_ways_.data());
    choose_pairs(exec, rock, dt);
    valid_ = true;
  }

  /// Chooses the pairs again.
  /// @return whether the candidates leave room for that
  bool renew_pairs(Exec& exec, Store& rock, double dt) {
    constexpr double enough = 0.5;
    const Room room = exec.template reduce<Room>("room in bounds", rock.count(), RoomIn{close_bounds(rock, dt)});
    if (room.smallest < enough) return false;
    choose_pairs(exec, rock, dt);
    return true;
  }

  /// Particles have come: empty rows for them, until the lists are rebuilt.
  void extend(Index particles) {
    pairs_.extend_rows(particles);
    walls_.extend_rows(particles);
    invalidate(particles);
  }
  /// Particles have left, or others have taken their places.
  void rearrange(const NewPlaces& places) {
    pairs_.rearrange(places);
    walls_.rearrange(places);
    invalidate(static_cast<Index>(places.old_index.size()));
  }

  void save(SavedState& to) const {
    pairs_.save(to);
    walls_.save(to);
  }
  /// Lists of what touches only: the next step finds the neighbours and carries the history over.
  void restore(Exec& exec, const SavedState& from, const Store& rock) {
    pairs_.restore(exec, from, rock);
    walls_.restore(from, rock.count());
    invalidate(rock.count());
  }

 private:
  static constexpr double max_way = 4;  ///< of a wide bound over radius, and of a wall over the mean radius [-]

  Ways wide_ways(double dt) const { return {steps_.wide * dt, speed_, 0.1, max_way, given_way_}; }
  Ways close_ways(double dt) const { return {steps_.close * dt, speed_, 0.01, 1, 0}; }

  void look_at(const Flock& flock, Index particles, double dt) {
    if (particles == 0) return;
    smallest_radius_ = flock.smallest;
    mean_radius_ = particles / flock.curvature;
    speed_ = std::sqrt(flock.speed2 / particles);
    steps_ = steps_of_lists(dt * (flock.radii_in_time / particles + speed_ / mean_radius_));
  }

  /// A wall that moves by more than some radii in a step makes the lists stale in each; one without bounds may move as
  /// far as in any step, and is listed for all particles. Particles with sub-steps see walls half a step earlier, which
  /// is less than any way.
  void set_wall_ways(const std::vector<WallStep>& wall_steps) {
    wall_ways_.clear();
    for (const WallStep& step : wall_steps) {
      const double expected = (steps_.wide + 1) * step.way;
      const double wanted = given_way_ > 0 ? given_way_
                            : step.bounded ? smaller(expected, max_way * mean_radius_)
                                           : expected;
      wall_ways_.push_back(larger(wanted, step.way));
    }
    Exec::upload(device_wall_ways_, wall_ways_);
  }
  SetCloseBounds close_bounds(const Store& rock, double dt) {
    return {rock.read(), dt, close_ways(dt), wide_.data(), close_.data()};
  }

  void choose_pairs(Exec& exec, Store& rock, double dt) {
    close_.resize(static_cast<std::size_t>(rock.count()));
    exec.for_each("close bounds", rock.count(), close_bounds(rock, dt));
    pairs_.find(exec, rock, candidates_.table(), close_.data());
  }

  void invalidate(Index particles) {
    close_.resize(static_cast<std::size_t>(particles));  // the next step compares with whatever they are
    valid_ = false;
  }

  double given_way_;
  double smallest_radius_ = 0, mean_radius_ = 0;  ///< at the last rebuild; the mean is harmonic [m]
  double speed_ = 0;                              ///< root mean square of all particles then [m/s]
  ListSteps steps_{400, 60};
  std::vector<double> wall_ways_;
  typename Exec::template Buffer<double> device_wall_ways_;
  bool valid_ = false;
  typename Exec::template Buffer<Sphere> wide_, close_;  ///< bounds of all particles
  CandidateList<Exec> candidates_;
  PairList<Exec, Real> pairs_;
  WallList<Exec, Real> walls_;
};

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/wall_surfaces.hpp"
#include "core/kernels/accounts.hpp"
#include "core/kernels/gather.hpp"
#include "core/kernels/move.hpp"
#include "core/kernels/neighbours.hpp"
#include "core/kernels/pair_forces.hpp"
#include "core/kernels/wall_lists.hpp"
#include "core/laws/contact/constants.hpp"
#include "core/scene/dem.hpp"

namespace gyro {

/// The discrete element method on an executor (Cpu, Cuda), with the loads in Real. A step is in
/// dem_step.hpp, the neighbour lists in dem_lists.hpp, coming and going of rock in dem_exchange.hpp and
/// dem_removal.hpp, the accounts and snapshots in dem_accounts.hpp, the saved state in dem_saving.hpp. Nothing
/// here reads an element of a buffer: kernels do, or host copies.
template <class Exec, class Real>
class DemSolver final : public Dem {
 public:
  DemSolver(Scene scene, Exec exec);

  void insert(std::span<const NewRock> rocks) override;
  void remove(std::span<const ParticleId> ids) override;
  void advance(const Window& window, const MantlePath& path) override;

  std::vector<WallPose> wall_poses() const override { return poses_now_; }
  std::vector<WallLoad> wall_loads() const override { return wall_loads_; }
  EnergyTerms energy() const override;
  Extremes extremes() const override;
  Counts counts() const override;
  Vec3d momentum() const override;
  ParticleSnapshot particles() const override;
  BondSnapshot bonds() const override;
  std::vector<Breakage> take_breakages() override { return std::exchange(breakages_, {}); }
  std::vector<WallImpulse> take_wall_impulses() override { return std::exchange(impulses_, {}); }
  std::vector<std::pair<std::string, double>> phase_seconds() const override { return exec_.timer().seconds(); }
  SavedState save() const override;
  void restore(const SavedState& saved) override;

 private:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;
  template <class T>
  using Host = std::vector<T>;

  /// Neighbour lists: two of each, so that memory is carried from the old to the new.
  struct PairLists {
    Buffer<Pair> pairs;
    Buffer<ContactHistory<Real>> history;
    Buffer<PairResult<Real>> result;
    Buffer<std::int8_t> touching;
    Buffer<Index> row_begin;
    Buffer<PairEnd> ends;
  };
  struct WallLists {
    Buffer<WallEntry> entries;
    Buffer<WallHistory<Real>> history;
    Buffer<WallResult<Real>> result;
    Buffer<std::int8_t> touching;
    Buffer<WallSum> sums, carried_over;
    Buffer<Index> row_begin;
  };

  // dem_step.hpp
  void place_walls(const Window& window, const MantlePath& path);
  void prime();
  void step(std::int64_t number, bool first_of_hold, bool closing);
  void move();
  void bond_forces(std::int64_t number);
  void contact_forces(double half_hold_offset, double carry_over);
  template <bool held>
  void launch_contacts(double half_hold_offset, double carry_over);
  void gather(bool first_of_hold, bool kick);
  bool neighbours_stale(const Host<std::int32_t>& flags) const;
  void record_excess();
  void close_window(const Window& window);

  // dem_lists.hpp
  void rebuild_lists();
  Grid make_grid();
  void sort_into_cells(Grid& grid);
  void expect_no_crowd(const Grid& grid) const;
  FindPairs pair_finder(const Grid& grid) const;
  Index count_pairs(const Grid& grid);
  void list_pairs(const Grid& grid, Index count);
  void list_ends();
  void list_walls();
  void book_walls();
  void carry_over_walls();
  void keep_impulses(const Buffer<WallSum>& booked);
  void note_impulses();

  /// Rock on its way in, on the host.
  struct Arrivals {
    Particles<Host> particles;
    Bonds<Host, Real> bonds;
    Host<Block> blocks;
    Host<Index> colour_begin;
    std::int64_t bonds_intact = 0;
    double exchanged = 0;  ///< EnergyTerms::exchanged with the new rock [J]
  };
  /// Particles that stay: new place of every particle, or none; old place of those that stay.
  struct Remaining {
    Host<Index> new_index, old_index;
  };

  /// Bonds that hold: their places, and their ends as rows of a snapshot.
  struct IntactBonds {
    Host<std::size_t> bond;
    Host<Index> i, j;
  };

  // dem_exchange.hpp
  void arrive(const NewRock& rock, Arrivals& first_of_hold) const;
  void arrive_bonds(const NewRock& rock, Index first_particle, Arrivals& first_of_hold) const;
  void take_in(const Arrivals& first_of_hold);
  void index_bonds();
  void resize_rows();

  // dem_removal.hpp
  Remaining without(std::span<const ParticleId> ids) const;
  void keep_particles(const Remaining& remaining);
  void keep_bonds(const Remaining& remaining);
  void keep_pairs(const Remaining& remaining);
  void keep_walls(const Remaining& remaining);

  // dem_accounts.hpp
  ParticleSums particle_sums() const;
  ContactSums contact_sums() const;
  BondSums bond_sums() const;
  Extremes extremes_now(bool with_bonds) const;
  void drain_breakages(const Window& window);
  std::vector<Index> rows_by_id() const;
  IntactBonds intact_bonds() const;

  // dem_saving.hpp
  void save_pairs(SavedState& s) const;
  void save_walls(SavedState& s) const;
  void restore_pairs(const SavedState& s);
  void restore_walls(const SavedState& s);

  ParticleView view() const;
  BlockList block_list() const;
  BondView<Real> bond_view() const;
  PairView<Real> pair_view(const PairLists& lists) const;
  WallView<Real> wall_view(const WallLists& lists) const;
  BondLaw<Real> bond_law() const;
  double half_hold_offset() const { return 0.5 * (scene_.substeps - 1) * scene_.dt; }  ///< to the middle of a hold [s]
  double carry_over_fraction() const {
    return 0.5 / scene_.substeps;
  }  ///< share of a hold in the next window's first half kick
  double hold_time() const { return scene_.substeps * scene_.dt; }  ///< [s]
  Index particle_count() const { return static_cast<Index>(particles_.position.size()); }
  bool has_bonds() const { return scene_.bonds.has_value(); }

  Scene scene_;
  mutable Exec exec_;
  ContactConstants<Real> rock_law_;
  Buffer<ContactConstants<Real>> wall_laws_;
  ContactModel rock_model_, wall_model_;
  WallSurfaces<Exec> surfaces_;

  Particles<Buffer> particles_;
  Bonds<Buffer, Real> bonds_;
  Buffer<Block> blocks_;
  Buffer<Index> colour_begin_;
  Buffer<Index> bond_row_begin_, bond_row_;
  Buffer<Load> held_;  ///< contact and wall forces of the present hold; empty when a hold is one step
  Buffer<BreakEvent> events_;
  static constexpr std::size_t flag_count = 4;
  Buffer<std::int32_t> flags_;  ///< stale, relist, number of events, a limit passed

  PairLists pairs_, old_pairs_;
  WallLists walls_, old_walls_;
  Buffer<std::uint64_t> cell_keys_;
  Buffer<Index> cell_sorted_, cell_begin_, counts_;
  Buffer<std::int32_t> end_counts_;

  Buffer<WallPose> pose_table_;      ///< steps + 1 rows of one pose a wall
  const WallPose* poses_ = nullptr;  ///< row of this step
  std::vector<WallPose> host_table_, poses_now_, listed_poses_, end_poses_;
  double skin_ = 0;
  bool listed_ = false, primed_ = false;

  std::vector<WallSum> wall_sums_;  ///< of the window so far, one a wall; between windows what is left of the last step
  std::vector<WallLoad> wall_loads_;
  std::optional<Extremes> first_excess_;  ///< of the first step of the window that passed a limit
  double wall_step_ = 0;                  ///< largest way of a wall in a step of the window [m]
  Index fast_wall_ = none;
  double smallest_radius_ = 0;  ///< of the particles when lists were built [m]
  EnergyTerms booked_;          ///< of what has left, and what events and walls added
  Counts counts_total_;
  std::vector<Breakage> breakages_;
  struct KeptImpulse {
    Index particle, wall;
    WallSum sum;
  };
  std::vector<KeptImpulse> kept_impulses_;  ///< of this window so far
  std::vector<WallImpulse> impulses_;
};

}  // namespace gyro

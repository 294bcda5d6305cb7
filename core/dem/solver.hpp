// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/monitor.hpp"
#include "core/dem/rigid_rocks.hpp"
#include "core/dem/scene_sums.hpp"
#include "core/dem/snapshots.hpp"
#include "core/dem/steps_ahead.hpp"
#include "core/dem/wall_accounts.hpp"
#include "core/dem/wall_motion.hpp"
#include "core/kernels/advance_rocks.hpp"
#include "core/kernels/pair_forces.hpp"
#include "core/scene/dem.hpp"

#include <string>
#include <utility>

namespace gyro {

/// The discrete element method on an executor (Cpu, Cuda), with the loads in Real: the order of a step and of a window.
/// Each part owns its data; nothing here reads an element of a buffer.
template <class Exec, class Real>
class DemSolver final : public Dem {
 public:
  DemSolver(Scene scene, Exec exec)
      : scene_(std::move(scene)),
        exec_(std::move(exec)),
        laws_(scene_),
        rock_(scene_.bonds.has_value(), scene_.rigid.has_value(), scene_.rigid && scene_.rigid->response_of),
        rigid_(scene_),
        lists_(0.5 * scene_.neighbour_skin, keeps_extra_history(laws_.rock_model()),
               keeps_extra_history(laws_.wall_model())),
        walls_(scene_.walls),
        accounts_(scene_.walls.size(), scene_.wall_impulses),
        ahead_(exec_) {
    if (Exec::runs_ahead && scene_.rigid)
      throw BadInput("rocks that move as rigid bodies are computed on the CPU only");
  }

  void insert(std::span<const NewRock> rocks) override;
  void remove(std::span<const ParticleId> ids) override;
  void advance(const Window& window, const MantlePath& path) override;

  void give_up_when(GiveUp condition) override { give_up_ = std::move(condition); }

  std::vector<WallPose> wall_poses() const override { return walls_.poses(); }
  std::vector<WallLoad> wall_loads() const override { return accounts_.loads(); }
  EnergyTerms energy() const override { return sums().energy(monitor_.energies()); }
  Extremes extremes() const override { return extremes(sums().particles(), sums().contacts()); }
  Balance balance() const override;
  Counts counts() const override;
  Vec3d momentum() const override { return sums().particles().momentum; }
  ParticleSnapshot particles() const override { return particle_snapshot(exec_, rock_, scene_.gravity); }
  BondSnapshot bonds() const override { return bond_snapshot(exec_, rock_, laws_); }
  std::vector<Breakage> take_breakages() override { return monitor_.take_breakages(); }
  std::vector<WallImpulse> take_wall_impulses() override { return accounts_.take_impulses(); }
  std::vector<std::pair<std::string, double>> phase_seconds() const override { return exec_.timer().seconds(); }
  std::vector<std::pair<std::string, std::int64_t>> traffic() const override { return exec_.traffic(); }
  SavedState save() const override;
  void restore(const SavedState& saved) override;

 private:
  struct Advance;
  struct Batch {
    int done, end;  ///< steps of a window (done, end]
    int stop_at;    ///< as EnterStep::stop_at
  };
  void take_steps(const Window& window);
  void take_steps_ahead(const Window& window);
  void launch_steps(const Window& window, const Batch& batch);
  void ask_whether_given_up(const Window& window, int done) const;
  static std::int64_t step_number(const Window& window, int done);
  void begin_step(const Window& window, int done, bool together);
  void meet(const Window& window, int done);
  void change_levels(const Window& window);
  void divide_rocks();
  void advance_rigid_rocks(bool new_forces, bool look);
  void end_step(bool last_of_window);
  void advance_rocks(const Advance& what);
  template <class Kernel>
  void advance_large_rock(const LargeRock& rock, Kernel kernel);
  Move move();
  Gather<Real> gather();
  void finish_step(bool kick);
  void watch();
  void rebuild_lists();
  template <bool held>
  void contact_forces(bool last_of_window);
  void prime();
  void close_window(const Window& window);
  void keep_excess();
  Extremes extremes(const ParticleSums& particles, const ContactSums& contacts) const;

  SceneSums<Exec, Real> sums() const { return {exec_, scene_, laws_, rock_, lists_, walls_.now()}; }
  typename WallAccounts<Exec>::Rock where_rock_is() const { return {rock_.particles().position, rock_.particles().id}; }
  /// Share of a step by which particles with sub-steps see walls earlier.
  double walls_seen_early() const { return held() ? 0.5 : 0; }
  bool held() const { return rock_.max_substeps() > 1; }  ///< contact and wall forces, over sub-steps of some rock

  /// Rocks change their level where the host looks after each step.
  static constexpr bool has_levels = !Exec::runs_ahead;

  Scene scene_;
  mutable Exec exec_;  ///< kernels that only read change nothing but its timers
  SceneLaws<Exec, Real> laws_;
  ParticleStore<Exec, Real> rock_;
  RigidRocks<Exec, Real> rigid_;
  NeighbourLists<Exec, Real> lists_;
  WallMotion<Exec> walls_;
  WallAccounts<Exec> accounts_;
  Monitor<Exec> monitor_;
  StepsAhead<Exec> ahead_;
  typename Exec::template Buffer<Load> held_;  ///< contact and wall forces of this step, while held()
  GiveUp give_up_;                             ///< may be empty
  bool primed_ = false;                        ///< the particles have the loads of their present positions
};

}  // namespace gyro

#include "core/dem/exchange.hpp"
#include "core/dem/levels.hpp"
#include "core/dem/run_ahead.hpp"
#include "core/dem/step.hpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/base/thread_team.hpp"
#include "core/dem/load_rows.hpp"
#include "core/dem/particle_store.hpp"
#include "core/dem/rigid_arrivals.hpp"
#include "core/dem/scene_laws.hpp"
#include "core/exec/phase_timer.hpp"
#include "core/kernels/change_level.hpp"
#include "core/kernels/let_go.hpp"
#include "core/scene/window.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gyro {

/// Owns what rocks need to move as rigid bodies: a body for each block, the places of the particles in it, and the rows
/// of load tables. Empty in a scene without RigidLevel.
template <class Exec, class Real>
class RigidRocks {
 public:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  explicit RigidRocks(const Scene& scene) : level_(scene.rigid) {
    if (!level_) return;
    const auto steps = [&](double time) {
      return std::max(std::int64_t{1}, static_cast<std::int64_t>(time / scene.dt));
    };
    look_every_ = steps(level_->look_interval);
    divide_every_ = steps(0.5 * level_->calm_time);
  }

  bool in_use() const { return level_.has_value(); }
  /// Whether the loads are looked at in a step. @param step  of the scene, from 0
  bool looks_in(std::int64_t step) const { return in_use() && step % look_every_ == 0; }

  /// Whether broken rocks are divided before a window, so that their pieces may become rigid.
  bool divides_before(const Window& window) const {
    return in_use() && with_pieces() &&
           (window.first_step + window.steps) / divide_every_ > window.first_step / divide_every_;
  }

  /// @param rock  with these already
  void append(std::span<const NewRock> rocks, const ParticleStore<Exec, Real>& rock) {
    if (!in_use()) return;
    RigidArrivals arrivals;
    for (const NewRock& more : rocks) {
      GYRO_EXPECT(more.load_table == none || fits(more));
      arrivals.add(more);
    }
    Exec::append(bodies_, std::move(arrivals.bodies));
    Exec::append(arms_, std::move(arrivals.arms));
    resize(rock);
  }

  /// Rock has left, or has been divided. @param rock  as it is now
  /// @param old_block  of each block now, as NewBonds::old_block
  void rearrange(const NewPlaces& places, const std::vector<Index>& old_block, const ParticleStore<Exec, Real>& rock) {
    if (!in_use()) return;
    Exec::keep(bodies_, old_block);
    Exec::keep(arms_, places.old_index);
    Exec::keep(row_, places.old_index);
    std::vector<OwnRows> own(old_block.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      own[k] = std::move(own_[static_cast<std::size_t>(old_block[k])]);
      for (auto& [particle, numbers] : own[k].made) particle = places.new_index[static_cast<std::size_t>(particle)];
    }
    own_ = std::move(own);
    resize(rock);
  }

  /// Adds up the loads of rigid rocks, and sees whether rows of load tables are lacking for a look at them.
  void add_loads(Exec& exec, ParticleStore<Exec, Real>& rock, Gather<Real> gather, bool new_forces,
                 std::int32_t* lacking) {
    gather.with_bonds = false;
    gather.held = nullptr;
    exec.for_each_block("rigid rocks", launch(rock),
                        LoadRigid<Real>{.blocks = rock.block_view(),
                                        .gather = gather,
                                        .new_forces = new_forces,
                                        .made = row_.data(),
                                        .lacking = lacking});
  }
  /// @return whether some rock has become overloaded because no rows can be made for it
  bool make_rows(Exec& exec, ParticleStore<Exec, Real>& rock, const Vec3d& gravity) {
    const PhaseTimer::Mark mark = exec.timer().begin("load rows");
    std::vector<Index> lacking;
    for (Index k = 0; k < rocks(rock); ++k)
      if (Exec::host(rock.blocks())[static_cast<std::size_t>(k)].lacks_rows) lacking.push_back(k);
    const MakeRows<Real> make{.p = rock.view(),
                              .b = rock.read_bonds(),
                              .blocks = rock.block_view(),
                              .arms = arms_.data(),
                              .gravity = gravity,
                              .level = *level_,
                              .own = own_.data(),
                              .row = row_.data()};
    std::atomic<bool> failed = false;
    for_each_job(*exec.host_team(), static_cast<int>(lacking.size()), [&](int n) {
      if (!make(lacking[static_cast<std::size_t>(n)])) failed = true;
    });
    exec.timer().end(mark);
    return failed;
  }

  /// A step, or the first half of one where a window begins (AdvanceRigid).
  /// @param look  at the loads, which add_loads() has added up
  void advance(Exec& exec, ParticleStore<Exec, Real>& rock, Gather<Real> gather, const Move& move, bool new_forces,
               bool look, std::int32_t* overloaded) {
    gather.with_bonds = false;
    gather.held = nullptr;
    exec.for_each_block("rigid rocks", launch(rock),
                        AdvanceRigid<Real>{.blocks = rock.block_view(),
                                           .bodies = bodies_.data(),
                                           .turning = turning_.data(),
                                           .arms = arms_.data(),
                                           .gather = gather,
                                           .move = move,
                                           .new_forces = new_forces,
                                           .loads_known = look,
                                           .bound = {.rows = row_.data(),
                                                     .blocks = rock.block_view(),
                                                     .bodies = bodies_.data(),
                                                     .strength = rock.read_bonds().strength,
                                                     .allowed = level_->bonded_above,
                                                     .overloaded = overloaded},
                                           .look = look});
  }

  void finish_step(Exec& exec, ParticleStore<Exec, Real>& rock, const Scene& scene) {
    exec.for_each("rigid rocks", rocks(rock),
                  FinishRigid{rock.view(), rock.block_view(), bodies_.data(), scene.gravity, scene.dt});
  }

  /// Makes overloaded rocks particles with bonds. All particles have met.
  void free_overloaded(Exec& exec, ParticleStore<Exec, Real>& rock, const Scene& scene) {
    forget_rows(Exec::host(rock.blocks()));
    exec.for_each("change level", rocks(rock),
                  FreeRocks{rock.view(), rock.block_view(), bodies_.data(), scene.gravity, scene.dt});
  }

  /// Broken bonds that press next to nothing become contacts (LetGo). @return the elastic energy that this takes [J]
  double let_go(Exec& exec, ParticleStore<Exec, Real>& rock, const SceneLaws<Exec, Real>& laws) const {
    const double force = 0.5 * level_->rigid_below;  // of a pressed bond over that at failure
    const LetGo<Real> kernel{.p = rock.read(),
                             .b = rock.read_bonds(),
                             .state = rock.bond_view().state,
                             .blocks = rock.block_view(),
                             .law = laws.bond(),
                             .model = laws.bond_model(),
                             .contact = laws.rock(),
                             .contact_model = laws.rock_model(),
                             .share = force * force,
                             .with_history = keeps_extra_history(laws.rock_model())};
    const double lost = exec.template reduce<double>("let go", rock.bond_count(), kernel);
    exec.for_each("let go", rock.bond_count(), LetGoEach<Real>{kernel});
    return lost;
  }

  /// Looks at the bonds of rocks, at the end of a window. @param time  of the window [s]
  void find_calm(Exec& exec, ParticleStore<Exec, Real>& rock, const SceneLaws<Exec, Real>& laws, double time) {
    exec.for_each("look whether calm", rocks(rock),
                  LookWhetherCalm<Real>{rock.read(), rock.read_bonds(), laws.bond(), laws.bond_model(),
                                        rock.block_view(), level_->rigid_below, time});
  }
  /// Whether some rocks have been calm for long enough.
  bool any_calm(Exec& exec, const ParticleStore<Exec, Real>& rock) const {
    return exec.template reduce<Index>("look whether calm", rocks(rock), calm(rock)) > 0;
  }
  /// Makes them rigid. All particles have met.
  void stiffen_calm(Exec& exec, ParticleStore<Exec, Real>& rock, const Scene& scene) {
    exec.for_each(
        "change level", rocks(rock),
        StiffenCalm{rock.view(), rock.block_view(), bodies_.data(), arms_.data(), calm(rock), scene.gravity, scene.dt});
  }

  /// Particles, and bonds times sub-steps, that are not computed one by one.
  RigidCount count(Exec& exec, const ParticleStore<Exec, Real>& rock) const {
    return exec.template reduce<RigidCount>("count rigid rocks", rocks(rock), CountRigid{rock.blocks().data()});
  }

  void save(SavedState& to) const {
    if (!in_use()) return;
    to.put("rigid/bodies", Exec::host(bodies_));
    to.put("rigid/arms", Exec::host(arms_));
  }
  /// @throws BadInput as SavedState::get
  void restore(const SavedState& from, const ParticleStore<Exec, Real>& rock) {
    if (!in_use()) return;
    Exec::upload(bodies_, from.get<Body>("rigid/bodies", rock.blocks().size()));
    Exec::upload(arms_, from.get<Arm>("rigid/arms", static_cast<std::size_t>(rock.count())));
    own_.clear();
    Exec::upload(row_, std::vector<const float*>());
    resize(rock);
  }

 private:
  bool with_pieces() const { return static_cast<bool>(level_->response_of); }
  bool fits(const NewRock& rock) const {
    if (rock.load_table < 0 || static_cast<std::size_t>(rock.load_table) >= level_->tables->size()) return false;
    const LoadTable& table = (*level_->tables)[static_cast<std::size_t>(rock.load_table)];
    return static_cast<std::size_t>(table.particles) == rock.particles.size() &&
           static_cast<std::size_t>(table.bonds) == rock.bonds.size();
  }

  /// Room for what all rocks and particles have, and the rows of tables.
  void resize(const ParticleStore<Exec, Real>& rock) {
    turning_.resize(bodies_.size());
    own_.resize(bodies_.size());
    std::vector<const float*> row = Exec::host(row_);
    row.resize(static_cast<std::size_t>(rock.count()), nullptr);
    const auto& blocks = Exec::host(rock.blocks());
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const Block& b = blocks[k];
      for (Index n = b.first_particle; n < b.end_particle; ++n) {
        const float*& of_particle = row[static_cast<std::size_t>(n)];
        if (b.table != none)
          of_particle = (*level_->tables)[static_cast<std::size_t>(b.table)].row(n - b.first_particle).numbers;
        else if (own_[k].empty())
          of_particle = nullptr;
      }
    }
    Exec::upload(row_, std::move(row));
  }

  /// Rows of their own that rocks need no more, because they become particles with bonds.
  void forget_rows(const std::vector<Block>& blocks) {
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const Block& b = blocks[k];
      if (!b.rigid || !b.overloaded || b.table != none) continue;
      own_[k] = OwnRows{};
      std::fill(row_.data() + b.first_particle, row_.data() + b.end_particle, nullptr);
    }
  }

  static Index rocks(const ParticleStore<Exec, Real>& rock) { return static_cast<Index>(rock.blocks().size()); }
  static BlockLaunch launch(const ParticleStore<Exec, Real>& rock) { return {rocks(rock), run_length}; }
  CalmRocks calm(const ParticleStore<Exec, Real>& rock) const {
    return {rock.blocks().data(), level_->calm_time, with_pieces()};
  }

  std::optional<RigidLevel> level_;
  std::int64_t look_every_ = 1, divide_every_ = 1;  ///< steps of the scene
  Buffer<Body> bodies_;                             ///< of each block
  Buffer<Vec3d> turning_;                           ///< AdvanceRigid
  Buffer<Arm> arms_;                                ///< of each particle
  Buffer<const float*> row_;                        ///< of each particle, as in StressBound
  std::vector<OwnRows> own_;                        ///< of each block
};

}  // namespace gyro

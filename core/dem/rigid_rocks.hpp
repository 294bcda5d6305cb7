// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/dem/particle_store.hpp"
#include "core/dem/rigid_arrivals.hpp"
#include "core/dem/scene_laws.hpp"
#include "core/kernels/change_level.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gyro {

/// Owns what rocks need to move as rigid bodies: a body for each rock, the places of the particles in it, and the load
/// tables. Empty in a scene without RigidLevel.
template <class Exec, class Real>
class RigidRocks {
 public:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  explicit RigidRocks(const Scene& scene) {
    if (!scene.rigid) return;
    level_ = RigidLevel{*scene.rigid};
    look_every_ = std::max(std::int64_t{1}, static_cast<std::int64_t>(level_->look_interval / scene.dt));
    std::vector<float> force, moment, response;
    std::vector<std::int64_t> begin;
    for (const LoadTable& table : *level_->tables) {
      begin.push_back(static_cast<std::int64_t>(force.size()));
      sizes_.emplace_back(table.particles, table.bonds);
      force.insert(force.end(), table.force.begin(), table.force.end());
      moment.insert(moment.end(), table.moment.begin(), table.moment.end());
      response.insert(response.end(), table.response.begin(), table.response.end());
    }
    level_->tables.reset();
    Exec::upload(force_, std::move(force));
    Exec::upload(moment_, std::move(moment));
    Exec::upload(response_, std::move(response));
    Exec::upload(begin_, std::move(begin));
  }

  bool in_use() const { return level_.has_value(); }
  /// Whether the loads are looked at in a step. @param step  of the scene, from 0
  bool looks_in(std::int64_t step) const { return in_use() && step % look_every_ == 0; }

  void append(std::span<const NewRock> rocks) {
    if (!in_use()) return;
    RigidArrivals arrivals;
    for (const NewRock& rock : rocks) {
      GYRO_EXPECT(rock.load_table == none || fits(rock));
      arrivals.add(rock);
    }
    Exec::append(bodies_, std::move(arrivals.bodies));
    Exec::append(arms_, std::move(arrivals.arms));
    turning_.resize(bodies_.size());
  }

  /// Removes all other particles. @param blocks  of the scene before
  void keep(const Remaining& remaining, const std::vector<Block>& blocks) {
    if (!in_use()) return;
    std::vector<Index> rocks;
    for (std::size_t k = 0; k < blocks.size(); ++k)
      if (remaining.place(blocks[k].first_particle) != remaining.place(blocks[k].end_particle))
        rocks.push_back(static_cast<Index>(k));
    Exec::keep(bodies_, rocks);
    Exec::keep(arms_, remaining.old_index);
    turning_.resize(bodies_.size());
  }

  /// A step, or the first half of one where a window begins (AdvanceRigid).
  void advance(Exec& exec, ParticleStore<Exec, Real>& rock, Gather<Real> gather, const Move& move, bool new_forces,
               bool look, std::int32_t* overloaded) {
    gather.with_bonds = false;
    gather.held = nullptr;
    exec.for_each_block(
        "rigid rocks", launch(rock),
        AdvanceRigid<Real>{.blocks = rock.block_view(),
                           .bodies = bodies_.data(),
                           .turning = turning_.data(),
                           .arms = arms_.data(),
                           .gather = gather,
                           .move = move,
                           .new_forces = new_forces,
                           .bound = {.tables = {force_.data(), moment_.data(), response_.data(), begin_.data()},
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
    exec.for_each("change level", rocks(rock),
                  FreeRocks{rock.view(), rock.block_view(), bodies_.data(), scene.gravity, scene.dt});
  }

  /// Looks at the bonds of intact rocks, at the end of a window. @param time  of the window [s]
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
    turning_.resize(bodies_.size());
  }

 private:
  bool fits(const NewRock& rock) const {
    if (rock.load_table < 0 || static_cast<std::size_t>(rock.load_table) >= sizes_.size()) return false;
    const auto& [particles, bonds] = sizes_[static_cast<std::size_t>(rock.load_table)];
    return static_cast<std::size_t>(particles) == rock.particles.size() &&
           static_cast<std::size_t>(bonds) == rock.bonds.size();
  }
  static Index rocks(const ParticleStore<Exec, Real>& rock) { return static_cast<Index>(rock.blocks().size()); }
  static BlockLaunch launch(const ParticleStore<Exec, Real>& rock) { return {rocks(rock), run_length}; }
  CalmRocks calm(const ParticleStore<Exec, Real>& rock) const { return {rock.blocks().data(), level_->calm_time}; }

  std::optional<RigidLevel> level_;          ///< without its tables
  std::int64_t look_every_ = 1;              ///< steps of the scene
  Buffer<Body> bodies_;                      ///< of each block
  Buffer<Vec3d> turning_;                    ///< AdvanceRigid
  Buffer<Arm> arms_;                         ///< of each particle
  Buffer<float> force_, moment_, response_;  ///< TableView
  Buffer<std::int64_t> begin_;
  std::vector<std::pair<Index, Index>> sizes_;  ///< particles and bonds of each table
};

}  // namespace gyro

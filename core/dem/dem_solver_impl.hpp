// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem_accounts.hpp"
#include "core/dem/dem_exchange.hpp"
#include "core/dem/dem_lists.hpp"
#include "core/dem/dem_removal.hpp"
#include "core/dem/dem_saving.hpp"
#include "core/dem/dem_step.hpp"

namespace gyro {

template <class Exec, class Real>
DemSolver<Exec, Real>::DemSolver(Scene scene, Exec exec)
    : scene_(std::move(scene)),
      exec_(std::move(exec)),
      rock_law_(contact_constants<Real>(scene_, scene_.rock_material, scene_.rock_material)),
      rock_model_(rock_model(scene_)),
      wall_model_(wall_model(scene_)),
      surfaces_(scene_.walls) {
  std::vector<ContactConstants<Real>> laws;
  for (const Wall& wall : scene_.walls) {
    laws.push_back(contact_constants<Real>(scene_, scene_.rock_material, wall.material));
    poses_now_.push_back(pose_of(wall, 0, {}));
  }
  Exec::upload(wall_laws_, laws);
  Exec::upload(flags_, std::vector<std::int32_t>(flag_count, 0));
  wall_sums_.resize(scene_.walls.size());
  wall_loads_.resize(scene_.walls.size());
  resize_rows();
}

template <class Exec, class Real>
ParticleView DemSolver<Exec, Real>::view() const {
  auto& p = const_cast<DemSolver*>(this)->particles_;
  return {p.position.data(),  p.motion.data(),          p.angular_motion.data(), p.orientation.data(), p.load.data(),
          p.bond_load.data(), p.listed_position.data(), p.losses.data(),         p.id.data(),          p.block.data()};
}

template <class Exec, class Real>
BlockList DemSolver<Exec, Real>::block_list() const {
  const std::size_t blocks = blocks_.size(), begins = colour_begin_.size();  // a block has one more than colours
  const std::size_t colours = begins > blocks ? begins - blocks : 1;
  return {blocks_.data(), static_cast<Index>(blocks), colour_begin_.data(),
          static_cast<Index>(bonds_.i.size() / colours)};
}

template <class Exec, class Real>
BondView<Real> DemSolver<Exec, Real>::bond_view() const {
  auto& b = const_cast<DemSolver*>(this)->bonds_;
  return {b.i.data(),      b.j.data(),   b.axis_x.data(),   b.axis_y.data(),    b.axis_z.data(),       b.length.data(),
          b.radius.data(), b.arm.data(), b.strength.data(), b.sqrt_mass.data(), b.sqrt_inertia.data(), b.state.data()};
}

template <class Exec, class Real>
PairView<Real> DemSolver<Exec, Real>::pair_view(const PairLists& lists) const {
  auto& l = const_cast<PairLists&>(lists);
  return {l.pairs.data(),    l.history.data(),   nullptr,       l.result.data(),
          l.touching.data(), l.row_begin.data(), l.ends.data(), static_cast<Index>(l.pairs.size())};
}

template <class Exec, class Real>
WallView<Real> DemSolver<Exec, Real>::wall_view(const WallLists& lists) const {
  auto& l = const_cast<WallLists&>(lists);
  return {surfaces_.data(),   poses_,
          l.entries.data(),   l.history.data(), nullptr,
          l.result.data(),    l.touching.data(),
          l.sums.data(),      l.carried_over.data(),
          l.row_begin.data(), static_cast<Index>(l.entries.size())};
}

template <class Exec, class Real>
BondLaw<Real> DemSolver<Exec, Real>::bond_law() const {
  const BondParameters& b = *scene_.bonds;
  const auto r = [](double x) { return static_cast<Real>(x); };
  return {r(b.normal_stiffness), r(b.shear_stiffness), r(b.normal_modulus), r(b.shear_modulus), r(b.tensile_strength),
          r(b.shear_strength),   r(b.damping),         rock_law_.friction,  r(scene_.dt)};
}

}  // namespace gyro

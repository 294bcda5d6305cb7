// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem_solver.hpp"
#include "core/state/fragment_labels.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

// Accounts and snapshots of the scene.

namespace gyro {

template <class Exec, class Real>
ParticleSums DemSolver<Exec, Real>::particle_sums() const {
  return exec_.template reduce<ParticleSums>("sum particles", particle_count(),
                                             SumParticles{view(), scene_.gravity, hold_time()});
}

template <class Exec, class Real>
ContactSums DemSolver<Exec, Real>::contact_sums() const {
  const SumContacts<Real> contacts{view(),      pair_view(pairs_), wall_view(walls_), rock_law_, wall_laws_.data(),
                                   rock_model_, wall_model_};
  return exec_.template reduce<ContactSums>("sum contacts", particle_count(), contacts);
}

template <class Exec, class Real>
BondSums DemSolver<Exec, Real>::bond_sums() const {
  if (!has_bonds()) return {};
  return exec_.template reduce<BondSums>("sum bonds", static_cast<Index>(bonds_.i.size()),
                                         SumBonds<Real>{view(), bond_view(), bond_law()});
}

template <class Exec, class Real>
EnergyTerms DemSolver<Exec, Real>::energy() const {
  const ParticleSums sums = particle_sums();
  EnergyTerms e = booked_;
  e.kinetic = sums.kinetic;
  e.potential = sums.potential;
  e.contact_elastic = contact_sums().elastic;
  e.bond_elastic = bond_sums().elastic;
  e.contact_damping += sums.lost.contact_damping;
  e.friction += sums.lost.contact_slip + sums.lost.bond_slip;
  e.bond_damping += sums.lost.bond_damping;
  return e;
}

template <class Exec, class Real>
Extremes DemSolver<Exec, Real>::extremes_now(bool with_bonds) const {
  const ParticleSums sums = particle_sums();
  const ContactSums contacts = contact_sums();
  const BondSums bonds = with_bonds ? bond_sums() : BondSums{};
  Extremes x;
  x.finite = sums.not_finite == 0;
  x.culprit = x.finite ? contacts.culprit : sums.culprit;
  x.partner = contacts.partner;
  x.wall = contacts.wall;
  x.overlap_ratio = contacts.overlap_ratio;
  x.speed_ratio = sums.overspeed;
  x.fastest = sums.fastest;
  x.rotation = sums.rotation;
  x.fastest_rotating = sums.fastest_rotating;
  x.bond_rotation = bonds.rotation;
  x.twisted = bonds.twisted;
  return x;
}

/// The larger of both in every respect.
inline Extremes worst_of(const Extremes& a, const Extremes& b) {
  Extremes x = a;
  const bool other_overlap = x.finite && (!b.finite || b.overlap_ratio > a.overlap_ratio);
  if (other_overlap) x.culprit = b.culprit, x.partner = b.partner, x.wall = b.wall;
  x.finite = a.finite && b.finite;
  x.overlap_ratio = larger(a.overlap_ratio, b.overlap_ratio);
  if (b.speed_ratio > a.speed_ratio) x.speed_ratio = b.speed_ratio, x.fastest = b.fastest;
  if (b.rotation > a.rotation) x.rotation = b.rotation, x.fastest_rotating = b.fastest_rotating;
  if (b.bond_rotation > a.bond_rotation) x.bond_rotation = b.bond_rotation, x.twisted = b.twisted;
  return x;
}

template <class Exec, class Real>
Extremes DemSolver<Exec, Real>::extremes() const {
  Extremes x = extremes_now(false);
  if (first_excess_) x = worst_of(x, *first_excess_);
  if (smallest_radius_ > 0 && wall_step_ > 0) {
    x.wall_step = wall_step_ / smallest_radius_;
    x.fast_wall = fast_wall_;
  }
  return x;
}

template <class Exec, class Real>
Counts DemSolver<Exec, Real>::counts() const {
  Counts c = counts_total_;
  c.particles = particle_count();
  return c;
}

template <class Exec, class Real>
Vec3d DemSolver<Exec, Real>::momentum() const {
  return particle_sums().momentum;
}

/// Brings the failures of the window into order and books the energy that they released.
template <class Exec, class Real>
void DemSolver<Exec, Real>::drain_breakages(const Window& window) {
  if (!has_bonds()) return;
  Host<std::int32_t> flags = Exec::host(flags_);
  const auto count = static_cast<std::size_t>(flags[2]);
  if (count == 0) return;
  const auto& events = Exec::host(events_);
  const auto& bond_i = Exec::host(bonds_.i);
  const auto& bond_j = Exec::host(bonds_.j);
  const auto& place = Exec::host(particles_.position);
  const auto& id = Exec::host(particles_.id);
  const auto& block = Exec::host(particles_.block);
  const auto& blocks = Exec::host(blocks_);
  std::vector<Breakage> drained;
  for (std::size_t k = 0; k < count; ++k) {
    const BreakEvent& e = events[k];
    const auto i = static_cast<std::size_t>(bond_i[static_cast<std::size_t>(e.bond)]),
               j = static_cast<std::size_t>(bond_j[static_cast<std::size_t>(e.bond)]);
    const Vec3d middle = 0.5 * (place[i].x + place[j].x);
    drained.push_back({static_cast<double>(e.step) * window.dt, static_cast<BreakMode>(e.mode), middle,
                       blocks[static_cast<std::size_t>(block[i])].rock, id[i], id[j], e.energy});
  }
  std::sort(drained.begin(), drained.end(), [](const Breakage& a, const Breakage& b) {
    return std::tie(a.time, a.i, a.j) < std::tie(b.time, b.i, b.j);
  });
  for (const Breakage& b : drained) {
    booked_.bond_breakage += b.energy;
    ++(b.mode == BreakMode::tension ? counts_total_.broken_tension : counts_total_.broken_shear);
  }
  counts_total_.bonds_intact -= static_cast<std::int64_t>(count);
  breakages_.insert(breakages_.end(), drained.begin(), drained.end());
  flags[2] = 0;
  Exec::upload(flags_, std::move(flags));
}

/// Places of the particles in order of id: the arrays are in order of arrival.
template <class Exec, class Real>
std::vector<Index> DemSolver<Exec, Real>::rows_by_id() const {
  const auto& id = Exec::host(particles_.id);
  std::vector<Index> places(id.size());
  std::iota(places.begin(), places.end(), 0);
  std::sort(places.begin(), places.end(),
            [&](Index a, Index b) { return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)]; });
  return places;
}

template <class Exec, class Real>
ParticleSnapshot DemSolver<Exec, Real>::particles() const {
  const auto& place = Exec::host(particles_.position);
  const auto& motion = Exec::host(particles_.motion);
  const auto& angular = Exec::host(particles_.angular_motion);
  const auto& load = Exec::host(particles_.load);
  const auto& id = Exec::host(particles_.id);
  const auto& block = Exec::host(particles_.block);
  const auto& blocks = Exec::host(blocks_);
  ParticleSnapshot s;
  for (const Index row : rows_by_id()) {
    const auto k = static_cast<std::size_t>(row);
    s.id.push_back(id[k]);
    s.rock.push_back(block[k] == none ? none : blocks[static_cast<std::size_t>(block[k])].rock);
    s.position.push_back(place[k].x);
    s.velocity.push_back(motion[k].v);
    s.angular_velocity.push_back(angular[k].w);
    s.force.push_back(load[k].force - motion[k].mass * scene_.gravity);
    s.radius.push_back(place[k].radius);
    s.mass.push_back(motion[k].mass);
  }
  const IntactBonds intact = intact_bonds();
  s.fragment = fragment_labels(particle_count(), intact.i, intact.j);
  return s;
}

template <class Exec, class Real>
auto DemSolver<Exec, Real>::intact_bonds() const -> IntactBonds {
  const auto& i = Exec::host(bonds_.i);
  const auto& j = Exec::host(bonds_.j);
  const auto& state = Exec::host(bonds_.state);
  const std::vector<Index> places = rows_by_id();
  std::vector<Index> row(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) row[static_cast<std::size_t>(places[k])] = static_cast<Index>(k);
  IntactBonds intact;
  for (std::size_t b = 0; b < i.size(); ++b) {
    if (state[b] != bond_intact) continue;
    intact.bond.push_back(b);
    intact.i.push_back(row[static_cast<std::size_t>(i[b])]);
    intact.j.push_back(row[static_cast<std::size_t>(j[b])]);
  }
  return intact;
}

template <class Exec, class Real>
BondSnapshot DemSolver<Exec, Real>::bonds() const {
  BondSnapshot s;
  if (!has_bonds()) return s;
  Buffer<BondReading> noted;
  noted.resize(bonds_.i.size());
  exec_.for_each("note bonds", static_cast<Index>(noted.size()),
                 ReadBonds<Real>{view(), bond_view(), bond_law(), noted.data()});
  const auto& now = Exec::host(noted);
  const auto& radius = Exec::host(bonds_.radius);
  IntactBonds intact = intact_bonds();
  s.i = std::move(intact.i);
  s.j = std::move(intact.j);
  for (const std::size_t b : intact.bond) {
    s.normal_force.push_back(now[b].normal_force);
    s.stress_ratio.push_back(now[b].stress_ratio);
    s.radius.push_back(static_cast<double>(radius[b]));
  }
  return s;
}

}  // namespace gyro

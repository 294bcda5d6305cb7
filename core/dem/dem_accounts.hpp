// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem_solver.hpp"
#include "core/fragments/labels.hpp"

#include <algorithm>
#include <tuple>

// Accounts and snapshots of the scene.

namespace gyro {

template <class Exec, class Real>
ParticleSums DemSolver<Exec, Real>::particle_sums() const {
  return exec_.template reduce<ParticleSums>("sum particles", particle_count(),
                                             SumParticles{view(), scene_.gravity, scene_.dt});
}

template <class Exec, class Real>
ContactSums DemSolver<Exec, Real>::contact_sums() const {
  const PairView<Real> pairs = pair_view(pairs_);
  const WallView<Real> walls = wall_view(walls_);
  const ContactSums a =
      exec_.template reduce<ContactSums>("sum pairs", pairs.count, SumPairs<Real>{view(), pairs, rock_law_});
  if (poses_ == nullptr) return a;
  return a + exec_.template reduce<ContactSums>("sum walls", walls.count,
                                                SumWallContacts<Real>{view(), walls, wall_laws_.data()});
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
Extremes DemSolver<Exec, Real>::extremes() const {
  const ParticleSums sums = particle_sums();
  const ContactSums contacts = contact_sums();
  Extremes x;
  x.finite = sums.not_finite == 0;
  x.culprit = x.finite ? contacts.culprit : sums.culprit;
  x.overlap_ratio = contacts.overlap_ratio;
  x.speed_ratio = sums.overspeed;
  x.turn = sums.turn;
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
  auto flags = Exec::host(flags_);
  const auto count = static_cast<std::size_t>(flags[2]);
  if (count == 0) return;
  std::vector<Breakage> drained;
  for (std::size_t k = 0; k < count; ++k) {
    const BreakEvent& e = events_[k];
    const auto i = static_cast<std::size_t>(bonds_.i[static_cast<std::size_t>(e.bond)]),
               j = static_cast<std::size_t>(bonds_.j[static_cast<std::size_t>(e.bond)]);
    const Vec3d middle = 0.5 * (particles_.place[i].x + particles_.place[j].x);
    drained.push_back({static_cast<double>(e.step) * window.dt, static_cast<BreakMode>(e.mode), middle,
                       blocks_[static_cast<std::size_t>(particles_.block[i])].rock, particles_.id[i], particles_.id[j],
                       e.energy});
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
  Exec::upload(flags_, flags);
}

template <class Exec, class Real>
ParticleSnapshot DemSolver<Exec, Real>::particles() const {
  ParticleSnapshot s;
  const auto n = static_cast<std::size_t>(particle_count());
  for (std::size_t k = 0; k < n; ++k) {
    const Motion& motion = particles_.motion[k];
    s.id.push_back(particles_.id[k]);
    const Index block = particles_.block[k];
    s.rock.push_back(block == none ? none : blocks_[static_cast<std::size_t>(block)].rock);
    s.position.push_back(particles_.place[k].x);
    s.velocity.push_back(motion.v);
    s.spin.push_back(particles_.spin[k].w);
    s.force.push_back(particles_.load[k].force - motion.mass * scene_.gravity);
    s.radius.push_back(particles_.place[k].radius);
    s.mass.push_back(motion.mass);
  }
  std::vector<Index> i, j;
  for (std::size_t b = 0; b < bonds_.i.size(); ++b)
    if (bonds_.state[b] == bond_glued) {
      i.push_back(bonds_.i[b]);
      j.push_back(bonds_.j[b]);
    }
  s.fragment = fragment_labels(particle_count(), i, j);
  return s;
}

template <class Exec, class Real>
BondSnapshot DemSolver<Exec, Real>::bonds() const {
  BondSnapshot s;
  for (std::size_t b = 0; b < bonds_.i.size(); ++b) {
    if (bonds_.state[b] != bond_glued) continue;
    const BondLoad<Real> load = bond_load_now(view(), bond_view(), bond_law(), static_cast<Index>(b));
    const auto &a = particles_.place[static_cast<std::size_t>(bonds_.i[b])],
               &c = particles_.place[static_cast<std::size_t>(bonds_.j[b])];
    const Vec3d span = c.x - a.x;
    s.i.push_back(bonds_.i[b]);
    s.j.push_back(bonds_.j[b]);
    s.normal_force.push_back(-dot(cast<double>(load.force), span) / norm(span));
    s.stress_ratio.push_back(static_cast<double>(larger(load.tension_ratio, load.shear_ratio)));
    s.radius.push_back(static_cast<double>(bonds_.radius[b]));
  }
  return s;
}

}  // namespace gyro

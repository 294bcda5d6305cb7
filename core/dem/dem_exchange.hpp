// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/dem_solver.hpp"

#include <numeric>
#include <string>

// Rock comes between windows. It is put together on the host and added at the end of each column.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::insert(std::span<const NewRock> rocks) {
  Arrivals arrivals;
  arrivals.exchanged = booked_.exchanged;
  for (const NewRock& rock : rocks) arrive(rock, arrivals);
  take_in(arrivals);
  resize_rows();
  if (has_bonds()) index_bonds();
  listed_ = false;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::arrive(const NewRock& rock, Arrivals& arrivals) const {
  Particles<Host>& to = arrivals.particles;
  const Index first = particle_count() + static_cast<Index>(to.position.size());
  const bool blocked = rock.id != none;
  const Index block = blocked ? static_cast<Index>(blocks_.size() + arrivals.blocks.size()) : none;
  for (const NewParticle& p : rock.particles) {
    const double mass = p.density * (4.0 / 3) * 3.14159265358979323846 * p.radius * p.radius * p.radius;
    to.position.push_back({p.position, p.radius});
    to.motion.push_back({p.velocity, mass});
    to.angular_motion.push_back({p.angular_velocity, 0.4 * mass * p.radius * p.radius});
    if (has_bonds()) to.orientation.push_back({1, 0, 0, 0});
    Load load;
    load.force = mass * scene_.gravity;
    to.load.push_back(load);
    if (has_bonds()) to.bond_load.push_back({});
    to.listed_position.push_back(p.position);
    to.losses.push_back({});
    to.id.push_back(p.id);
    to.block.push_back(block);
    arrivals.exchanged += 0.5 * mass * norm2(p.velocity) +
                          0.2 * mass * p.radius * p.radius * norm2(p.angular_velocity) -
                          mass * dot(scene_.gravity, p.position);
  }
  if (!blocked) return;
  const auto bonds = [&] { return static_cast<Index>(bonds_.i.size() + arrivals.bonds.i.size()); };
  const auto colours = [&] { return static_cast<Index>(colour_begin_.size() + arrivals.colour_begin.size()); };
  const Index end = first + static_cast<Index>(rock.particles.size());
  Block b{first, end, bonds(), 0, colours(), 0, rock.id, rock.bonds.empty() ? block_broken : block_intact};
  if (has_bonds()) arrive_bonds(rock, first, arrivals);
  b.end_bond = bonds();
  b.end_colour = colours();
  arrivals.blocks.push_back(b);
}

/// Throws when two bonds of a colour share a particle: a thread block adds the forces of a colour at once.
inline void check_colours(const NewRock& rock) {
  const auto wrong = [&](const char* what) {
    return BadInput("rock " + std::to_string(rock.id) + ": " + what +
                    "; bonds come grouped by colour, colour_begin runs from 0 to their number and no two "
                    "bonds of a colour share a particle");
  };
  const std::vector<Index>& begin = rock.colour_begin;
  if (rock.bonds.empty()) return;
  if (begin.empty() || begin.front() != 0 || begin.back() != static_cast<Index>(rock.bonds.size()))
    throw wrong("its colours do not cover its bonds");
  std::vector<Index> last_colour(rock.particles.size(), none);
  for (std::size_t c = 0; c + 1 < begin.size(); ++c)
    for (Index n = begin[c]; n < begin[c + 1]; ++n)
      for (const Index end : {rock.bonds[static_cast<std::size_t>(n)].i, rock.bonds[static_cast<std::size_t>(n)].j}) {
        Index& last = last_colour[static_cast<std::size_t>(end)];
        if (last == static_cast<Index>(c)) throw wrong("two bonds of one colour share a particle");
        last = static_cast<Index>(c);
      }
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::arrive_bonds(const NewRock& rock, Index first_particle, Arrivals& arrivals) const {
  check_colours(rock);
  Bonds<Host, Real>& to = arrivals.bonds;
  const Index first_bond = static_cast<Index>(bonds_.i.size() + to.i.size());
  const auto offset = static_cast<std::size_t>(first_particle - particle_count());
  for (const NewBond& bond : rock.bonds) {
    const auto k = static_cast<std::size_t>(bond.i), l = static_cast<std::size_t>(bond.j);
    const NewParticle &p = rock.particles[k], &q = rock.particles[l];
    if (p.id >= q.id) throw BadInput("a bond joins particles in the wrong order; the lower id comes first");
    const Vec3d span = q.position - p.position;
    const Vec3d axis = (1 / norm(span)) * span;
    const Motion &mi = arrivals.particles.motion[offset + k], &mj = arrivals.particles.motion[offset + l];
    const AngularMotion &si = arrivals.particles.angular_motion[offset + k],
                        &sj = arrivals.particles.angular_motion[offset + l];
    to.i.push_back(first_particle + bond.i);
    to.j.push_back(first_particle + bond.j);
    to.axis_x.push_back(static_cast<Real>(axis.x));
    to.axis_y.push_back(static_cast<Real>(axis.y));
    to.axis_z.push_back(static_cast<Real>(axis.z));
    to.length.push_back(bond.length);
    to.radius.push_back(static_cast<Real>(bond.radius));
    to.arm.push_back(static_cast<Real>((bond.length + p.radius - q.radius) / (2 * bond.length)));
    to.strength.push_back(static_cast<Real>(bond.strength));
    to.sqrt_mass.push_back(static_cast<Real>(std::sqrt(mi.mass * mj.mass / (mi.mass + mj.mass))));
    to.sqrt_inertia.push_back(static_cast<Real>(std::sqrt(si.inertia * sj.inertia / (si.inertia + sj.inertia))));
    to.state.push_back(bond_intact);
  }
  arrivals.bonds_intact += static_cast<std::int64_t>(rock.bonds.size());
  for (const Index colour : rock.colour_begin) arrivals.colour_begin.push_back(first_bond + colour);
  while (to.i.size() % bond_alignment != 0) {
    for_each_bond_column([](const char*, auto& column) { column.push_back({}); }, to);
    to.i.back() = to.j.back() = first_particle;
    to.state.back() = bond_broken;
  }
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::take_in(const Arrivals& arrivals) {
  for_each_particle_column([](const char*, bool, auto& column, const auto& more) { Exec::append(column, more); },
                           particles_, arrivals.particles);
  for_each_bond_column([](const char*, auto& column, const auto& more) { Exec::append(column, more); }, bonds_,
                       arrivals.bonds);
  Exec::append(blocks_, arrivals.blocks);
  Exec::append(colour_begin_, arrivals.colour_begin);
  booked_.exchanged = arrivals.exchanged;
  counts_total_.bonds_intact += arrivals.bonds_intact;
}

/// Bonds by particle, and room for the failures of a window.
template <class Exec, class Real>
void DemSolver<Exec, Real>::index_bonds() {
  const auto& i = Exec::host(bonds_.i);
  const auto& j = Exec::host(bonds_.j);
  const auto& state = Exec::host(bonds_.state);
  const auto at = [](auto& v, Index k) -> auto& {
    return v[static_cast<std::size_t>(k)];
  };
  Host<Index> begin(static_cast<std::size_t>(particle_count()) + 1, 0);
  for (std::size_t b = 0; b < i.size(); ++b)
    if (state[b] != bond_broken) {
      ++at(begin, i[b] + 1);
      ++at(begin, j[b] + 1);
    }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Host<Index> row(static_cast<std::size_t>(begin.back())), next = begin;
  for (std::size_t b = 0; b < i.size(); ++b)
    if (state[b] != bond_broken) {
      at(row, at(next, i[b])++) = static_cast<Index>(b);
      at(row, at(next, j[b])++) = static_cast<Index>(b);
    }
  events_.resize(i.size());
  Exec::upload(bond_row_begin_, std::move(begin));
  Exec::upload(bond_row_, std::move(row));
}

/// Rows of the lists for particles that have just come: empty.
template <class Exec, class Real>
void DemSolver<Exec, Real>::resize_rows() {
  const auto rows = static_cast<std::size_t>(particle_count()) + 1;
  const auto lengthen = [&](auto& row_begin, std::size_t end) {
    if (row_begin.size() < rows) Exec::append(row_begin, Host<Index>(rows - row_begin.size(), static_cast<Index>(end)));
  };
  lengthen(pairs_.row_begin, pairs_.ends.size());
  lengthen(walls_.row_begin, walls_.entries.size());
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/dem_solver.hpp"

#include <algorithm>

// Rock comes and goes between windows. This happens a few times a millisecond at most, so it is done
// on host copies of the columns. The order of particles and bonds never changes: sums keep their order.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::insert(std::span<const NewRock> rocks) {
  for (const NewRock& rock : rocks) append(rock);
  resize_rows();
  if (has_bonds()) index_bonds();
  listed_ = false;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::append(const NewRock& rock) {
  const Index first = particle_count();
  const bool blocked = rock.id != none;
  auto extended = [](auto& buffer, auto value) {
    auto host = Exec::host(buffer);
    host.push_back(value);
    Exec::upload(buffer, std::move(host));
  };
  const Index block = blocked ? static_cast<Index>(blocks_.size()) : none;
  for (const NewParticle& p : rock.particles) {
    const double mass = p.density * (4.0 / 3) * 3.14159265358979323846 * p.radius * p.radius * p.radius;
    particles_.place.push_back({p.position, p.radius});
    particles_.motion.push_back({p.velocity, mass});
    particles_.spin.push_back({p.spin, 0.4 * mass * p.radius * p.radius});
    if (has_bonds()) particles_.turn.push_back({1, 0, 0, 0});
    Load load;
    load.force = mass * scene_.gravity;
    particles_.load.push_back(load);
    if (has_bonds()) particles_.bond_load.push_back({});
    particles_.listed_at.push_back(p.position);
    particles_.losses.push_back({});
    particles_.id.push_back(p.id);
    particles_.block.push_back(block);
    booked_.exchanged += 0.5 * mass * norm2(p.velocity) + 0.2 * mass * p.radius * p.radius * norm2(p.spin) -
                         mass * dot(scene_.gravity, p.position);
  }
  if (!blocked) return;
  Block b{first, particle_count(), 0, 0, 0, 0, rock.id, rock.bonds.empty() ? block_broken : block_intact};
  b.first_bond = static_cast<Index>(bonds_.i.size());
  b.first_colour = static_cast<Index>(colour_begin_.size());
  if (has_bonds()) append_bonds(rock, first);
  b.end_bond = static_cast<Index>(bonds_.i.size());
  b.end_colour = static_cast<Index>(colour_begin_.size());
  extended(blocks_, b);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::append_bonds(const NewRock& rock, Index first_particle) {
  const Index first_bond = static_cast<Index>(bonds_.i.size());
  for (const NewBond& bond : rock.bonds) {
    const NewParticle &p = rock.particles[static_cast<std::size_t>(bond.i)],
                      &q = rock.particles[static_cast<std::size_t>(bond.j)];
    if (p.id >= q.id) throw BadInput("a bond joins particles in the wrong order; the lower id comes first");
    const Vec3d span = q.position - p.position;
    const Vec3d axis = (1 / norm(span)) * span;
    const Index i = first_particle + bond.i, j = first_particle + bond.j;
    const Motion &mi = particles_.motion[static_cast<std::size_t>(i)],
                 &mj = particles_.motion[static_cast<std::size_t>(j)];
    const Spin &si = particles_.spin[static_cast<std::size_t>(i)], &sj = particles_.spin[static_cast<std::size_t>(j)];
    bonds_.i.push_back(i);
    bonds_.j.push_back(j);
    bonds_.axis_x.push_back(static_cast<Real>(axis.x));
    bonds_.axis_y.push_back(static_cast<Real>(axis.y));
    bonds_.axis_z.push_back(static_cast<Real>(axis.z));
    bonds_.length.push_back(bond.length);
    bonds_.radius.push_back(static_cast<Real>(bond.radius));
    bonds_.arm.push_back(static_cast<Real>((bond.length + p.radius - q.radius) / (2 * bond.length)));
    bonds_.strength.push_back(static_cast<Real>(bond.strength));
    bonds_.sqrt_mass.push_back(static_cast<Real>(std::sqrt(mi.mass * mj.mass / (mi.mass + mj.mass))));
    bonds_.sqrt_inertia.push_back(static_cast<Real>(std::sqrt(si.inertia * sj.inertia / (si.inertia + sj.inertia))));
    bonds_.state.push_back(bond_glued);
  }
  counts_total_.bonds_intact += static_cast<std::int64_t>(rock.bonds.size());
  for (const Index colour : rock.colour_begin) colour_begin_.push_back(first_bond + colour);
  while (bonds_.i.size() % bond_alignment != 0) {
    for_each_bond_column([](auto& column) { column.push_back({}); }, bonds_);
    bonds_.i.back() = bonds_.j.back() = first_particle;
    bonds_.state.back() = bond_gone;
  }
}

/// Bonds by particle, room for the failures of a window, and flags.
template <class Exec, class Real>
void DemSolver<Exec, Real>::index_bonds() {
  std::vector<Index> begin(static_cast<std::size_t>(particle_count()) + 1, 0), row;
  const auto real = [&](std::size_t b) { return bonds_.state[b] != bond_gone; };
  for (std::size_t b = 0; b < bonds_.i.size(); ++b)
    if (real(b)) {
      ++begin[static_cast<std::size_t>(bonds_.i[b])];
      ++begin[static_cast<std::size_t>(bonds_.j[b])];
    }
  row.resize(static_cast<std::size_t>(Exec::exclusive_scan(particle_count(), begin.data())));
  std::vector<Index> next = begin;
  for (std::size_t b = 0; b < bonds_.i.size(); ++b)
    if (real(b)) {
      row[static_cast<std::size_t>(next[static_cast<std::size_t>(bonds_.i[b])]++)] = static_cast<Index>(b);
      row[static_cast<std::size_t>(next[static_cast<std::size_t>(bonds_.j[b])]++)] = static_cast<Index>(b);
    }
  bond_row_begin_ = std::move(begin);
  bond_row_ = std::move(row);
  events_.resize(bonds_.i.size());
}

/// Rows of the lists for particles that have just come: empty.
template <class Exec, class Real>
void DemSolver<Exec, Real>::resize_rows() {
  const auto rows = static_cast<std::size_t>(particle_count()) + 1;
  pairs_.row_begin.resize(rows, static_cast<Index>(pairs_.ends.size()));
  walls_.row_begin.resize(rows, static_cast<Index>(walls_.entries.size()));
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::remove(std::span<const ParticleId> ids) {
  if (ids.empty()) return;
  std::vector<ParticleId> leaving(ids.begin(), ids.end());
  std::sort(leaving.begin(), leaving.end());
  std::vector<Index> new_index(static_cast<std::size_t>(particle_count()), none);
  Index kept = 0;
  for (std::size_t n = 0; n < new_index.size(); ++n)
    if (!std::binary_search(leaving.begin(), leaving.end(), particles_.id[n])) new_index[n] = kept++;

  const EnergyTerms before = energy();
  const BondSums bonds_before = bond_sums();
  book_walls();
  keep_pairs(new_index, kept);
  keep_walls(new_index, kept);
  keep_bonds(new_index);
  keep_particles(new_index, kept);
  if (has_bonds()) index_bonds();
  listed_ = false;

  counts_total_.bonds_intact -= bonds_before.intact - bond_sums().intact;
  const EnergyTerms after = energy();
  const auto state = [](const EnergyTerms& e) { return e.kinetic + e.potential + e.contact_elastic + e.bond_elastic; };
  booked_.exchanged -= state(before) - state(after);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_particles(const Host<Index>& new_index, Index kept) {
  for (std::size_t n = 0; n < new_index.size(); ++n) {
    if (new_index[n] != none) continue;
    const Losses& lost = particles_.losses[n];
    booked_.bond_damping += lost.bond_damping;
    booked_.contact_damping += lost.contact_damping;
    booked_.friction += lost.bond_slip + lost.contact_slip;
  }
  for_each_particle_column(
      [&](bool needs_bonds, auto& column) {
        if (needs_bonds && !has_bonds()) return;
        for (std::size_t n = 0; n < new_index.size(); ++n)
          if (new_index[n] != none) column[static_cast<std::size_t>(new_index[n])] = column[n];
        column.resize(static_cast<std::size_t>(kept));
      },
      particles_);
}

/// Bonds of the particles that stay, block by block in their order; gone ones are left out.
template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_bonds(const Host<Index>& new_index) {
  Bonds<Buffer, Real> kept;
  std::vector<Block> blocks;
  std::vector<Index> colours, new_block(blocks_.size(), none);
  Index next_particle = 0;
  const auto at = [](auto& v, Index k) -> auto& {
    return v[static_cast<std::size_t>(k)];
  };
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    Block b = blocks_[k];
    const Block old = b;
    Index members = 0;
    next_particle = none;
    for (Index n = old.first_particle; n < old.end_particle; ++n)
      if (at(new_index, n) != none) {
        if (members++ == 0) next_particle = at(new_index, n);
      }
    if (members == 0) continue;
    b.first_particle = next_particle;
    b.end_particle = next_particle + members;
    b.first_bond = static_cast<Index>(kept.i.size());
    b.first_colour = static_cast<Index>(colours.size());
    for (Index c = old.first_colour; c < old.end_colour; ++c) {
      colours.push_back(static_cast<Index>(kept.i.size()));
      if (c + 1 == old.end_colour) break;
      for (Index n = at(colour_begin_, c); n < at(colour_begin_, c + 1); ++n) {
        const Index i = at(new_index, at(bonds_.i, n)), j = at(new_index, at(bonds_.j, n));
        if (at(bonds_.state, n) == bond_gone || i == none || j == none) continue;
        for_each_bond_column([&](auto& to, auto& from) { to.push_back(at(from, n)); }, kept, bonds_);
        kept.i.back() = i;
        kept.j.back() = j;
      }
    }
    while (kept.i.size() % bond_alignment != 0) {
      for_each_bond_column([](auto& column) { column.push_back({}); }, kept);
      kept.i.back() = kept.j.back() = b.first_particle;
      kept.state.back() = bond_gone;
    }
    b.end_bond = static_cast<Index>(kept.i.size());
    b.end_colour = static_cast<Index>(colours.size());
    new_block[k] = static_cast<Index>(blocks.size());
    blocks.push_back(b);
  }
  for (Index& block : particles_.block)
    if (block != none) block = at(new_block, block);
  bonds_ = std::move(kept);
  blocks_ = std::move(blocks);
  colour_begin_ = std::move(colours);
}

/// Pairs of the particles that stay, with their memory, under the new numbers.
template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_pairs(const Host<Index>& new_index, Index kept) {
  PairLists lists;
  lists.row_begin.assign(static_cast<std::size_t>(kept) + 1, 0);
  std::vector<Index> new_pair(pairs_.pairs.size(), none);
  for (std::size_t n = 0; n < pairs_.pairs.size(); ++n) {
    const Pair& pair = pairs_.pairs[n];
    const Index i = new_index[static_cast<std::size_t>(pair.i)], j = new_index[static_cast<std::size_t>(pair.j)];
    if (i == none || j == none) continue;
    new_pair[n] = static_cast<Index>(lists.pairs.size());
    lists.pairs.push_back({i, j, none});  // the bond is found again when the lists are rebuilt
    lists.memory.push_back(pairs_.memory[n]);
    lists.result.push_back(pairs_.result[n]);
    lists.touching.push_back(pairs_.touching[n]);
  }
  for (std::size_t n = 0; n < new_index.size(); ++n) {
    if (new_index[n] == none) continue;
    for (Index e = pairs_.row_begin[n]; e < pairs_.row_begin[n + 1]; ++e) {
      const PairEnd end = pairs_.ends[static_cast<std::size_t>(e)];
      const Index pair = new_pair[static_cast<std::size_t>(end.pair)];
      if (pair != none) lists.ends.push_back({pair, end.side});
    }
    lists.row_begin[static_cast<std::size_t>(new_index[n]) + 1] = static_cast<Index>(lists.ends.size());
  }
  pairs_ = std::move(lists);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_walls(const Host<Index>& new_index, Index kept) {
  WallLists lists;
  lists.row_begin.assign(static_cast<std::size_t>(kept) + 1, 0);
  for (std::size_t n = 0; n < new_index.size(); ++n) {
    if (new_index[n] == none) continue;
    for (auto e = static_cast<std::size_t>(walls_.row_begin[n]); e < static_cast<std::size_t>(walls_.row_begin[n + 1]);
         ++e) {
      WallEntry entry = walls_.entries[e];
      entry.particle = new_index[n];
      lists.entries.push_back(entry);
      lists.memory.push_back(walls_.memory[e]);
      lists.result.push_back(walls_.result[e]);
      lists.touching.push_back(walls_.touching[e]);
      lists.sums.push_back(walls_.sums[e]);
    }
    lists.row_begin[static_cast<std::size_t>(new_index[n]) + 1] = static_cast<Index>(lists.entries.size());
  }
  walls_ = std::move(lists);
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem_solver.hpp"

#include <algorithm>
#include <string>

// The state between two windows, out and in. Columns of particles and bonds follow from their visitors. Of the
// neighbour lists only what touches is kept: the rest is found again, and changes no bit.

namespace gyro {

template <>
struct RowOf<Sphere> : MadeOf<double> {};
template <>
struct RowOf<Motion> : MadeOf<double> {};
template <>
struct RowOf<AngularMotion> : MadeOf<double> {};
template <>
struct RowOf<Load> : MadeOf<double> {};
template <>
struct RowOf<LostWork> : MadeOf<double> {};
template <class T>
struct RowOf<Quat<T>> : MadeOf<T> {};
template <class T>
struct RowOf<Vec3<T>> : MadeOf<T> {};
template <>
struct RowOf<Block> : MadeOf<std::int32_t> {};
template <>
struct RowOf<Pair> : MadeOf<Index> {};
template <class Real>
struct RowOf<ContactHistory<Real>> : MadeOf<Real> {};
template <>
struct RowOf<WallEntry> : MadeOf<Index> {};
template <>
struct RowOf<WallPose> : MadeOf<double> {};
template <>
struct RowOf<WallSum> : MadeOf<std::int64_t> {};

/// A touch of a wall: what it remembers, and its normal.
template <class Real>
struct SavedTouch {
  ContactHistory<Real> contact;
  Vec3<Real> normal;
};
template <class Real>
struct RowOf<SavedTouch<Real>> : MadeOf<Real> {};

/// A broken bond as numbers; ids fit a double exactly.
struct SavedBreakage {
  double time, mode;
  Vec3d position;
  double rock, i, j, energy;
};
template <>
struct RowOf<SavedBreakage> : MadeOf<double> {};

template <class Exec, class Real>
SavedState DemSolver<Exec, Real>::save() const {
  SavedState s;
  for_each_particle_column(
      [&](const std::string& name, bool, const auto& column) { s.put("particles/" + name, Exec::host(column)); },
      particles_);
  for_each_bond_column([&](const std::string& name, const auto& column) { s.put("bonds/" + name, Exec::host(column)); },
                       bonds_);
  s.put("blocks/block", Exec::host(blocks_));
  s.put("blocks/colour_begin", Exec::host(colour_begin_));
  save_pairs(s);
  save_walls(s);
  s.put_one("dem/booked", booked_);
  s.put_one("dem/counts", counts_total_);
  s.put_one("dem/primed", std::uint8_t{primed_});
  std::vector<SavedBreakage> breakages;
  for (const Breakage& b : breakages_)
    breakages.push_back({b.time, static_cast<double>(b.mode), b.position, static_cast<double>(b.rock),
                         static_cast<double>(b.i), static_cast<double>(b.j), b.energy});
  s.put("dem/breakages", breakages);
  return s;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::save_pairs(SavedState& s) const {
  const auto& pairs = Exec::host(pairs_.pairs);
  const auto& history = Exec::host(pairs_.history);
  const auto& touching = Exec::host(pairs_.touching);
  Host<Pair> touching_pairs;
  Host<ContactHistory<Real>> remembered;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    if (!touching[n]) continue;
    touching_pairs.push_back({pairs[n].i, pairs[n].j, none});
    remembered.push_back(history[n]);
  }
  s.put("contacts/pair", touching_pairs);
  s.put("contacts/memory", remembered);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::save_walls(SavedState& s) const {
  const auto& entries = Exec::host(walls_.entries);
  const auto& history = Exec::host(walls_.history);
  const auto& touching = Exec::host(walls_.touching);
  Host<WallEntry> touching_entries;
  Host<std::int32_t> touches;
  Host<SavedTouch<Real>> remembered;
  for (std::size_t n = 0; n < entries.size(); ++n) {
    if (!touching[n]) continue;
    touching_entries.push_back(entries[n]);
    touches.push_back(history[n].count);
    for (int k = 0; k < history[n].count; ++k) remembered.push_back({history[n].contact[k], history[n].normal[k]});
  }
  s.put("walls/entry", touching_entries);
  s.put("walls/touches", touches);
  s.put("walls/memory", remembered);
  s.put("walls/pose", poses_now_);
  s.put("walls/pose_seen",
        host_table_.empty() ? poses_now_ : Host<WallPose>(host_table_.end() - surfaces_.count(), host_table_.end()));
  s.put("walls/sum", wall_sums_);
  s.put("walls/load", wall_loads_);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::restore(const SavedState& s) {
  const std::size_t particles = s.get<Sphere>("particles/position").size(), bonds = s.get<Index>("bonds/i").size();
  const auto take = [&](const std::string& name, std::size_t rows, auto& column) {
    using Row = std::remove_cvref_t<decltype(Exec::host(column)[0])>;
    Exec::upload(column, s.get<Row>(name, rows));
  };
  for_each_particle_column(
      [&](const std::string& name, bool needs_bonds, auto& column) {
        take("particles/" + name, needs_bonds && !has_bonds() ? 0 : particles, column);
      },
      particles_);
  for_each_bond_column([&](const std::string& name, auto& column) { take("bonds/" + name, bonds, column); }, bonds_);
  Exec::upload(blocks_, s.get<Block>("blocks/block"));
  Exec::upload(colour_begin_, s.get<Index>("blocks/colour_begin"));
  if (has_bonds()) index_bonds();
  Exec::upload(flags_, Host<std::int32_t>(flag_count, 0));
  restore_pairs(s);
  restore_walls(s);
  booked_ = s.get_one<EnergyTerms>("dem/booked");
  counts_total_ = s.get_one<Counts>("dem/counts");
  primed_ = s.get_one<std::uint8_t>("dem/primed") != 0;
  breakages_.clear();
  for (const SavedBreakage& b : s.get<SavedBreakage>("dem/breakages"))
    breakages_.push_back({b.time, static_cast<BreakMode>(b.mode), b.position, static_cast<RockId>(b.rock),
                          static_cast<ParticleId>(b.i), static_cast<ParticleId>(b.j), b.energy});
  listed_ = false;
}

/// Lists of what touches only: the next step finds the neighbours and carries the memory over.
template <class Exec, class Real>
void DemSolver<Exec, Real>::restore_pairs(const SavedState& s) {
  Host<Pair> pairs = s.get<Pair>("contacts/pair");
  const std::size_t count = pairs.size();
  pairs_.result.resize(count);
  pairs_.ends.resize(2 * count);
  Exec::upload(pairs_.history, s.get<ContactHistory<Real>>("contacts/memory", count));
  Exec::upload(pairs_.touching, Host<std::int8_t>(count, 1));
  Exec::upload(pairs_.pairs, std::move(pairs));
  list_ends();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::restore_walls(const SavedState& s) {
  Host<WallEntry> entries = s.get<WallEntry>("walls/entry");
  const std::size_t count = entries.size();
  const Host<std::int32_t> touches = s.get<std::int32_t>("walls/touches", count);
  const auto remembered = s.get<SavedTouch<Real>>(
      "walls/memory", static_cast<std::size_t>(std::accumulate(touches.begin(), touches.end(), 0)));
  Host<WallHistory<Real>> history(count);
  Host<Index> row_begin(static_cast<std::size_t>(particle_count()) + 1, 0);
  auto touch = remembered.begin();
  for (std::size_t n = 0; n < count; ++n) {
    history[n].count = touches[n];
    for (int k = 0; k < touches[n]; ++k, ++touch) {
      history[n].contact[k] = touch->contact;
      history[n].normal[k] = touch->normal;
    }
    ++row_begin[static_cast<std::size_t>(entries[n].particle) + 1];
  }
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  walls_.result.resize(count);
  walls_.carried_over.resize(count);
  Exec::upload(walls_.history, std::move(history));
  Exec::upload(walls_.touching, Host<std::int8_t>(count, 1));
  Exec::upload(walls_.sums, Host<WallSum>(count));
  Exec::upload(walls_.entries, std::move(entries));
  Exec::upload(walls_.row_begin, std::move(row_begin));
  poses_now_ = s.get<WallPose>("walls/pose", scene_.walls.size());
  host_table_ = s.get<WallPose>("walls/pose_seen", scene_.walls.size());
  Exec::upload(pose_table_, host_table_);
  poses_ = pose_table_.data();
  wall_loads_ = s.get<WallLoad>("walls/load", scene_.walls.size());
  wall_sums_ = s.get<WallSum>("walls/sum", scene_.walls.size());
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/candidate_list.hpp"
#include "core/dem/list_rows.hpp"
#include "core/kernels/neighbours.hpp"

#include <utility>

namespace gyro {

/// Owns the pairs of particles that may touch while they stay in their close bounds, with their contact history and
/// their forces.
template <class Exec, class Real>
class PairList {
 public:
  using Store = ParticleStore<Exec, Real>;

  /// @param with_extra  the contact law keeps ExtraHistory
  explicit PairList(bool with_extra) : with_extra_(with_extra) {}

  Index count() const { return static_cast<Index>(now_.pair.size()); }
  PairView<Real> view() { return view_of<PairView<Real>>(now_); }
  ConstPairView<Real> read() const { return view_of<ConstPairView<Real>>(now_); }

  /// Finds the pairs among the candidates; those that touched keep their history.
  /// @param bounds  close bounds of all particles
  void find(Exec& exec, const Store& rock, const CandidateTable& candidates, const Sphere* bounds) {
    const Index particles = rock.count();
    first_pair_.resize(static_cast<std::size_t>(particles) + 1);
    FindPairs find{rock.read(), rock.bond_index(), bounds, candidates, {first_pair_.data(), nullptr}};
    exec.for_each("count pairs", particles, find);
    const auto total = static_cast<std::size_t>(exec.exclusive_scan(particles, first_pair_.data()));
    std::swap(now_, old_);
    now_.at.swap(old_.at);  // only one list needs what belongs to ends
    now_.load.swap(old_.load);
    now_.loaded.swap(old_.loaded);
    now_.dashpot.swap(old_.dashpot);
    Exec::renew(now_.pair, total);
    Exec::renew(now_.history, total);
    if (with_extra_) Exec::renew(now_.extra, total);
    Exec::renew(now_.touching, total);
    find.rows.entries = now_.pair.data();
    if (total > 0) exec.for_each("find pairs", particles, find);
    list_ends(exec, rock);
    exec.for_each("carry history", count(),
                  CarryHistory<Real>{view(), view_of<ConstPairView<Real>>(old_), with_extra_});
  }

  /// Empty rows for particles that have just come.
  void extend_rows(Index particles) { gyro::extend_rows<Exec>(now_.row_begin, particles, now_.ends.size()); }

  /// Pairs of the particles that stay, with their history, under the new indices. Their bonds, and the places and loads
  /// of their ends, are found again when the list is rebuilt.
  void rearrange(const NewPlaces& places) {
    const auto& pairs = Exec::host(now_.pair);
    std::vector<Pair> kept;
    std::vector<Index> source, new_pair(pairs.size(), none);
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      const Index i = places.new_index[static_cast<std::size_t>(pairs[n].i)],
                  j = places.new_index[static_cast<std::size_t>(pairs[n].j)];
      if (i == none || j == none) continue;
      new_pair[n] = static_cast<Index>(kept.size());
      kept.push_back({i, j, none});
      source.push_back(static_cast<Index>(n));
    }
    keep_ends(places, new_pair);
    Exec::keep(now_.history, source);
    if (with_extra_) Exec::keep(now_.extra, source);
    Exec::keep(now_.touching, source);
    Exec::upload(now_.pair, std::move(kept));
  }

  /// Only what touches is saved: the rest is found again.
  void save(SavedState& to) const {
    const auto& touching = Exec::host(now_.touching);
    to.put("contacts/pair", where(touching, Exec::host(now_.pair)));
    to.put("contacts/history", where(touching, Exec::host(now_.history)));
    if (with_extra_) to.put("contacts/extra", where(touching, Exec::host(now_.extra)));
  }
  /// @throws BadInput as SavedState::get
  void restore(Exec& exec, const SavedState& from, const Store& rock) {
    std::vector<Pair> pairs = from.get<Pair>("contacts/pair");
    const std::size_t count = pairs.size();
    Exec::upload(now_.history, from.get<ContactHistory<Real>>("contacts/history", count));
    if (with_extra_) Exec::upload(now_.extra, from.get<ExtraHistory<Real>>("contacts/extra", count));
    Exec::upload(now_.touching, std::vector<std::int8_t>(count, 1));
    Exec::upload(now_.pair, std::move(pairs));
    list_ends(exec, rock);
  }

 private:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  /// The two ends of each pair, in the rows of its particles.
  void list_ends(Exec& exec, const Store& rock) {
    const Index n = rock.count(), pairs = count();
    const auto ends = 2 * static_cast<std::size_t>(pairs);
    Exec::renew(now_.ends, ends);
    const auto rows = static_cast<std::size_t>(n) + 1;
    const auto clear = [rows](auto& counts) {  // what a buffer gains is zero
      counts.resize(0);
      counts.resize(rows);
    };
    clear(now_.row_begin);
    exec.for_each("count ends", pairs, EnterEnds{now_.pair.data(), now_.row_begin.data(), nullptr, nullptr});
    exec.exclusive_scan(n, now_.row_begin.data());
    clear(entered_);
    exec.for_each("enter ends", pairs,
                  EnterEnds{now_.pair.data(), entered_.data(), now_.row_begin.data(), now_.ends.data()});
    exec.for_each("sort rows", n, SortRow{rock.read(), now_.pair.data(), now_.row_begin.data(), now_.ends.data()});
    Exec::renew(now_.at, static_cast<std::size_t>(pairs));
    exec.for_each("locate ends", 2 * pairs, LocateEnds{now_.ends.data(), now_.at.data()});
    Exec::renew(now_.load, ends);
    Exec::renew(now_.loaded, ends);
    Exec::renew(now_.dashpot, ends);
  }

  void keep_ends(const NewPlaces& places, const std::vector<Index>& new_pair) {
    const auto& ends = Exec::host(now_.ends);
    const auto& row_begin = Exec::host(now_.row_begin);
    std::vector<PairEnd> kept;
    std::vector<Index> rows(1, 0);
    for (const Index old : places.old_index) {
      const auto n = static_cast<std::size_t>(old);
      for (Index e = row_begin[n]; e < row_begin[n + 1]; ++e) {
        const PairEnd end = ends[static_cast<std::size_t>(e)];
        const Index pair = new_pair[static_cast<std::size_t>(end.pair)];
        if (pair != none) kept.push_back({pair, end.side});
      }
      rows.push_back(static_cast<Index>(kept.size()));
    }
    Exec::upload(now_.ends, std::move(kept));
    Exec::upload(now_.row_begin, std::move(rows));
  }

  bool with_extra_;
  Pairs<Buffer, Real> now_, old_;  ///< two, so that history is carried from the old to the new
  Buffer<Index> first_pair_, entered_;
};

}  // namespace gyro

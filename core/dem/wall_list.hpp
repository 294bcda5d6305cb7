// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/list_rows.hpp"
#include "core/dem/particle_store.hpp"
#include "core/kernels/wall_lists.hpp"

#include <numeric>
#include <utility>

namespace gyro {

/// Owns the particles that may touch a wall, with their contact history and their forces.
template <class Exec, class Real>
class WallList {
 public:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;
  using Store = ParticleStore<Exec, Real>;

  /// @param with_extra  the contact law keeps ExtraHistory
  explicit WallList(bool with_extra) : with_extra_(with_extra) {}

  Index count() const { return static_cast<Index>(now_.entry.size()); }
  WallPairView<Real> view() { return view_of<WallPairView<Real>>(now_); }
  ConstWallPairView<Real> read() const { return view_of<ConstWallPairView<Real>>(now_); }
  const Buffer<WallEntry>& entries() const { return now_.entry; }

  /// Finds all walls that a particle may touch while it stays in its bound; those that touched keep their history.
  /// @param bounds  wide bounds of all particles
  /// @param ways    that each wall may move meanwhile [m]
  void find(Exec& exec, const Store& rock, const WallsNow& walls, const Sphere* bounds, const double* ways) {
    const Index particles = rock.count();
    std::swap(now_, old_);
    now_.row_begin.resize(static_cast<std::size_t>(particles) + 1);
    FindWalls find{bounds, walls, ways, {now_.row_begin.data(), nullptr}};
    exec.for_each("count walls", particles, find);
    const auto total = static_cast<std::size_t>(exec.exclusive_scan(particles, now_.row_begin.data()));
    now_.entry.resize(total);
    now_.touch.resize(total);
    now_.history.resize(total);
    if (with_extra_) now_.extra.resize(total);
    now_.result.resize(total);
    now_.touching.resize(total);
    find.rows.entries = now_.entry.data();
    if (total > 0) exec.for_each("find walls", particles, find);
    measure(exec, {.p = rock.read(),
                   .walls = walls,
                   .bounds = bounds,
                   .ways = ways,
                   .entry = now_.entry.data(),
                   .clearance = nullptr,
                   .begin = nullptr});
    exec.for_each("carry wall history", count(),
                  CarryWallHistory<Real>{view(), view_of<ConstWallPairView<Real>>(old_), with_extra_});
  }

  /// Empty rows for particles that have just come.
  void extend_rows(Index particles) { gyro::extend_rows<Exec>(now_.row_begin, particles, now_.entry.size()); }

  /// Entries of the particles that stay, with their history, under the new indices.
  void rearrange(const NewPlaces& places) {
    const auto& entries = Exec::host(now_.entry);
    const auto& row_begin = Exec::host(now_.row_begin);
    std::vector<WallEntry> kept;
    std::vector<Index> source, rows(1, 0);
    for (std::size_t k = 0; k < places.old_index.size(); ++k) {
      const auto n = static_cast<std::size_t>(places.old_index[k]);
      for (Index e = row_begin[n]; e < row_begin[n + 1]; ++e) {
        WallEntry entry = entries[static_cast<std::size_t>(e)];
        entry.particle = static_cast<Index>(k);
        kept.push_back(entry);
        source.push_back(e);
      }
      rows.push_back(static_cast<Index>(kept.size()));
    }
    Exec::keep(now_.history, source);
    if (with_extra_) Exec::keep(now_.extra, source);
    Exec::keep(now_.result, source);
    Exec::keep(now_.touching, source);
    Exec::upload(now_.entry, std::move(kept));
    Exec::upload(now_.row_begin, std::move(rows));
  }

  /// Only what touches is saved: the rest is found again.
  void save(SavedState& to) const {
    const auto& touching = Exec::host(now_.touching);
    const std::vector<WallHistory<Real>> history = where(touching, Exec::host(now_.history));
    std::vector<std::int32_t> counts;
    std::vector<WallContact<Real>> contacts;
    for (const WallHistory<Real>& h : history) {
      counts.push_back(h.count);
      contacts.insert(contacts.end(), h.contact, h.contact + h.count);
    }
    to.put("wall_contacts/entry", where(touching, Exec::host(now_.entry)));
    to.put("wall_contacts/count", counts);
    to.put("wall_contacts/contact", contacts);
    if (with_extra_) to.put("wall_contacts/extra", extra_of(touching));
  }
  /// @throws BadInput as SavedState::get
  void restore(const SavedState& from, Index particles) {
    std::vector<WallEntry> entries = from.get<WallEntry>("wall_contacts/entry");
    const std::size_t count = entries.size();
    const std::vector<std::int32_t> counts = from.get<std::int32_t>("wall_contacts/count", count);
    const auto contacts = from.get<WallContact<Real>>(
        "wall_contacts/contact", static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), 0)));
    std::vector<WallHistory<Real>> history(count);
    std::vector<Index> row_begin(static_cast<std::size_t>(particles) + 1, 0);
    auto contact = contacts.begin();
    for (std::size_t n = 0; n < count; ++n) {
      history[n].count = counts[n];
      std::copy_n(contact, counts[n], history[n].contact);
      contact += counts[n];
      ++row_begin[static_cast<std::size_t>(entries[n].particle) + 1];
    }
    std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
    now_.result.resize(count);
    if (with_extra_) Exec::upload(now_.extra, restored_extra(from, counts));
    Exec::upload(now_.history, std::move(history));
    Exec::upload(now_.touching, std::vector<std::int8_t>(count, 1));
    Exec::upload(now_.entry, std::move(entries));
    Exec::upload(now_.row_begin, std::move(row_begin));
  }

 private:
  void measure(Exec& exec, MeasureWalls kernel) {
    now_.clearance.resize(now_.entry.size());
    triangle_begin_.resize(now_.entry.size() + 1);
    kernel.clearance = now_.clearance.data();
    kernel.begin = triangle_begin_.data();
    exec.for_each("count triangles", count(), kernel);
    const auto triangles = static_cast<std::size_t>(exec.exclusive_scan(count(), triangle_begin_.data()));
    now_.triangle.resize(triangles + 1);  // a pointer to them is not null
    now_.triangle_gap.resize(triangles + 1);
    kernel.triangle = now_.triangle.data();
    kernel.triangle_gap = now_.triangle_gap.data();
    exec.for_each("list triangles", count(), kernel);
  }

  /// Of the contacts of touching entries, one after the other.
  std::vector<ExtraHistory<Real>> extra_of(const std::vector<std::int8_t>& touching) const {
    const std::vector<WallHistory<Real>> history = where(touching, Exec::host(now_.history));
    const std::vector<WallExtraHistory<Real>> extra = where(touching, Exec::host(now_.extra));
    std::vector<ExtraHistory<Real>> all;
    for (std::size_t n = 0; n < history.size(); ++n)
      all.insert(all.end(), extra[n].contact, extra[n].contact + history[n].count);
    return all;
  }
  static std::vector<WallExtraHistory<Real>> restored_extra(const SavedState& from,
                                                            const std::vector<std::int32_t>& counts) {
    const auto all = from.get<ExtraHistory<Real>>(
        "wall_contacts/extra", static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), 0)));
    std::vector<WallExtraHistory<Real>> extra(counts.size());
    auto next = all.begin();
    for (std::size_t n = 0; n < counts.size(); ++n) {
      std::copy_n(next, counts[n], extra[n].contact);
      next += counts[n];
    }
    return extra;
  }

  bool with_extra_;
  Buffer<Index> triangle_begin_;
  WallPairs<Buffer, Real> now_, old_;  ///< two, so that history is carried from the old to the new
};

}  // namespace gyro

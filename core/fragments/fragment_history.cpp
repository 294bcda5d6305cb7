// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fragment_history.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gyro {
namespace {

/// Place of a key in ascending keys, or none.
Index place_of(const std::vector<ParticleId>& keys, ParticleId key) {
  const auto found = std::lower_bound(keys.begin(), keys.end(), key);
  return found == keys.end() || *found != key ? none : static_cast<Index>(found - keys.begin());
}

/// Row numbers in ascending order of keys.
template <class KeyOf>
std::vector<std::size_t> order_by(std::size_t rows, const KeyOf& key_of) {
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key_of(a) < key_of(b); });
  return order;
}

}  // namespace

FragmentSnapshot FragmentHistory::look(double time, std::vector<FragmentRecord> records,
                                       const ParticleSnapshot& particles) {
  FragmentSnapshot now;
  now.record = std::move(records);
  for (const FragmentRecord& r : now.record) {
    const Index before = place_of(state_.fragment, r.id), particle = place_of(state_.particle, r.id);
    const auto f = static_cast<std::size_t>(before), p = static_cast<std::size_t>(particle);
    const bool unchanged = before != none && state_.particles[f] == r.particles;
    const bool broken = !unchanged && particle != none;
    now.parent.push_back(unchanged ? state_.parent[f] : broken ? state_.label[p] : r.id);
    now.formed.push_back(unchanged ? state_.formed[f] : broken ? time : r.fed);
  }
  note(now, particles);
  return now;
}

void FragmentHistory::note(const FragmentSnapshot& now, const ParticleSnapshot& particles) {
  state_ = {};
  for (const std::size_t n : order_by(particles.size(), [&](std::size_t k) { return particles.id[k]; })) {
    state_.particle.push_back(particles.id[n]);
    state_.label.push_back(particles.id[static_cast<std::size_t>(particles.fragment[n])]);
  }
  for (const std::size_t n : order_by(now.size(), [&](std::size_t k) { return now.record[k].id; })) {
    state_.fragment.push_back(now.record[n].id);
    state_.particles.push_back(now.record[n].particles);
    state_.parent.push_back(now.parent[n]);
    state_.formed.push_back(now.formed[n]);
  }
}

}  // namespace gyro

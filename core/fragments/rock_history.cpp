// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/rock_history.hpp"

#include "core/fragments/fragment_table.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>
#include <utility>

namespace gyro {
namespace {

/// Place of a key in ascending keys, or none.
template <class Key>
Index place_of(const std::vector<Key>& keys, Key key) {
  const auto found = std::lower_bound(keys.begin(), keys.end(), key);
  return found == keys.end() || *found != key ? none : static_cast<Index>(found - keys.begin());
}

/// Brings keys into ascending order, each with its value. New keys are nearly always the largest.
template <class Key>
void sort(std::vector<Key>& keys, std::vector<double>& values) {
  if (std::is_sorted(keys.begin(), keys.end())) return;
  std::vector<std::pair<Key, double>> rows;
  for (std::size_t k = 0; k < keys.size(); ++k) rows.emplace_back(keys[k], values[k]);
  std::sort(rows.begin(), rows.end());
  for (std::size_t k = 0; k < keys.size(); ++k) std::tie(keys[k], values[k]) = rows[k];
}

/// Drops the keys that are not to be kept. @param keep  of a key
template <class Key, class Keep>
void keep_if(std::vector<Key>& keys, std::vector<double>& values, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (!keep(keys[k])) continue;
    keys[kept] = keys[k];
    values[kept++] = values[k];
  }
  keys.resize(kept);
  values.resize(kept);
}

}  // namespace

void RockHistory::feed(std::span<const NewRock> rocks) {
  for (const NewRock& rock : rocks) {
    double mass = 0;
    for (const NewParticle& p : rock.particles) {
      mass += p.density * 4 / 3 * std::numbers::pi * p.radius * p.radius * p.radius;
      state_.particle.push_back(p.id);
      state_.energy.push_back(0);
    }
    if (rock.id == none) continue;  // spheres that belong to no rock: nothing broke off them
    state_.rock.push_back(rock.id);
    state_.size.push_back(equal_mass_diameter(mass, rock_density_));
  }
  sort(state_.particle, state_.energy);
  sort(state_.rock, state_.size);
}

void RockHistory::give(ParticleId id, double energy) {
  if (const Index k = place_of(state_.particle, id); k != none) state_.energy[static_cast<std::size_t>(k)] += energy;
}

void RockHistory::add(std::span<const Breakage> broken) {
  for (const Breakage& b : broken) {
    give(b.i, 0.5 * b.energy);
    give(b.j, 0.5 * b.energy);
  }
}

void RockHistory::remove(std::span<const ParticleId> gone, const ParticleSnapshot& particles) {
  const auto is_gone = [&](ParticleId id) { return std::binary_search(gone.begin(), gone.end(), id); };
  keep_if(state_.particle, state_.energy, [&](ParticleId id) { return !is_gone(id); });
  std::vector<RockId> left;
  for (std::size_t n = 0; n < particles.size(); ++n)
    if (!is_gone(particles.id[n])) left.push_back(particles.rock[n]);
  std::sort(left.begin(), left.end());
  keep_if(state_.rock, state_.size, [&](RockId rock) { return std::binary_search(left.begin(), left.end(), rock); });
}

std::vector<double> RockHistory::energies(const ParticleSnapshot& particles) const {
  std::vector<double> energies(particles.size());
  std::size_t k = 0;
  for (std::size_t n = 0; n < particles.size(); ++n) {  // both are in the order of ids
    while (k < state_.particle.size() && state_.particle[k] < particles.id[n]) ++k;
    if (k < state_.particle.size() && state_.particle[k] == particles.id[n]) energies[n] = state_.energy[k];
  }
  return energies;
}

double RockHistory::size_of(RockId rock) const {
  const Index k = place_of(state_.rock, rock);
  return k == none ? 0 : state_.size[static_cast<std::size_t>(k)];
}

}  // namespace gyro

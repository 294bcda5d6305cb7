// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/product.hpp"

#include <algorithm>

namespace gyro {

Product::Product(double rock_density, std::optional<ConcaveOutline> concave, std::vector<double> sieves)
    : Product(rock_density, std::move(concave), std::move(sieves), State{}) {}

Product::Product(double rock_density, std::optional<ConcaveOutline> concave, std::vector<double> sieves, State state)
    : rock_density_(rock_density), concave_(std::move(concave)), sieves_(std::move(sieves)), state_(std::move(state)) {
  state_.sieve_mass.resize(sieves_.size() + 1);
}

bool Product::has_left(ParticleId id) const {
  return id < state_.place.size() && state_.place[id] != in_chamber;
}

/// Whether a fragment lies below the rim and wholly outside of the concave.
bool Product::is_outside(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles) const {
  if (!concave_ || !(table.rows[row].highest < concave_->rim())) return false;
  return std::ranges::all_of(table.members_of(row), [&](Index m) {
    return concave_->outside(particles.position[static_cast<std::size_t>(m)]);
  });
}

void Product::mark(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles, Place place) {
  for (const Index m : table.members_of(row)) {
    const ParticleId id = particles.id[static_cast<std::size_t>(m)];
    if (id >= state_.place.size()) state_.place.resize(std::size_t{id} + 1, in_chamber);
    state_.place[id] = place;
  }
}

void Product::count_discharged(const FragmentRecord& f) {
  ++state_.fragments;
  state_.particles += f.particles;
  state_.mass += f.mass;
  state_.sieve_mass[sieve_of(sieves_, f.size)] += f.mass;
  if (f.particles == 1) {
    ++state_.singles;
    state_.singles_mass += f.mass;
  }
}

std::vector<FragmentRecord> Product::update(const FragmentTable& table, const ParticleSnapshot& particles) {
  std::vector<FragmentRecord> left;
  for (std::size_t row = 0; row < table.size(); ++row) {
    // Bonds never heal, so either all particles of a fragment have been counted or none.
    const Fragment& f = table.rows[row];
    if (has_left(particles.id[static_cast<std::size_t>(f.first_particle)])) continue;
    const bool outside = is_outside(table, row, particles);
    if (!outside && !(f.highest < 0)) continue;
    FragmentRecord& record = left.emplace_back(record_of(table, row, particles, rock_density_));
    record.place = outside ? escaped : discharged;
    mark(table, row, particles, record.place);
    if (outside) {
      state_.escaped_particles += f.particles;
      state_.escaped_mass += f.mass;
    } else {
      count_discharged(record);
    }
  }
  return left;
}

std::vector<ParticleId> Product::removable(const FragmentTable& table, const ParticleSnapshot& particles,
                                           double depth) const {
  std::vector<ParticleId> ids;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto first = static_cast<std::size_t>(table.rows[row].first_particle);
    if (!(table.rows[row].highest < -depth) || !has_left(particles.id[first])) continue;
    for (const Index m : table.members_of(row)) ids.push_back(particles.id[static_cast<std::size_t>(m)]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::int64_t Product::inside(const ParticleSnapshot& particles) const {
  return std::count_if(particles.id.begin(), particles.id.end(), [&](ParticleId id) { return !has_left(id); });
}

ProductRow Product::row(double time) const {
  return SieveTally{state_.sieve_mass, state_.particles, state_.fragments, state_.mass, state_.singles_mass}.row(
      sieves_, time);
}

}  // namespace gyro

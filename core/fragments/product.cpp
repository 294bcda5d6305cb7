// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/product.hpp"

#include <algorithm>

namespace gyro {

Product::Product(double rock_density) : rock_density_(rock_density) {
  state_.sieve_mass.assign(sieve_series().size() + 1, 0.0);
}

Product::Product(double rock_density, State state) : rock_density_(rock_density), state_(std::move(state)) {}

bool Product::is_discharged(ParticleId id) const {
  return id < state_.discharged.size() && state_.discharged[id] != 0;
}

void Product::count(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles) {
  const Fragment& f = table.rows[row];
  for (const Index m : table.members_of(row)) {
    const ParticleId id = particles.id[static_cast<std::size_t>(m)];
    if (id >= state_.discharged.size()) state_.discharged.resize(std::size_t{id} + 1, 0);
    state_.discharged[id] = 1;
  }
  ++state_.fragments;
  state_.particles += f.particles;
  state_.mass += f.mass;
  state_.sieve_mass[sieve_of(sieve_size(table, row, particles, rock_density_))] += f.mass;
  if (f.particles == 1) {
    ++state_.singles;
    state_.singles_mass += f.mass;
  }
}

void Product::update(const FragmentTable& table, const ParticleSnapshot& particles) {
  for (std::size_t row = 0; row < table.size(); ++row) {
    // Bonds never heal, so either all particles of a fragment have been counted or none.
    const auto first = static_cast<std::size_t>(table.rows[row].first_particle);
    if (table.rows[row].highest < 0 && !is_discharged(particles.id[first])) count(table, row, particles);
  }
}

std::vector<ParticleId> Product::removable(const FragmentTable& table, const ParticleSnapshot& particles,
                                           double depth) const {
  std::vector<ParticleId> ids;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto first = static_cast<std::size_t>(table.rows[row].first_particle);
    if (!(table.rows[row].highest < -depth) || !is_discharged(particles.id[first])) continue;
    for (const Index m : table.members_of(row)) ids.push_back(particles.id[static_cast<std::size_t>(m)]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::int64_t Product::inside(const ParticleSnapshot& particles) const {
  return std::count_if(particles.id.begin(), particles.id.end(), [&](ParticleId id) { return !is_discharged(id); });
}

ProductRow Product::row(double time) const {
  return SieveTally{state_.sieve_mass, state_.particles, state_.fragments, state_.mass, state_.singles_mass}.row(time);
}

}  // namespace gyro

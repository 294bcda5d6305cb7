// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/hold_up.hpp"

#include <algorithm>
#include <optional>

namespace gyro {
namespace {

/// A fragment of several particles that is in the chamber.
struct Held {
  ParticleId first;
  std::size_t row;  ///< of the table
};

std::vector<Held> held_fragments(const FragmentTable& table, const ParticleSnapshot& particles,
                                 const Product& product) {
  std::vector<Held> held;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const ParticleId first = particles.id[static_cast<std::size_t>(table.rows[k].first_particle)];
    if (table.rows[k].particles > 1 && !product.has_left(first)) held.push_back({first, k});
  }
  std::sort(held.begin(), held.end(), [](const Held& a, const Held& b) { return a.first < b.first; });
  return held;
}

/// Row of a fragment in the columns; their number without it.
std::size_t row_of(const HoldUp::State& known, ParticleId first) {
  const auto found = std::lower_bound(known.first.begin(), known.first.end(), first);
  const bool there = found != known.first.end() && *found == first;
  return there ? static_cast<std::size_t>(found - known.first.begin()) : known.first.size();
}

std::optional<double> known_size(const HoldUp::State& known, ParticleId first, Index particles) {
  const std::size_t k = row_of(known, first);
  if (k == known.first.size()) return std::nullopt;
  return known.particles[k] == particles ? std::optional(known.size[k]) : std::nullopt;
}

}  // namespace

HoldUp::HoldUp(double rock_density, std::vector<double> sieves) : HoldUp(rock_density, std::move(sieves), State{}) {}

HoldUp::HoldUp(double rock_density, std::vector<double> sieves, State state)
    : rock_density_(rock_density), sieves_(std::move(sieves)), state_(std::move(state)) {}

void HoldUp::update(const FragmentTable& table, const ParticleSnapshot& particles, const Product& product) {
  State now;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Fragment& f = table.rows[k];
    const ParticleId first = particles.id[static_cast<std::size_t>(f.first_particle)];
    if (f.particles == 1 && !product.has_left(first))
      now.tally.add(sieves_, equal_mass_diameter(f.mass, rock_density_), f.mass, 1);
  }
  for (const auto& [first, row] : held_fragments(table, particles, product)) {
    const Fragment& f = table.rows[row];
    const std::optional<double> known = known_size(state_, first, f.particles);
    now.first.push_back(first);
    now.particles.push_back(f.particles);
    now.size.push_back(known ? *known : sieve_size(table, row, particles, rock_density_));
    now.tally.add(sieves_, now.size.back(), f.mass, f.particles);
  }
  state_ = std::move(now);
}

double HoldUp::size_of(ParticleId first) const {
  return state_.size.at(row_of(state_, first));
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/product.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

constexpr int finest = -14, coarsest = 6;

std::vector<double> make_series() {
  std::vector<double> sizes;
  for (int k = finest; k <= coarsest; ++k) sizes.push_back(0.125 * std::exp2(0.5 * k));
  return sizes;
}

/// The finest sieve that lets this size through; the number of sieves when none does.
std::size_t sieve_of(double size) {
  const std::vector<double>& sieves = sieve_series();
  return static_cast<std::size_t>(std::lower_bound(sieves.begin(), sieves.end(), size) - sieves.begin());
}

}  // namespace

const std::vector<double>& sieve_series() {
  static const std::vector<double> sizes = make_series();
  return sizes;
}

std::optional<double> passing_size(const std::vector<double>& passing, double share) {
  const std::vector<double>& sieves = sieve_series();
  const auto above = std::lower_bound(passing.begin(), passing.end(), share);
  if (above == passing.begin() || above == passing.end()) return std::nullopt;
  const auto k = static_cast<std::size_t>(above - passing.begin());
  const double part = (share - passing[k - 1]) / (passing[k] - passing[k - 1]);
  return sieves[k - 1] * std::pow(sieves[k] / sieves[k - 1], part);
}

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
    // Bonds never heal: the particles of a fragment have all been counted, or none.
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
  ProductRow row;
  row.time = time;
  row.mass = state_.mass;
  row.particles = state_.particles;
  row.fragments = state_.fragments;
  row.passing.assign(sieve_series().size(), 0.0);
  if (state_.fragments == 0) return row;
  row.singles_share = state_.singles_mass / state_.mass;
  double total = 0, finer = 0;
  for (const double m : state_.sieve_mass) total += m;
  for (std::size_t k = 0; k < row.passing.size(); ++k) {
    finer += state_.sieve_mass[k];
    row.passing[k] = finer / total;
  }
  row.p80 = passing_size(row.passing, 0.8);
  row.p50 = passing_size(row.passing, 0.5);
  return row;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fines.hpp"

#include <algorithm>

namespace gyro {

void FinesTally::add(const std::vector<double>& sieves, const FragmentFines& curve, double size, double fragment_mass) {
  const FragmentOrigin& origin = curve.origin();
  sieve_mass.resize(sieves.size() + 1);
  mass += fragment_mass;
  energy += origin.energy * fragment_mass;
  t10_mass += curve.t10().value_or(0) * fragment_mass;
  if (curve.t10().value_or(0) > usual_t10) beyond += fragment_mass;
  double below = 0;  // mass finer than the sieve before
  if (curve.any()) {
    for (std::size_t k = 0; k < sieves.size() && sieves[k] < origin.resolution; ++k) {
      const double finer = fragment_mass * curve.finer_than(sieves[k]);
      sieve_mass[k] += finer - below;
      below = finer;
    }
    const double finer = fragment_mass * curve.finer_than(origin.resolution);
    sieve_mass[sieve_of(sieves, origin.resolution)] += finer - below;
    fines += finer;
    below = finer;
  }
  sieve_mass[sieve_of(sieves, size)] += fragment_mass - below;
}

FinesRow FinesTally::row(const std::vector<double>& sieves, const FinesLaw& law) const {
  const ProductRow curve = SieveTally{.sieve_mass = sieve_mass, .mass = mass}.row(sieves, 0);
  FinesRow row{.passing = curve.passing, .p80 = curve.p80, .p50 = curve.p50};
  if (!(mass > 0)) return row;
  row.share = fines / mass;
  row.energy = energy / mass;
  if (!std::holds_alternative<BreakageFines>(law)) return row;
  row.t10 = t10_mass / mass;
  row.beyond_share = beyond / mass;
  return row;
}

Fines::Fines(const FinesLaw& law, double rock_density, std::vector<double> sieves, State state)
    : law_(law),
      rock_density_(rock_density),
      sieves_(std::move(sieves)),
      history_(rock_density, std::move(state.history)),
      product_(std::move(state.product)),
      hold_up_(std::move(state.hold_up)) {
  product_.sieve_mass.resize(sieves_.size() + 1);
}

FragmentOrigin Fines::origin_of(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles,
                                const std::vector<double>& energies) const {
  const Fragment& f = table.rows[row];
  double heaviest = 0, energy = 0;
  for (const Index m : table.members_of(row)) {
    heaviest = std::max(heaviest, particles.mass[static_cast<std::size_t>(m)]);
    energy += energies[static_cast<std::size_t>(m)];
  }
  return {.rock_size = history_.size_of(f.rock),
          .resolution = equal_mass_diameter(heaviest, rock_density_),
          .energy = energy / f.mass,
          .single = f.particles == 1};
}

void Fines::update(const FragmentTable& table, const ParticleSnapshot& particles, std::span<const FragmentRecord> left,
                   const Product& product, const HoldUp& hold_up) {
  const std::vector<double> energies = history_.energies(particles);
  hold_up_ = {};
  std::vector<Known> known;
  auto before = known_.begin();
  auto gone = left.begin();  // in the order of the table
  for (std::size_t row = 0; row < table.size(); ++row) {
    const Fragment& f = table.rows[row];
    const ParticleId first = particles.id[static_cast<std::size_t>(f.first_particle)];
    if (gone != left.end() && gone->id == first) {
      if (gone->place == Product::discharged)
        product_.add(sieves_, FragmentFines(law_, origin_of(table, row, particles, energies)), gone->size, f.mass);
      ++gone;
    } else if (!product.has_left(first)) {
      const double size = f.particles == 1 ? equal_mass_diameter(f.mass, rock_density_) : hold_up.size_of(first);
      const FragmentOrigin origin = origin_of(table, row, particles, energies);
      while (before != known_.end() && before->first < first) ++before;
      const bool same = before != known_.end() && before->first == first && before->fines.origin() == origin;
      known.push_back({first, same ? before->fines : FragmentFines(law_, origin)});
      hold_up_.add(sieves_, known.back().fines, size, f.mass);
    }
  }
  known_ = std::move(known);
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fragment_record.hpp"

namespace gyro {

FragmentRecord record_of(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles,
                         double rock_density) {
  const Fragment& f = table.rows[row];
  FragmentRecord record;
  record.id = particles.id[static_cast<std::size_t>(f.first_particle)];
  record.rock = f.rock;
  record.particles = f.particles;
  record.mass = f.mass;
  record.size = sieve_size(table, row, particles, rock_density);
  record.position = f.centre;
  for (const Index member : table.members_of(row)) {
    const auto n = static_cast<std::size_t>(member);
    record.velocity += particles.mass[n] / f.mass * particles.velocity[n];
  }
  return record;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/start_state.hpp"

#include "app/simulation/assembly.hpp"
#include "core/rocks/bonds.hpp"

#include <algorithm>
#include <map>

namespace gyro {
namespace {

/// Rows of the particle table by rock, rocks in order of number.
std::map<RockId, std::vector<Index>> rows_by_rock(const CaseParticles& table) {
  std::map<RockId, std::vector<Index>> rows;
  for (std::size_t k = 0; k < table.particles.size(); ++k)
    rows[table.particles[k].rock].push_back(static_cast<Index>(k));
  return rows;
}

NewParticle particle_of(const StartParticle& row, double density) {
  return {row.id, row.position, row.velocity, row.angular_velocity, row.radius, density};
}

}  // namespace

std::vector<NewRock> start_state(const Case& input) {
  std::vector<NewRock> rocks;
  if (!input.particles) return rocks;
  const CaseParticles& table = *input.particles;
  const double density = input.materials[static_cast<std::size_t>(input.rock_material)].density;
  if (!input.bonds) {
    for (const StartParticle& row : table.particles) {
      NewRock one;
      one.id = none;
      one.particles.push_back(particle_of(row, density));
      rocks.push_back(std::move(one));
    }
    return rocks;
  }

  const BondStrength strength = bond_strength(input);
  std::vector<Index> place(table.particles.size()), rock_of(table.particles.size());
  for (const auto& [id, rows] : rows_by_rock(table)) {
    NewRock rock;
    rock.id = id;
    for (const Index row : rows) {
      place[static_cast<std::size_t>(row)] = static_cast<Index>(rock.particles.size());
      rock_of[static_cast<std::size_t>(row)] = static_cast<Index>(rocks.size());
      rock.particles.push_back(particle_of(table.particles[static_cast<std::size_t>(row)], density));
    }
    rocks.push_back(std::move(rock));
  }
  std::vector<std::vector<TemplateBond>> bonds(rocks.size());
  for (const StartBond& b : table.bonds) {
    const auto i = static_cast<std::size_t>(b.i), j = static_cast<std::size_t>(b.j);
    const double radius = bond_radius(input.bonds->rule, table.particles[i].radius, table.particles[j].radius);
    bonds[static_cast<std::size_t>(rock_of[i])].push_back({place[i], place[j], b.length, radius});
  }
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    NewRock& rock = rocks[r];
    rock.colour_begin = colour_bonds(bonds[r], static_cast<Index>(rock.particles.size()));
    for (const TemplateBond& b : bonds[r]) {
      const ParticleId i = rock.particles[static_cast<std::size_t>(b.i)].id,
                       j = rock.particles[static_cast<std::size_t>(b.j)].id;
      rock.bonds.push_back({b.i, b.j, b.length, b.radius, strength ? strength(rock.id, i, j) : 1.0});
    }
  }
  return rocks;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/rocks.hpp"
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

/// Every row as a rock of one loose particle.
std::vector<NewRock> loose(const CaseParticles& table, double density) {
  std::vector<NewRock> rocks;
  rocks.reserve(table.particles.size());
  for (const StartParticle& row : table.particles) {
    NewRock one;
    one.id = none;
    one.particles.push_back(particle_of(row, density));
    rocks.push_back(std::move(one));
  }
  return rocks;
}

/// Rocks without their bonds, and the rock of each row of the table.
struct Grouped {
  std::vector<NewRock> rocks;
  std::vector<Index> rock, number;  ///< by row: in `rocks`, and in the particles of that rock
};
Grouped grouped(const CaseParticles& table, double density) {
  Grouped g;
  g.rock.resize(table.particles.size());
  g.number.resize(table.particles.size());
  for (const auto& [id, rows] : rows_by_rock(table)) {
    NewRock rock;
    rock.id = id;
    rock.particles.reserve(rows.size());
    for (const Index row : rows) {
      const auto k = static_cast<std::size_t>(row);
      g.number[k] = static_cast<Index>(rock.particles.size());
      g.rock[k] = static_cast<Index>(g.rocks.size());
      rock.particles.push_back(particle_of(table.particles[k], density));
    }
    g.rocks.push_back(std::move(rock));
  }
  return g;
}

/// Bonds of the table by rock, with the radius that the rule gives.
std::vector<std::vector<TemplateBond>> bonds_by_rock(const CaseParticles& table, const Grouped& g,
                                                     const BondRule& rule) {
  std::vector<std::vector<TemplateBond>> bonds(g.rocks.size());
  for (const StartBond& b : table.bonds) {
    const auto i = static_cast<std::size_t>(b.i), j = static_cast<std::size_t>(b.j);
    const double radius = bond_radius(rule, table.particles[i].radius, table.particles[j].radius);
    bonds[static_cast<std::size_t>(g.rock[i])].push_back({g.number[i], g.number[j], b.length, radius});
  }
  return bonds;
}

}  // namespace

std::vector<NewRock> start_state(const Case& input) {
  if (!input.particles) return {};
  const CaseParticles& table = *input.particles;
  const double density = input.materials[static_cast<std::size_t>(input.rock_material)].density;
  if (!input.bonds) return loose(table, density);
  Grouped g = grouped(table, density);
  const BondStrength strength = bond_strength(input);
  std::vector<std::vector<TemplateBond>> bonds = bonds_by_rock(table, g, input.bonds->rule);
  for (std::size_t r = 0; r < g.rocks.size(); ++r) {
    NewRock& rock = g.rocks[r];
    rock.colour_begin = colour_bonds(bonds[r], static_cast<Index>(rock.particles.size()));
    rock.bonds.reserve(bonds[r].size());
    for (const TemplateBond& b : bonds[r]) {
      const ParticleId i = rock.particles[static_cast<std::size_t>(b.i)].id,
                       j = rock.particles[static_cast<std::size_t>(b.j)].id;
      rock.bonds.push_back({b.i, b.j, b.length, b.radius, strength ? strength(rock.id, i, j) : 1.0});
    }
  }
  return std::move(g.rocks);
}

}  // namespace gyro

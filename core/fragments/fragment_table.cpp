// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fragment_table.hpp"

#include "core/geometry/sieve_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyro {
namespace {

/// Row of the table for every row of the snapshot.
std::vector<Index> table_rows(const ParticleSnapshot& p, std::vector<Fragment>& rows) {
  std::vector<Index> row_of(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Index first = p.fragment[i];
    if (first == static_cast<Index>(i)) {
      constexpr double inf = std::numeric_limits<double>::infinity();
      row_of[i] = static_cast<Index>(rows.size());
      rows.push_back({first, 0, p.rock[i], 0, inf, -inf, {0, 0, 0}});
    } else {
      row_of[i] = row_of[static_cast<std::size_t>(first)];  // first < i, so already known
    }
  }
  return row_of;
}

void add_particle(Fragment& f, const ParticleSnapshot& p, std::size_t i) {
  ++f.particles;
  f.mass += p.mass[i];
  f.centre += p.mass[i] * p.position[i];
  f.lowest = std::min(f.lowest, p.position[i].z - p.radius[i]);
  f.highest = std::max(f.highest, p.position[i].z + p.radius[i]);
}

}  // namespace

std::span<const Index> FragmentTable::members_of(std::size_t row) const {
  const auto begin = static_cast<std::size_t>(members_begin[row]),
             end = static_cast<std::size_t>(members_begin[row + 1]);
  return std::span<const Index>(members).subspan(begin, end - begin);
}

FragmentTable fragment_table(const ParticleSnapshot& p) {
  FragmentTable table;
  const std::vector<Index> row_of = table_rows(p, table.rows);
  for (std::size_t i = 0; i < p.size(); ++i) add_particle(table.rows[static_cast<std::size_t>(row_of[i])], p, i);

  table.members_begin.assign(1, 0);
  for (Fragment& f : table.rows) {
    f.centre = (1 / f.mass) * f.centre;
    table.members_begin.push_back(table.members_begin.back() + f.particles);
  }
  std::vector<Index> next(table.members_begin.begin(), table.members_begin.end() - 1);
  table.members.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    Index& slot = next[static_cast<std::size_t>(row_of[i])];
    table.members[static_cast<std::size_t>(slot++)] = static_cast<Index>(i);
  }
  return table;
}

double equal_mass_diameter(double mass, double rock_density) {
  return std::cbrt(6 * mass / (std::numbers::pi * rock_density));
}

double sieve_size(const FragmentTable& table, std::size_t row, const ParticleSnapshot& p, double rock_density) {
  std::vector<Vec3d> centres;
  std::vector<double> radii;
  double largest_piece = 0;
  for (const Index m : table.members_of(row)) {
    const auto i = static_cast<std::size_t>(m);
    centres.push_back(p.position[i]);
    radii.push_back(p.radius[i]);
    largest_piece = std::max(largest_piece, equal_mass_diameter(p.mass[i], rock_density));
  }
  // A sphere represents a piece of solid rock of its mass, which is larger than the sphere. A fragment passes an
  // opening only if all its pieces pass it.
  return std::max(largest_piece, spheres_sieve_size(centres, radii));
}

}  // namespace gyro

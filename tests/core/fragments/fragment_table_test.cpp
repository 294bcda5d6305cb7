// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fragment_table.hpp"

#include "tests/catch.hpp"
#include "tests/core/fragments/snapshots.hpp"

#include <cmath>

using namespace gyro;

namespace {

const double d = 0.02, R = d / 2, density = 4000;

}  // namespace

TEST_CASE("A fragment table keeps every particle and all mass", "[fragments]") {
  ParticleSnapshot p;
  const std::vector<int> counts{1, 2, 5, 20, 140, 1, 1};
  double x = 0;
  RockId rock = 3;
  for (const int n : counts) add_fragment(p, block(n, 1, 1, R), R, density, {x += 5, 2, -1}, rock++);
  const FragmentTable table = fragment_table(p);

  REQUIRE(table.size() == counts.size());
  const double sphere = p.mass[0];
  double total = 0;
  for (std::size_t f = 0; f < table.size(); ++f) {
    const Fragment& row = table.rows[f];
    CHECK(row.particles == counts[f]);
    CHECK(row.rock == 3 + static_cast<RockId>(f));
    CHECK(row.mass == Approx(counts[f] * sphere).epsilon(1e-12));
    CHECK(row.lowest == Approx(-1 - R).epsilon(1e-14));
    CHECK(row.highest == Approx(-1 + R).epsilon(1e-14));
    CHECK(row.centre.x == Approx(5 * (static_cast<double>(f) + 1) + R * (counts[f] - 1)).epsilon(1e-12));
    CHECK(table.members_of(f).size() == static_cast<std::size_t>(counts[f]));
    CHECK(table.members_of(f).front() == row.first_particle);
    total += row.mass;
  }
  CHECK(std::abs(total / (170 * sphere) - 1) < 1e-12);
}

TEST_CASE("Fragments whose particles are mixed in the snapshot are separated", "[fragments]") {
  ParticleSnapshot p;
  add_fragment(p, block(6, 1, 1, R), R, density, {0, 0, 0});
  p.fragment = {0, 1, 0, 1, 4, 0};
  const FragmentTable table = fragment_table(p);
  REQUIRE(table.size() == 3);
  CHECK(std::vector<Index>(table.members_of(0).begin(), table.members_of(0).end()) == std::vector<Index>{0, 2, 5});
  CHECK(std::vector<Index>(table.members_of(1).begin(), table.members_of(1).end()) == std::vector<Index>{1, 3});
  CHECK(std::vector<Index>(table.members_of(2).begin(), table.members_of(2).end()) == std::vector<Index>{4});
}

TEST_CASE("A single particle has the sieve size of the rock of its mass", "[fragments]") {
  // Spheres that fill a share phi of the rock weigh rho/phi: d phi^(-1/3).
  const double rock_density = 2600, phi = 0.64;
  ParticleSnapshot p;
  add_fragment(p, {{0, 0, 0}}, R, rock_density / phi, {0, 0, 0});
  add_fragment(p, block(2, 1, 1, R), R, rock_density / phi, {1, 0, 0});
  const FragmentTable table = fragment_table(p);
  CHECK(sieve_size(table, 0, p, rock_density) == Approx(d * std::pow(phi, -1.0 / 3)).epsilon(1e-12));
  CHECK(equal_mass_diameter(rock_density * std::acos(-1.0) / 6, rock_density) == Approx(1.0).epsilon(1e-14));
  // A pair is not finer than its halves.
  CHECK(sieve_size(table, 1, p, rock_density) == Approx(d * std::pow(phi, -1.0 / 3)).epsilon(1e-12));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fines.hpp"

#include "tests/catch.hpp"
#include "tests/core/fragments/snapshots.hpp"

#include <cmath>
#include <numeric>

using namespace gyro;

namespace {

const double rock_density = 2600;
const BreakageFines ore{.A = 0.6, .b = 10.0 / 3600};
const double energy_of_ore = 0.05 * 3600;  // [J/kg]
const std::vector<double> sieves{0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1};

/// A rock of equal spheres of solid rock, without bonds: they break in the snapshot.
NewRock rock_of(RockId id, ParticleId first, int particles, double radius) {
  NewRock rock;
  rock.id = id;
  for (int k = 0; k < particles; ++k)
    rock.particles.push_back({first + static_cast<ParticleId>(k), {}, {}, {}, radius, rock_density});
  return rock;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Gives every particle of a rock the same energy / mass, by bonds of a ring.
void energise(Fines& fines, const NewRock& rock, double mass, double energy) {
  std::vector<Breakage> broken;
  for (std::size_t k = 0; k < rock.particles.size(); ++k)
    broken.push_back({0,
                      BreakMode::tension,
                      {},
                      rock.id,
                      rock.particles[k].id,
                      rock.particles[(k + 1) % rock.particles.size()].id,
                      energy * mass});
  fines.add(broken);
}

struct Chamber {
  explicit Chamber(const FinesLaw& law)
      : product(rock_density, {}, sieves), hold_up(rock_density, sieves), fines(law, rock_density, sieves) {}

  /// Adds a rock of `particles` single particles at a height.
  NewRock add(int particles, double radius, double z) {
    const auto id = static_cast<RockId>(rocks++);
    const NewRock rock = rock_of(id, static_cast<ParticleId>(p.size()), particles, radius);
    for (int k = 0; k < particles; ++k) add_fragment(p, {{0.1 * k, 0.2 * id, 0}}, radius, rock_density, {0, 0, z}, id);
    fines.feed({&rock, 1});
    return rock;
  }
  void update() {
    const FragmentTable table = fragment_table(p);
    const std::vector<FragmentRecord> left = product.update(table, p);
    hold_up.update(table, p, product);
    fines.update(table, p, left, product, hold_up);
  }

  ParticleSnapshot p;
  int rocks = 0;
  Product product;
  HoldUp hold_up;
  Fines fines;
};

}  // namespace

TEST_CASE("A broken bond gives half of its energy to each of its particles, until they are removed", "[fines]") {
  RockHistory history(rock_density);
  const std::vector<NewRock> rocks{rock_of(7, 20, 3, 0.01), rock_of(3, 5, 2, 0.02)};  // in any order
  history.feed(rocks);
  CHECK(history.state().particle == std::vector<ParticleId>{5, 6, 20, 21, 22});
  CHECK(history.size_of(7) == Approx(0.02 * std::cbrt(3.0)));
  CHECK(history.size_of(3) == Approx(0.04 * std::cbrt(2.0)));
  CHECK(history.size_of(4) == 0);
  history.add(std::vector<Breakage>{{0, BreakMode::tension, {}, 7, 20, 21, 4.0},
                                    {0, BreakMode::shear, {}, 7, 20, 22, 1.0},
                                    {0, BreakMode::shear, {}, 3, 5, 6, 8.0}});
  CHECK(history.state().energy == std::vector{4.0, 4.0, 2.5, 2.0, 0.5});

  ParticleSnapshot p;
  for (const auto& [id, rock] : {std::pair{5, 3}, {6, 3}, {20, 7}, {21, 7}, {22, 7}}) {
    add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {}, rock);
    p.id.back() = static_cast<ParticleId>(id);
  }
  CHECK(history.energies(p) == std::vector{4.0, 4.0, 2.5, 2.0, 0.5});
  history.remove(std::vector<ParticleId>{5, 6, 21}, p);
  CHECK(history.state().particle == std::vector<ParticleId>{20, 22});
  CHECK(history.state().energy == std::vector{2.5, 0.5});
  CHECK(history.state().rock == std::vector<RockId>{7});
  CHECK(history.energies(p) == std::vector{0.0, 0.0, 2.5, 0.0, 0.5});
}

TEST_CASE("What is finer than the particles is taken from the class of its fragment, and no mass is lost", "[fines]") {
  const FragmentOrigin origin{.rock_size = 0.1, .resolution = 0.015, .energy = energy_of_ore};
  FinesTally tally;
  tally.add(sieves, FragmentFines(ore, origin), 0.03, 2.0);
  const double t10 = t10_of(ore, energy_of_ore);
  const TnFamily family = tn_family(t10);
  CHECK(sum(tally.sieve_mass) == Approx(2).epsilon(1e-15));
  CHECK(tally.sieve_mass[0] == Approx(2 * tn_of(family, 100)));
  CHECK(tally.sieve_mass[2] == Approx(2 * (tn_of(family, 20) - tn_of(family, 50))));
  CHECK(tally.sieve_mass[3] == Approx(2 * (t10 - tn_of(family, 20))));
  CHECK(tally.sieve_mass[4] == Approx(2 * (tn_of(family, 0.1 / 0.015) - t10)));  // up to the resolution
  CHECK(tally.sieve_mass[5] == Approx(2 * (1 - tn_of(family, 0.1 / 0.015))));    // its own class
  CHECK(tally.sieve_mass[6] == 0);
  const FinesRow row = tally.row(sieves, ore);
  CHECK(row.passing[3] == Approx(t10));
  CHECK(row.passing[5] == Approx(1));
  CHECK(*row.share == Approx(tn_of(family, 0.1 / 0.015)));
  CHECK(*row.t10 == Approx(t10));
  CHECK(*row.energy == Approx(energy_of_ore));
  CHECK(*row.beyond_share == 0);
  const FragmentOrigin hard_hit{.rock_size = 0.1, .resolution = 0.015, .energy = 40 * energy_of_ore};
  tally.add(sieves, FragmentFines(ore, hard_hit), 0.015, 6.0);
  CHECK(*tally.row(sieves, ore).beyond_share == Approx(0.75));
  CHECK(sum(tally.sieve_mass) == Approx(8).epsilon(1e-15));
  CHECK_FALSE(FinesTally{}.row(sieves, ore).share);
  CHECK_FALSE(tally.row(sieves, SchuhmannFines{1}).t10);
}

TEST_CASE("A rock that was broken evenly has the curve of the law below its particles, whatever its pieces",
          "[fines]") {
  Chamber chamber(ore);
  const int count = GENERATE(8, 27);
  const NewRock rock = chamber.add(count, 0.0109, -1);
  energise(chamber.fines, rock, chamber.p.mass[0], energy_of_ore);
  for (Index k : {1, 2}) chamber.p.fragment[static_cast<std::size_t>(k)] = 0;  // three of them are still bonded
  chamber.update();
  const double size = 0.0218 * std::cbrt(count);
  const TnFamily family = tn_family(t10_of(ore, energy_of_ore));
  const FinesRow row = chamber.fines.product();
  for (std::size_t k = 0; k < 5; ++k) CHECK(row.passing[k] == Approx(tn_of(family, size / sieves[k])).epsilon(1e-12));
  CHECK(*row.share == Approx(tn_of(family, size / 0.0218)).epsilon(1e-12));
  const ProductRow plain = chamber.product.row(0);
  CHECK(plain.passing[4] == 0);
  CHECK(sum(chamber.fines.sieve_mass()) == Approx(plain.mass).epsilon(1e-14));
  CHECK(row.passing.back() == Approx(1).epsilon(1e-14));
}

TEST_CASE("Rocks with particles of their own sizes have fines below these, in product and hold-up", "[fines]") {
  Chamber chamber(SchuhmannFines{.m = 1});
  chamber.add(8, 0.02, -1);    // breaks into particles of 40 mm
  chamber.add(8, 0.004, -1);   // of 8 mm
  chamber.add(1, 0.0035, -1);  // a rock of one particle of 7 mm, which has not broken
  chamber.add(2, 0.006, 1);    // in the chamber
  chamber.update();
  const auto cube = [](double x) { return x * x * x; };
  const double coarse = 8 * cube(40), fine = 8 * cube(8), whole = cube(7), all = coarse + fine + whole;
  const FinesRow row = chamber.fines.product();
  CHECK(row.passing[2] == Approx((coarse * 5 / 40 + fine * 5 / 8) / all));
  CHECK(row.passing[3] == Approx((coarse * 10 / 40 + fine + whole) / all));
  CHECK(row.passing[5] == Approx(1));
  CHECK(*row.share == Approx((coarse + fine) / all));
  CHECK(sum(chamber.fines.sieve_mass()) == Approx(chamber.product.row(0).mass).epsilon(1e-14));
  CHECK(chamber.fines.hold_up().passing[3] == Approx(10.0 / 12));
}

TEST_CASE("Escaped rock is not in the estimate, and discharged rock keeps the energy of its discharge", "[fines]") {
  Chamber chamber(ore);
  chamber.product = Product(rock_density, ConcaveOutline({{0.2, 0.3}, {0.1, 0.0}}), sieves);
  const NewRock out = chamber.add(2, 0.006, -0.1);
  const NewRock escaped = chamber.add(2, 0.006, 0.15);
  for (const std::size_t k : {2u, 3u}) chamber.p.position[k].x += 0.5;
  for (const NewRock* rock : {&out, &escaped}) energise(chamber.fines, *rock, chamber.p.mass[0], energy_of_ore);
  chamber.update();
  REQUIRE(chamber.product.state().escaped_particles == 2);
  REQUIRE(chamber.product.row(0).particles == 2);
  const FinesRow row = chamber.fines.product();
  CHECK(sum(chamber.fines.sieve_mass()) == Approx(2 * chamber.p.mass[0]).epsilon(1e-15));
  CHECK(*row.t10 == Approx(t10_of(ore, energy_of_ore)));
  CHECK_FALSE(chamber.fines.hold_up().share);
  energise(chamber.fines, out, chamber.p.mass[0], energy_of_ore);  // it breaks further below
  chamber.update();
  CHECK(chamber.fines.product().passing == row.passing);
}

TEST_CASE("The estimate of the hold-up follows its rock when that breaks or leaves", "[fines]") {
  Chamber chamber(ore);
  const NewRock first = chamber.add(3, 0.009, 1), second = chamber.add(4, 0.009, 1);
  energise(chamber.fines, first, chamber.p.mass[0], energy_of_ore);
  const auto as_new = [&] {
    const FragmentTable table = fragment_table(chamber.p);
    Fines fresh(ore, rock_density, sieves, chamber.fines.state());
    fresh.update(table, chamber.p, {}, chamber.product, chamber.hold_up);
    return fresh.hold_up();
  };
  const auto check = [&](double energy) {
    chamber.update();
    CHECK(chamber.fines.hold_up().passing == as_new().passing);
    CHECK(*chamber.fines.hold_up().energy == Approx(energy));
  };
  check(energy_of_ore * 3 / 7);
  check(energy_of_ore * 3 / 7);
  energise(chamber.fines, second, chamber.p.mass[0], energy_of_ore);
  check(energy_of_ore);
  for (const std::size_t k : {0u, 1u, 2u}) chamber.p.position[k].z -= 2;  // the first leaves
  check(energy_of_ore);
}

TEST_CASE("An estimate continues from its saved state with the same bits", "[fines]") {
  Chamber chamber(ore);
  const NewRock first = chamber.add(5, 0.006, -1), second = chamber.add(7, 0.009, 1);
  energise(chamber.fines, first, chamber.p.mass[0], energy_of_ore);
  energise(chamber.fines, second, chamber.p.mass[5], 0.3 * energy_of_ore);
  chamber.update();
  Fines resumed(ore, rock_density, sieves, chamber.fines.state());
  const Product product = chamber.product;
  for (Fines* fines : {&chamber.fines, &resumed}) energise(*fines, second, chamber.p.mass[5], 0.1 * energy_of_ore);
  for (Vec3d& x : chamber.p.position) x.z -= 1.5;
  const FragmentTable table = fragment_table(chamber.p);
  const std::vector<FragmentRecord> left = chamber.product.update(table, chamber.p);
  REQUIRE(left.size() == 7);
  chamber.hold_up.update(table, chamber.p, chamber.product);
  for (Fines* fines : {&chamber.fines, &resumed}) {
    fines->update(table, chamber.p, left, chamber.product, chamber.hold_up);
    fines->remove(std::vector<ParticleId>{0, 1, 2, 3, 4}, chamber.p);
  }
  CHECK(resumed.product().passing == chamber.fines.product().passing);
  CHECK(resumed.product().t10 == chamber.fines.product().t10);
  CHECK(resumed.state().history.energy == chamber.fines.state().history.energy);
  CHECK(resumed.state().history.rock == std::vector<RockId>{1});
  CHECK(*resumed.product().t10 > 0);
}

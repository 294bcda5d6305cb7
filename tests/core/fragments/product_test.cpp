// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/fragments/hold_up.hpp"
#include "snapshots.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <numeric>

using namespace gyro;

namespace {

const double rock_density = 2600;

void move_down(ParticleSnapshot& p, double by) {
  for (Vec3d& x : p.position) x.z -= by;
}

}  // namespace

TEST_CASE("A fragment is discharged when all of it is below the plane, and counted once", "[product]") {
  ParticleSnapshot p;
  add_fragment(p, block(1, 1, 2, 0.01), 0.01, rock_density, {0, 0, 0.02});  // spheres at 0.02 and 0.04
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {1, 0, 0.5});
  Product product(rock_density);
  const auto update = [&] { product.update(fragment_table(p), p); };

  update();
  CHECK(product.row(0).particles == 0);
  move_down(p, 0.0499);  // the top of the upper sphere is 0.1 mm above the plane
  update();
  CHECK(product.row(0).particles == 0);
  move_down(p, 0.0002);
  update();
  CHECK(product.row(0).particles == 2);
  CHECK(product.row(0).fragments == 1);
  CHECK(product.row(0).mass == Approx(2 * p.mass[0]).epsilon(1e-14));
  CHECK(product.row(0).singles_share == 0);
  CHECK(product.inside(p) == 1);

  move_down(p, -0.1);  // it bounces up, breaks, and falls again
  p.fragment = {0, 1, 2};
  update();
  move_down(p, 0.1);
  update();
  CHECK(product.row(0).particles == 2);
  CHECK(product.row(0).fragments == 1);
  CHECK(product.row(0).singles_share == 0);

  move_down(p, 1);
  update();
  CHECK(product.row(0).particles == 3);
  CHECK(product.row(0).singles_share == Approx(1.0 / 3).epsilon(1e-14));
  CHECK(product.inside(p) == 0);
}

TEST_CASE("Only whole fragments below the removal depth may be removed", "[product]") {
  ParticleSnapshot p;
  add_fragment(p, block(1, 1, 3, 0.01), 0.01, rock_density, {0, 0, -1.02});  // from -1.03 to -0.97
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {1, 0, -2});
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {1, 0, 0.1});
  const FragmentTable table = fragment_table(p);
  Product product(rock_density);
  CHECK(product.removable(table, p, 0).empty());  // not counted yet
  product.update(table, p);
  CHECK(product.removable(table, p, 1.0) == std::vector<ParticleId>{3});
  CHECK(product.removable(table, p, 0.9) == std::vector<ParticleId>{0, 1, 2, 3});
  CHECK(product.row(0).particles + product.inside(p) == 5);
}

TEST_CASE("Passing sizes are interpolated between sieves on a logarithmic scale", "[product]") {
  const std::vector<double>& sieves = sieve_series();
  CHECK(sieves[14] == Approx(0.125));
  CHECK(sieves.back() == Approx(1.0));
  for (std::size_t k = 1; k < sieves.size(); ++k) CHECK(sieves[k] / sieves[k - 1] == Approx(std::sqrt(2.0)));

  // A Gates-Gaudin-Schuhmann product (x/x_max)^1 is not linear in log x; one that is linear is
  // uniform in log x: P = ln(x/x0)/ln(x1/x0), whose 80 % size is x0 (x1/x0)^0.8 exactly.
  std::vector<double> passing(sieves.size());
  const double x0 = sieves[2], x1 = sieves[18];
  for (std::size_t k = 0; k < sieves.size(); ++k) {
    passing[k] = std::clamp(std::log(sieves[k] / x0) / std::log(x1 / x0), 0.0, 1.0);
  }
  REQUIRE(passing_size(sieves, passing, 0.8));
  CHECK(*passing_size(sieves, passing, 0.8) == Approx(x0 * std::pow(x1 / x0, 0.8)).epsilon(1e-12));
  CHECK(*passing_size(sieves, passing, 0.5) == Approx(std::sqrt(x0 * x1)).epsilon(1e-12));
  CHECK(!passing_size(sieves, std::vector<double>(sieves.size(), 0.0), 0.8));  // nothing, or all oversize
  CHECK(!passing_size(sieves, std::vector<double>(sieves.size(), 1.0), 0.8));  // all finer than the finest sieve
}

TEST_CASE("Rock outside the concave below its rim has escaped and is not counted as product", "[product]") {
  const ConcaveOutline concave({{0.2, 0.3}, {0.1, 0.0}});  // opens upwards from 0.1 to 0.2 m
  ParticleSnapshot p;
  add_fragment(p, block(1, 1, 2, 0.01), 0.01, rock_density, {0, 0, 0.15});      // ids 0, 1: in the chamber
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {0.16, 0, 0.15});            // 2: just outside of 0.15 m
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {0, 0.25, 0.295});           // 3: outside, reaches above the rim
  add_fragment(p, block(2, 1, 1, 0.01), 0.01, rock_density, {0.145, 0, 0.15});  // 4, 5: one centre on either side
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {0.12, 0, -0.02});           // 6: below, within the cone
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {0.14, 0, -0.02});           // 7: below, outside of it
  Product product(rock_density, concave);
  HoldUp hold_up(rock_density);
  const auto update = [&] {
    product.update(fragment_table(p), p);
    hold_up.update(fragment_table(p), p, product);
  };
  update();
  const auto place = [&](ParticleId id) { return static_cast<int>(product.state().place[id]); };
  CHECK(place(2) == Product::escaped);
  CHECK(place(6) == Product::discharged);
  CHECK(place(7) == Product::escaped);
  for (const ParticleId id : {0u, 1u, 3u, 4u, 5u}) CHECK_FALSE(product.has_left(id));
  CHECK(product.row(0).mass == Approx(p.mass[6]));
  CHECK(product.row(0).particles == 1);
  CHECK(product.state().escaped_mass == Approx(2 * p.mass[6]));
  CHECK(product.state().escaped_particles == 2);
  CHECK(product.inside(p) == 5);
  CHECK(hold_up.row(0).mass == Approx(5 * p.mass[6]));

  move_down(p, 0.05);  // now all of 3 is below the rim, and both centres of 4 and 5 are outside
  update();
  for (const ParticleId id : {3u, 4u, 5u}) CHECK(place(id) == Product::escaped);
  move_down(p, 0.35);  // the chamber falls through the opening; what has escaped stays escaped
  update();
  CHECK(product.state().escaped_particles == 5);
  CHECK(product.row(0).particles == 3);
  CHECK(product.inside(p) == 0);
  CHECK(product.removable(fragment_table(p), p, 0).size() == 8);
}

TEST_CASE("An update tells which fragments have left, and each of them once", "[product]") {
  const ConcaveOutline concave({{0.2, 0.3}, {0.1, 0.0}});
  ParticleSnapshot p;
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {0, 0, 0.15});              // 0: in the chamber
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {0.16, 0, 0.15});           // 1: outside
  add_fragment(p, block(1, 1, 2, 0.01), 0.01, rock_density, {0.05, 0, -0.1});  // 2, 3: below
  Product product(rock_density, concave);
  const FragmentTable table = fragment_table(p);
  const std::vector<FragmentRecord> left = product.update(table, p);
  REQUIRE(left.size() == 2);
  CHECK(left[0].id == 1);
  CHECK(left[0].place == Product::escaped);
  CHECK(left[1].id == 2);
  CHECK(left[1].place == Product::discharged);
  CHECK(left[1].particles == 2);
  CHECK(left[1].mass == p.mass[2] + p.mass[3]);
  CHECK(left[1].size == sieve_size(table, 2, p, rock_density));
  CHECK(left[1].position.x == Approx(0.05));
  CHECK(left[1].rock == p.rock[2]);
  CHECK(product.update(table, p).empty());
}

TEST_CASE("Without a concave all rock that falls below the plane is product", "[product]") {
  ParticleSnapshot p;
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {5, 0, -1});
  Product product(rock_density);
  product.update(fragment_table(p), p);
  CHECK(product.row(0).particles == 1);
  CHECK(product.state().escaped_particles == 0);
}

TEST_CASE("An outline needs points of two heights", "[product]") {
  CHECK_THROWS_AS(ConcaveOutline({}), BadInput);
  CHECK_THROWS_AS(ConcaveOutline({{1, 0.5}, {2, 0.5}}), BadInput);
  CHECK_THROWS_AS(ConcaveOutline({{1, 0}, {std::nan(""), 1}}), BadInput);
  const ConcaveOutline steps({{1, 0}, {1, 1}, {2, 1}, {2, 2}});  // a ledge at z = 1
  CHECK(steps.radius(0.5) == 1);
  CHECK(steps.radius(1.5) == 2);
  CHECK(steps.radius(-0.5) == Approx(1.6));
}

TEST_CASE("A product continues from its saved state", "[product]") {
  ParticleSnapshot p;
  for (int k = 0; k < 10; ++k)
    add_fragment(p, block(1 + k, 1, 1, 0.01), 0.01, rock_density, {0.0, 1.0 * k, 0.1 * k + 0.05});
  Product whole(rock_density), first(rock_density);
  move_down(p, 0.5);
  whole.update(fragment_table(p), p);
  first.update(fragment_table(p), p);
  Product second(rock_density, {}, sieve_series(), first.state());
  move_down(p, 1.0);
  whole.update(fragment_table(p), p);
  second.update(fragment_table(p), p);
  CHECK(second.row(1).mass == whole.row(1).mass);
  CHECK(second.row(1).passing == whole.row(1).passing);
  CHECK(second.row(1).particles == 55);
  CHECK(!Product(rock_density).row(0).p80);
}

TEST_CASE("Product and hold-up are analysed on the sieves that are given", "[product]") {
  ParticleSnapshot p;
  for (const double radius : {0.004, 0.012, 0.03}) add_fragment(p, {{0, 0, 0}}, radius, rock_density, {0, 0, -1});
  const std::vector<double> sieves{0.01, 0.02, 0.05};
  Product product(rock_density, {}, sieves);
  product.update(fragment_table(p), p);
  const ProductRow row = product.row(0);
  CHECK(row.sieves == sieves);
  const double finest = std::pow(0.004, 3), middle = std::pow(0.012, 3), coarsest = std::pow(0.03, 3);
  const double all = finest + middle + coarsest;
  REQUIRE(row.passing.size() == 3);
  CHECK(row.passing[0] == Approx(finest / all));
  CHECK(row.passing[1] == Approx(finest / all));
  CHECK(row.passing[2] == Approx((finest + middle) / all));
  HoldUp hold_up(rock_density, sieves);
  hold_up.update(fragment_table(p), p, Product(rock_density));
  CHECK(hold_up.row(0).passing == row.passing);
}

TEST_CASE("The share below a size is the inverse of the size of a share", "[product]") {
  std::vector<double> passing(sieve_series().size(), 1.0);
  for (std::size_t k = 0; k < passing.size(); ++k)
    passing[k] = static_cast<double>(k) / (static_cast<double>(passing.size()) - 1);
  for (const double share : {0.13, 0.5, 0.8})
    CHECK(passing_at(sieve_series(), passing, *passing_size(sieve_series(), passing, share)) ==
          Approx(share).epsilon(1e-12));
  CHECK(passing_at(sieve_series(), passing, sieve_series().front()) == passing.front());
  CHECK(passing_at(sieve_series(), passing, sieve_series().back()) == passing.back());
  CHECK(!passing_at(sieve_series(), passing, 0.999 * sieve_series().front()));
  CHECK(!passing_at(sieve_series(), passing, 1.001 * sieve_series().back()));
  CHECK(passing_at(sieve_series(), passing, sieve_series()[3]) == Approx(passing[3]).epsilon(1e-12));
}

TEST_CASE("The hold-up is the rock not yet discharged, with the sizes of a new analysis", "[product]") {
  ParticleSnapshot p;
  add_fragment(p, block(2, 3, 5, 0.01), 0.01, rock_density, {0, 0, 0.5});
  add_fragment(p, block(1, 1, 3, 0.01), 0.01, rock_density, {1, 0, 0.5});
  add_fragment(p, {{0, 0, 0}}, 0.01, rock_density, {2, 0, 0.5});
  Product product(rock_density);
  HoldUp hold_up(rock_density);
  const auto check = [&](std::int64_t fragments, std::int64_t particles) {
    const FragmentTable table = fragment_table(p);
    product.update(table, p);
    HoldUp forgetful(rock_density);
    forgetful.update(table, p, product);
    hold_up = HoldUp(rock_density, sieve_series(), hold_up.state());  // as after a checkpoint
    hold_up.update(table, p, product);
    const ProductRow held = hold_up.row(1), out = product.row(1);
    CHECK(held.passing == forgetful.row(1).passing);
    CHECK(held.fragments == fragments);
    CHECK(held.particles == particles);
    CHECK(held.particles + out.particles == static_cast<std::int64_t>(p.size()));
    CHECK(held.mass + out.mass == Approx(std::accumulate(p.mass.begin(), p.mass.end(), 0.0)));
  };
  check(3, 34);
  CHECK(hold_up.row(1).singles_share == Approx(1.0 / 34));
  CHECK(hold_up.state().first == std::vector<ParticleId>{0, 30});
  CHECK(hold_up.state().size[0] == Approx(0.06).epsilon(2e-3));
  for (Index k = 20; k < 30; ++k) p.fragment[static_cast<std::size_t>(k)] = 20;  // the block of 30 breaks
  check(4, 34);
  CHECK(hold_up.state().particles == std::vector<Index>{20, 10, 3});
  for (std::size_t k = 30; k < 33; ++k) p.position[k].z -= 1;  // the three are discharged
  check(3, 31);
  for (Vec3d& x : p.position) x.z -= 2;
  check(0, 0);
  CHECK(hold_up.row(1).mass == 0);
  CHECK_FALSE(hold_up.row(1).p80);
}

TEST_CASE("A fragment that has been measured is not measured again", "[product]") {
  ParticleSnapshot p;
  add_fragment(p, block(2, 3, 5, 0.01), 0.01, rock_density, {0, 0, 0.5});
  HoldUp::State known{{0}, {30}, {0.5}, {}};  // a wrong size, on purpose
  HoldUp hold_up(rock_density, sieve_series(), known);
  hold_up.update(fragment_table(p), p, Product(rock_density));
  CHECK(hold_up.state().size == std::vector<double>{0.5});
  p.fragment[29] = 29;
  hold_up.update(fragment_table(p), p, Product(rock_density));
  CHECK(hold_up.state().size[0] == Approx(0.06).epsilon(0.05));
}

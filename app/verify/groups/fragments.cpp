// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of fragments against union-find, and fragments of known size in the engine.
#include "app/verify/fixtures/graphs.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/base/thread_team.hpp"
#include "core/fragments/product.hpp"
#include "core/math/random.hpp"
#include "core/state/fragment_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gyro::verify {
namespace {

using namespace fixtures;

const std::string arbiter = "union-find";

Graph random_graph(Index n, double bonds_per_particle) {
  Graph g{n, {}, {}};
  const auto bonds = static_cast<std::uint64_t>(bonds_per_particle * n);
  for (std::uint64_t b = 0; b < bonds; ++b) g.join(pick(n, b, 0), pick(n, b, 1));
  return g;
}

/// Square grid with randomly numbered particles, in which each bond exists with the probability `share`.
Graph grid(Index side, double share) {
  const std::vector<Index> number = shuffled(side * side);
  Graph g{side * side, {}, {}};
  const auto at = [&](Index x, Index y) { return number[static_cast<std::size_t>(y * side + x)]; };
  for (Index y = 0; y < side; ++y)
    for (Index x = 0; x < side; ++x) {
      const auto cell = static_cast<std::uint64_t>(y * side + x);
      if (x + 1 < side && uniform(3, Stream::shape, cell, 0) < share) g.join(at(x, y), at(x + 1, y));
      if (y + 1 < side && uniform(3, Stream::shape, cell, 1) < share) g.join(at(x, y), at(x, y + 1));
    }
  return g;
}

void compare(Recorder& out, const std::string& name, const Graph& g, ThreadTeam* team = nullptr) {
  const std::vector<Index> got = fragment_labels(g.particles, g.i, g.j, team), exact = union_find(g);
  double wrong = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) wrong += got[k] != exact[k];
  out.absolute(name + "-wrong-labels", wrong, 0, {0, 0}, arbiter);
}

void random_graphs(Recorder& out) {
  for (const Index n : {1, 2, 3, 10, 1000, 100000})
    for (const double density : {0.3, 0.5, 0.7, 3.0})
      compare(out, std::to_string(n) + "-at-" + std::to_string(std::lround(10 * density)), random_graph(n, density));
  compare(out, "1000000-at-5", random_graph(1000000, 0.5));
}

void chains(Recorder& out) {
  const Index n = 1000000;
  std::vector<Index> order = in_order(n);
  compare(out, "along", chain_of(order));
  std::reverse(order.begin(), order.end());
  compare(out, "against", chain_of(order));
  compare(out, "from-both-ends", chain_of(from_both_ends(n)));
  compare(out, "at-random", chain_of(shuffled(n)));
}

void stars_and_grids(Recorder& out) {
  const Index n = 10000;
  for (const Index centre : {0, 5000, 9999}) {
    Graph star{n, {}, {}};
    for (Index k = 0; k < n; ++k)
      if (k != centre) star.join(centre, k);
    compare(out, "star-about-" + std::to_string(centre), star);
  }
  for (const int percent : {0, 45, 50, 55, 100})  // bonds percolate at 1/2
    compare(out, "grid-" + std::to_string(percent), grid(300, 0.01 * percent));
}

void order_and_threads(Recorder& out) {
  const Graph g = random_graph(50000, 0.6);
  Graph other{g.particles, {}, {}};
  for (const Index b : shuffled(static_cast<Index>(g.i.size())))
    other.join(g.j[static_cast<std::size_t>(b)], g.i[static_cast<std::size_t>(b)]);
  compare(out, "bonds-in-another-order", other);
  for (const int threads : {1, 2, 3, 7}) {
    ThreadTeam team(threads);
    compare(out, std::to_string(threads) + "-threads", g, &team);
  }
}

/// A chain of 168 spheres with four weak bonds is stretched: the weak bonds break at once and leave fragments of 1, 2,
/// 5, 20 and 140 spheres.
void pieces_of_a_chain(Recorder& out) {
  const std::array<int, 5> sizes{1, 2, 5, 20, 140};
  NewRock rock = chain(0, 167);
  std::array<int, 4> cuts{};
  std::partial_sum(sizes.begin(), sizes.end() - 1, cuts.begin());
  for (NewBond& b : rock.bonds) b.strength = std::count(cuts.begin(), cuts.end(), b.j) ? 1e-6 : 1;
  for (NewParticle& p : rock.particles) p.velocity.x = p.position.x;  // 1 /s
  Stage stage(bonded_scene(1e-6, paper_bonds()), out.precision());
  stage.insert({rock});
  stage.advance(100);
  const FragmentTable table = fragment_table(stage.dem().particles());
  const double mass = sphere_mass(grain / 2, rock_density);
  double total = 0;
  out.absolute("fragments", static_cast<double>(table.size()), 5, {0, 0}, "four bonds were weak");
  for (std::size_t k = 0; k < std::min<std::size_t>(table.size(), 5); ++k) {
    out.absolute("spheres-in-" + std::to_string(k), table.rows[k].particles, sizes[k], {0, 0}, "four bonds were weak");
    total += table.rows[k].mass;
  }
  out.relative("mass", total, 168 * mass, {1e-12, 1e-12}, "conserved");
}

constexpr Grains pebbles{.diameter = 0.02};  // [m]; its multiples lie well between the sieve sizes

/// Product and sieve curve of blocks of 1, 2, 5, 20, 140 and 2 x 3 x 5 spheres below the discharge plane.
void product_of_blocks(Recorder& out) {
  struct Kind {
    Vec3<int> n;
    int mesh;  ///< sieve size: b of a box with a >= b >= c [sphere diameters]
  };
  const std::array<Kind, 6> kinds{
      {{{1, 1, 1}, 1}, {{2, 1, 1}, 1}, {{5, 1, 1}, 1}, {{2, 2, 5}, 2}, {{4, 5, 7}, 5}, {{2, 3, 5}, 3}}};
  std::vector<NewRock> rocks;
  ParticleId next = 0;
  std::vector<double> finer(sieve_series().size(), 0.0);
  double spheres = 0;
  for (int copy = 0; copy < 3; ++copy)
    for (const Kind& k : kinds) {
      const auto id = static_cast<RockId>(rocks.size());
      rocks.push_back(placed(block(id, k.n, pebbles), id, next, {1.0 * id, 0, -1}));
      const int n = k.n.x * k.n.y * k.n.z;
      next += static_cast<ParticleId>(n);
      spheres += n;
      for (std::size_t s = 0; s < finer.size(); ++s)
        if (k.mesh * pebbles.diameter <= sieve_series()[s]) finer[s] += n;
    }
  Stage stage(bonded_scene(1e-6, paper_bonds()), out.precision());
  stage.insert(rocks);
  stage.advance(10);
  const ParticleSnapshot now = stage.dem().particles();
  const FragmentTable table = fragment_table(now);
  Product product(rock_density);
  product.update(table, now);
  const ProductRow row = product.row(0);
  const std::string known = "the blocks as built";
  out.absolute("spheres", static_cast<double>(row.particles), spheres, {0, 0}, known);
  out.absolute("fragments", static_cast<double>(row.fragments), 18, {0, 0}, known);
  out.relative("mass", row.mass, spheres * sphere_mass(pebbles.diameter / 2, rock_density), {1e-12, 1e-12}, known);
  double worst = 0;
  for (std::size_t s = 0; s < finer.size(); ++s) worst = std::max(worst, std::abs(row.passing[s] - finer[s] / spheres));
  out.absolute("sieve-curve", worst, 0, {1e-12, 1e-12}, known);
  out.relative("mesh-of-2-3-5", sieve_size(table, 5, now, rock_density), 3 * pebbles.diameter, {2e-3, 2e-3},
               "box a >= b >= c: b");
}

/// In one rock all bonds break at once, in the other no bond breaks.
void all_or_none(Recorder& out) {
  for (const bool broken : {false, true}) {
    NewRock rock = lattice(0, 4);
    for (NewBond& b : rock.bonds) b.strength = broken ? 1e-9 : 1;
    for (NewParticle& p : rock.particles) p.velocity = p.position;
    Stage stage(bonded_scene(1e-6, paper_bonds()), out.precision());
    stage.insert({rock});
    stage.advance(20);
    out.absolute(broken ? "all-broken" : "none-broken",
                 static_cast<double>(fragment_table(stage.dem().particles()).size()), broken ? 64 : 1, {0, 0},
                 "64 spheres");
  }
}

}  // namespace

std::vector<Verification> fragments_cases() {
  return {
      {"fragments/random-graphs", random_graphs, Precisions::double_only},
      {"fragments/chains", chains, Precisions::double_only},
      {"fragments/stars-and-grids", stars_and_grids, Precisions::double_only},
      {"fragments/order-and-threads", order_and_threads, Precisions::double_only},
      {"fragments/pieces-of-a-chain", pieces_of_a_chain},
      {"fragments/product-of-blocks", product_of_blocks, Precisions::double_only},
      {"fragments/all-or-none", all_or_none},
  };
}

}  // namespace gyro::verify

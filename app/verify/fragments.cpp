// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of fragments against union-find, and fragments of known size found again in the engine.
#include "core/state/fragment_labels.hpp"

#include "app/verify/bonded.hpp"
#include "app/verify/check.hpp"
#include "core/fragments/product.hpp"
#include "core/math/random.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gyro::verify {
namespace {

const std::string arbiter = "union-find";

struct Graph {
  Index particles;
  std::vector<Index> i, j;
  void join(Index a, Index b) {
    i.push_back(a);
    j.push_back(b);
  }
};

/// Path halving, labels by smallest index.
std::vector<Index> union_find(const Graph& g) {
  std::vector<Index> parent(static_cast<std::size_t>(g.particles));
  std::iota(parent.begin(), parent.end(), 0);
  const auto up = [&](Index a) -> Index& { return parent[static_cast<std::size_t>(a)]; };
  const auto find = [&](Index a) {
    for (; up(a) != a; a = up(a)) up(a) = up(up(a));
    return a;
  };
  for (std::size_t b = 0; b < g.i.size(); ++b) {
    const Index u = find(g.i[b]), v = find(g.j[b]);
    up(std::max(u, v)) = std::min(u, v);
  }
  std::vector<Index> label(parent.size());
  for (std::size_t a = 0; a < label.size(); ++a) label[a] = find(static_cast<Index>(a));
  return label;
}

Index pick(Index n, std::uint64_t thing, std::uint32_t draw) {
  return std::min(n - 1, static_cast<Index>(uniform(17, Stream::shape, thing, draw) * n));
}

/// A random order of 0 ... n-1.
std::vector<Index> shuffled(Index n) {
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (Index k = n - 1; k > 0; --k)
    std::swap(order[static_cast<std::size_t>(k)],
              order[static_cast<std::size_t>(pick(k + 1, static_cast<std::uint64_t>(k), 9))]);
  return order;
}

Graph random_graph(Index n, double bonds_per_particle) {
  Graph g{n, {}, {}};
  const auto bonds = static_cast<std::uint64_t>(bonds_per_particle * n);
  for (std::uint64_t b = 0; b < bonds; ++b) g.join(pick(n, b, 0), pick(n, b, 1));
  return g;
}

Graph chain_of(const std::vector<Index>& order) {
  Graph g{static_cast<Index>(order.size()), {}, {}};
  for (std::size_t k = 1; k < order.size(); ++k) g.join(order[k - 1], order[k]);
  return g;
}

/// Square grid whose bonds are there with a probability, numbered at random.
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

void compare(Recorder& out, const std::string& name, const Graph& g) {
  const std::vector<Index> got = fragment_labels(g.particles, g.i, g.j), exact = union_find(g);
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
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  compare(out, "along", chain_of(order));
  std::reverse(order.begin(), order.end());
  compare(out, "against", chain_of(order));
  for (Index k = 0; k < n; ++k) order[static_cast<std::size_t>(k)] = k % 2 ? n - 1 - k / 2 : k / 2;
  compare(out, "from-both-ends", chain_of(order));
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
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    compare(out, std::to_string(threads) + "-threads", g);
  }
  omp_set_num_threads(before);
}

/// A chain of 168 spheres with four weak bonds, pulled: they break at once and leave 1, 2, 5, 20 and 140.
void pieces_of_a_chain(Recorder& out) {
  const std::array<int, 5> sizes{1, 2, 5, 20, 140};
  NewRock rock = chain(0, 167, false);
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
  out.relative("mass", total, 168 * mass, {1e-12, 1e-12}, "nothing is lost");
}

constexpr double pebble = 0.02;  // diameter; its multiples lie well between sieves [m]

/// nx x ny x nz touching spheres, bonded along x, y and z.
NewRock block(RockId id, int nx, int ny, int nz, ParticleId first, const Vec3d& at) {
  NewRock rock;
  rock.id = id;
  for (int p = 0; p < nx * ny * nz; ++p)
    rock.particles.push_back({first + static_cast<ParticleId>(p),
                              at + pebble * Vec3d{double(p % nx), double(p / nx % ny), double(p / nx / ny)},
                              {0, 0, 0},
                              {0, 0, 0},
                              pebble / 2,
                              rock_density});
  rock.colour_begin = {0};
  const int count[3] = {nx, ny, nz}, stride[3] = {1, nx, nx * ny};
  for (int axis = 0; axis < 3; ++axis)
    for (int odd = 0; odd < 2; ++odd) {
      for (int p = 0; p < nx * ny * nz; ++p) {
        const int along = p / stride[axis] % count[axis];
        if (along % 2 == odd && along + 1 < count[axis])
          rock.bonds.push_back({p, p + stride[axis], pebble, bond_radius, 1});
      }
      rock.colour_begin.push_back(static_cast<Index>(rock.bonds.size()));
    }
  return rock;
}

/// Rocks of 1, 2, 5, 20 and 140 spheres and 2 x 3 x 5 ones below the discharge plane: product and sieve curve.
void product_of_blocks(Recorder& out) {
  struct Kind {
    int nx, ny, nz, mesh;  ///< mesh of a box a >= b >= c: b [pebbles]
  };
  const std::array<Kind, 6> kinds{{{1, 1, 1, 1}, {2, 1, 1, 1}, {5, 1, 1, 1}, {2, 2, 5, 2}, {4, 5, 7, 5}, {2, 3, 5, 3}}};
  std::vector<NewRock> rocks;
  ParticleId next = 0;
  std::vector<double> finer(sieve_series().size(), 0.0);
  double spheres = 0;
  for (int copy = 0; copy < 3; ++copy)
    for (const Kind& k : kinds) {
      const auto id = static_cast<RockId>(rocks.size());
      rocks.push_back(block(id, k.nx, k.ny, k.nz, next, {1.0 * id, 0, -1}));
      const int n = k.nx * k.ny * k.nz;
      next += static_cast<ParticleId>(n);
      spheres += n;
      for (std::size_t s = 0; s < finer.size(); ++s)
        if (k.mesh * pebble <= sieve_series()[s]) finer[s] += n;
    }
  Stage stage(bonded_scene(1e-6, paper_bonds()), out.precision());
  stage.insert(rocks);
  stage.advance(10);
  const ParticleSnapshot now = stage.dem().particles();
  const FragmentTable table = fragment_table(now);
  Product product(rock_density);
  product.update(table, now);
  const ProductRow row = product.row(0);
  const std::string known = "as built";
  out.absolute("spheres", static_cast<double>(row.particles), spheres, {0, 0}, known);
  out.absolute("fragments", static_cast<double>(row.fragments), 18, {0, 0}, known);
  out.relative("mass", row.mass, spheres * sphere_mass(pebble / 2, rock_density), {1e-12, 1e-12}, known);
  double worst = 0;
  for (std::size_t s = 0; s < finer.size(); ++s) worst = std::max(worst, std::abs(row.passing[s] - finer[s] / spheres));
  out.absolute("sieve-curve", worst, 0, {1e-12, 1e-12}, known);
  out.relative("mesh-of-2-3-5", sieve_size(table, 5, now, rock_density), 3 * pebble, {2e-3, 2e-3},
               "box a >= b >= c: b");
}

/// Every bond of a rock at once, or none.
void all_or_none(Recorder& out) {
  for (const bool broken : {false, true}) {
    NewRock rock = lattice(0, 4, bond_radius);
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

const std::array<Case, 7> cases{{
    {"fragments/random-graphs", random_graphs, Case::Precisions::one},
    {"fragments/chains", chains, Case::Precisions::one},
    {"fragments/stars-and-grids", stars_and_grids, Case::Precisions::one},
    {"fragments/order-and-threads", order_and_threads, Case::Precisions::one},
    {"fragments/pieces-of-a-chain", pieces_of_a_chain},
    {"fragments/product-of-blocks", product_of_blocks, Case::Precisions::one},
    {"fragments/all-or-none", all_or_none},
}};

}  // namespace

std::span<const Case> fragments_cases() {
  return cases;
}

}  // namespace gyro::verify

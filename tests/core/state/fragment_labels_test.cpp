// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/fragment_labels.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <numeric>

using namespace gyro;

namespace {

struct Graph {
  Index particles;
  std::vector<Index> i, j;
  void join(Index a, Index b) {
    i.push_back(a);
    j.push_back(b);
  }
};

/// The arbiter: union-find with path halving, labels by smallest index.
std::vector<Index> union_find(const Graph& g) {
  std::vector<Index> parent(static_cast<std::size_t>(g.particles));
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](Index a) {
    auto& p = parent;
    while (p[static_cast<std::size_t>(a)] != a) {
      p[static_cast<std::size_t>(a)] = p[static_cast<std::size_t>(p[static_cast<std::size_t>(a)])];
      a = p[static_cast<std::size_t>(a)];
    }
    return a;
  };
  for (std::size_t b = 0; b < g.i.size(); ++b) {
    const Index u = find(g.i[b]), v = find(g.j[b]);
    parent[static_cast<std::size_t>(std::max(u, v))] = std::min(u, v);
  }
  std::vector<Index> label(parent.size());
  for (std::size_t a = 0; a < label.size(); ++a) label[a] = find(static_cast<Index>(a));
  return label;
}

Index pick(Index n, std::uint64_t seed, std::uint64_t thing, std::uint32_t draw) {
  return std::min(n - 1, static_cast<Index>(uniform(seed, Stream::shape, thing, draw) * n));
}

/// A random order of 0 ... n-1.
std::vector<Index> shuffled(Index n, std::uint64_t seed) {
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (Index k = n - 1; k > 0; --k) {
    std::swap(order[static_cast<std::size_t>(k)],
              order[static_cast<std::size_t>(pick(k + 1, seed, std::uint64_t(k), 9))]);
  }
  return order;
}

/// A chain whose particles are numbered in the given order along it.
Graph chain(const std::vector<Index>& order) {
  Graph g{static_cast<Index>(order.size()), {}, {}};
  for (std::size_t k = 1; k < order.size(); ++k) g.join(order[k - 1], order[k]);
  return g;
}

std::vector<Index> labels(const Graph& g) {
  return fragment_labels(g.particles, g.i, g.j);
}

/// Rounds of hooking that a graph needs, counted from outside.
int hook_rounds(const Graph& g) {
  struct Flag {
    Index value = 0;
    Index* address() { return &value; }
    void lower() { value = 0; }
    bool raised() const { return value != 0; }
  } flag;
  int rounds = 0;
  std::vector<Index> label(static_cast<std::size_t>(g.particles)), scratch(label.size());
  const auto loop = [&](const std::string& name, Index n, const auto& kernel) {
    rounds += name == "hook_roots";
    for (Index k = 0; k < n; ++k) kernel(k);
  };
  label_fragments<CpuAtomics>(
      {g.particles, static_cast<Index>(g.i.size()), g.i.data(), g.j.data(), label.data(), scratch.data()}, loop, flag);
  return rounds;
}

}  // namespace

TEST_CASE("Rounds of hooking grow as the logarithm of a chain", "[fragments]") {
  const Index n = GENERATE(2, 1000, 1000000);
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  SECTION("numbered along the chain") {}
  SECTION("numbered against it") {
    std::reverse(order.begin(), order.end());
  }
  SECTION("numbered at random") {
    order = shuffled(n, 5);
  }
  SECTION("low and high numbers in turn") {
    for (Index k = 0; k < n; ++k) order[static_cast<std::size_t>(k)] = k % 2 ? n - 1 - k / 2 : k / 2;
  }
  const Graph g = chain(order);
  // log2(1e6) = 20; at least every second round joins every tree that can grow.
  CHECK(hook_rounds(g) <= 2 + 2 * 20);
}

TEST_CASE("A chain cut in two is two fragments", "[fragments]") {
  Graph g = chain(shuffled(5000, 6));
  g.i.erase(g.i.begin() + 2500);
  g.j.erase(g.j.begin() + 2500);
  const std::vector<Index> label = labels(g);
  CHECK(label == union_find(g));
  std::vector<Index> distinct = label;
  std::sort(distinct.begin(), distinct.end());
  CHECK(std::unique(distinct.begin(), distinct.end()) - distinct.begin() == 2);
}

TEST_CASE("Without bonds every particle is its own fragment", "[fragments]") {
  const std::vector<Index> label = labels(Graph{1000, {}, {}});
  for (Index k = 0; k < 1000; ++k) CHECK(label[static_cast<std::size_t>(k)] == k);
  CHECK(labels(Graph{0, {}, {}}).empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/fragment_labels.hpp"
#include "app/verify/fixtures/graphs.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"

#include <algorithm>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

std::vector<Index> labels(const Graph& g) {
  return fragment_labels(g.particles, g.i, g.j);
}

/// Number of rounds of hooking that a graph needs.
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
  std::vector<Index> order = in_order(n);
  SECTION("numbered along the chain") {}
  SECTION("numbered against it") {
    std::reverse(order.begin(), order.end());
  }
  SECTION("numbered at random") {
    order = shuffled(n);
  }
  SECTION("low and high numbers alternate") {
    order = from_both_ends(n);
  }
  const Graph g = chain_of(order);
  // log2(1e6) = 20; at least every second round joins every tree that can grow.
  CHECK(hook_rounds(g) <= 2 + 2 * 20);
}

TEST_CASE("A chain cut in two is two fragments", "[fragments]") {
  Graph g = chain_of(shuffled(5000));
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

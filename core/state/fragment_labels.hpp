// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

#include <atomic>
#include <span>
#include <utility>
#include <vector>

namespace gyro {

class ThreadTeam;

/// Every particle its own tree.
struct PlantTrees {
  Index* parent;
  GYRO_HD void operator()(Index i) const { parent[i] = i; }
};

/// Hangs the higher of two roots that a bond joins under the lower one. Of several bonds that
/// want the same root the lowest offer wins, whatever their order.
///
/// @tparam Atomics  `lower(Index* a, Index v)`: a = min(a, v) as one operation; `raise(Index* a)`: a = 1
template <class Atomics>
struct HookRoots {
  const Index* bond_i;
  const Index* bond_j;
  const Index* root;  ///< of every particle, before this round
  Index* parent;      ///< starts as a copy of root
  Index* changed;     ///< set to 1 when two trees were joined
  Atomics atomics;
  GYRO_HD void operator()(Index b) const {
    const Index u = root[bond_i[b]], v = root[bond_j[b]];
    if (u == v) return;
    atomics.lower(parent + (u > v ? u : v), u < v ? u : v);
    atomics.raise(changed);
  }
};

/// Halves the path to the root: reads one array and writes another, so no order matters.
template <class Atomics>
struct JumpToGrandparent {
  const Index* parent;
  Index* shorter;
  Index* changed;
  Atomics atomics;
  GYRO_HD void operator()(Index i) const {
    const Index p = parent[i], grandparent = parent[p];
    shorter[i] = grandparent;
    if (grandparent != p) atomics.raise(changed);
  }
};

/// The two operations of `HookRoots` on the CPU.
struct CpuAtomics {
  void lower(Index* a, Index v) const {
    const std::atomic_ref<Index> target(*a);
    Index now = target.load(std::memory_order_relaxed);
    while (v < now && !target.compare_exchange_weak(now, v, std::memory_order_relaxed)) {
    }
  }
  void raise(Index* a) const { std::atomic_ref<Index>(*a).store(1, std::memory_order_relaxed); }
};

/// What labelling works on; all arrays in the memory of the loop that runs the kernels.
struct LabelArrays {
  Index particles, bonds;
  const Index* bond_i;  ///< [bonds]
  const Index* bond_j;  ///< [bonds]
  Index* label;         ///< [particles], the result
  Index* scratch;       ///< [particles]
};

/// Labels fragments: the connected components of particles and bonds, each by the smallest
/// index in it. The result depends on neither the order of bonds nor the number of threads.
///
/// Hook and jump to a fixed point (Shiloach & Vishkin 1982, J. Algorithms 3, 57-67): a tree that
/// can grow meets another at the latest in the second round, so rounds grow as log(particles);
/// paths halve in every jump. The paper's fixed four to five passes would cut long chains apart.
///
/// @param loop  loop(name, n, kernel) runs kernel(i) for i in [0, n)
/// @param flag  lower_flag() sets the flag of the kernels to 0, raised() reads it, address() is its place
template <class Atomics, class Loop, class Flag>
void label_fragments(const LabelArrays& a, const Loop& loop, Flag&& flag) {
  Index* root = a.label;
  Index* next = a.scratch;
  loop("plant_trees", a.particles, PlantTrees{root});
  for (;;) {
    loop("copy_roots", a.particles, JumpToGrandparent<Atomics>{root, next, flag.address(), {}});
    flag.lower();
    loop("hook_roots", a.bonds, HookRoots<Atomics>{a.bond_i, a.bond_j, root, next, flag.address(), {}});
    if (!flag.raised()) break;
    do {
      flag.lower();
      loop("jump", a.particles, JumpToGrandparent<Atomics>{next, root, flag.address(), {}});
      std::swap(root, next);
    } while (flag.raised());
    std::swap(root, next);
  }
  if (root != a.label) loop("copy_roots", a.particles, JumpToGrandparent<Atomics>{root, a.label, flag.address(), {}});
}

/// The same on the host.
/// @param bond_i, bond_j  ends of the bonds, each in [0, particles)
/// @return label of every particle: the smallest index of its fragment
/// @param team  shares the work where there is enough of it; null: the caller's thread does it
std::vector<Index> fragment_labels(Index particles, std::span<const Index> bond_i, std::span<const Index> bond_j,
                                   ThreadTeam* team = nullptr);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/fragment_labels.hpp"

#include "core/base/thread_team.hpp"

#include <algorithm>

namespace gyro {
namespace {

constexpr Index shared_from = 4096;  // items; below, waking the threads costs more than the work

struct HostLoop {
  ThreadTeam* team;

  template <class Kernel>
  void operator()(const char*, Index n, const Kernel& kernel) const {
    const Index threads = team != nullptr && n > shared_from ? team->size() : 1;
    const Index share = (n + threads - 1) / threads;
    const auto part = [&](int t) {
      const Index end = std::min(n, (t + 1) * share);
      for (Index i = t * share; i < end; ++i) kernel(i);
    };
    if (threads == 1)
      part(0);
    else
      team->run(part);
  }
};

struct HostFlag {
  Index value = 0;
  Index* address() { return &value; }
  void lower() { value = 0; }
  bool raised() const { return value != 0; }
};

}  // namespace

std::vector<Index> fragment_labels(Index particles, std::span<const Index> bond_i, std::span<const Index> bond_j,
                                   ThreadTeam* team) {
  const auto size = static_cast<std::size_t>(particles);
  std::vector<Index> label(size), scratch(size);
  HostFlag flag;
  label_fragments<CpuAtomics>({.particles = particles,
                               .bonds = static_cast<Index>(std::min(bond_i.size(), bond_j.size())),
                               .bond_i = bond_i.data(),
                               .bond_j = bond_j.data(),
                               .label = label.data(),
                               .scratch = scratch.data()},
                              HostLoop{team}, flag);
  return label;
}

}  // namespace gyro

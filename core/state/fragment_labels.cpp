// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/fragment_labels.hpp"

#include <algorithm>

namespace gyro {
namespace {

struct OpenMpLoop {
  template <class Kernel>
  void operator()(const char*, Index n, const Kernel& kernel) const {
    // Below some thousand items waking the threads costs more than the work.
#pragma omp parallel for schedule(static) if (n > 4096)
    for (Index i = 0; i < n; ++i) kernel(i);
  }
};

struct HostFlag {
  Index value = 0;
  Index* address() { return &value; }
  void lower() { value = 0; }
  bool raised() const { return value != 0; }
};

}  // namespace

std::vector<Index> fragment_labels(Index particles, std::span<const Index> bond_i, std::span<const Index> bond_j) {
  const auto size = static_cast<std::size_t>(particles);
  std::vector<Index> label(size), scratch(size);
  HostFlag flag;
  label_fragments<CpuAtomics>({.particles = particles,
                               .bonds = static_cast<Index>(std::min(bond_i.size(), bond_j.size())),
                               .bond_i = bond_i.data(),
                               .bond_j = bond_j.data(),
                               .label = label.data(),
                               .scratch = scratch.data()},
                              OpenMpLoop{}, flag);
  return label;
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/size.hpp"

#include "core/fragments/fragment_table.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace gyro::bench {

double passing_size(std::span<const double> sizes, std::span<const double> masses, double share) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  const double total = std::accumulate(masses.begin(), masses.end(), 0.0), wanted = share * total;
  double passed = 0, middle_before = 0, size_before = sizes[order.front()];
  for (const std::size_t k : order) {
    const double middle = passed + masses[k] / 2;
    if (middle >= wanted) {
      const double weight = middle > middle_before ? (wanted - middle_before) / (middle - middle_before) : 1;
      return size_before + weight * (sizes[k] - size_before);
    }
    passed += masses[k];
    middle_before = middle;
    size_before = sizes[k];
  }
  return size_before;
}

Sizes sizes_of(const ParticleSnapshot& particles, double density) {
  const FragmentTable table = fragment_table(particles);
  std::vector<double> size, mass;
  Sizes out;
  for (const Fragment& f : table.rows) {
    size.push_back(equal_mass_diameter(f.mass, density));
    mass.push_back(f.mass);
    out.mass += f.mass;
    out.mean += f.mass * size.back();
  }
  out.mean /= out.mass;
  out.p80 = passing_size(size, mass, 0.8);
  return out;
}

}  // namespace gyro::bench

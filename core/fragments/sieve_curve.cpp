// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/sieve_curve.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

constexpr int finest = -14, coarsest = 6;

std::vector<double> make_series() {
  std::vector<double> sizes;
  for (int k = finest; k <= coarsest; ++k) sizes.push_back(0.125 * std::exp2(0.5 * k));
  return sizes;
}

}  // namespace

const std::vector<double>& sieve_series() {
  static const std::vector<double> sizes = make_series();
  return sizes;
}

std::size_t sieve_of(const std::vector<double>& sieves, double size) {
  return static_cast<std::size_t>(std::lower_bound(sieves.begin(), sieves.end(), size) - sieves.begin());
}

std::optional<double> passing_size(const std::vector<double>& sieves, const std::vector<double>& passing,
                                   double share) {
  const auto above = std::lower_bound(passing.begin(), passing.end(), share);
  if (above == passing.begin() || above == passing.end()) return std::nullopt;
  const auto k = static_cast<std::size_t>(above - passing.begin());
  const double part = (share - passing[k - 1]) / (passing[k] - passing[k - 1]);
  return sieves[k - 1] * std::pow(sieves[k] / sieves[k - 1], part);
}

std::optional<double> passing_at(const std::vector<double>& sieves, const std::vector<double>& passing, double size) {
  if (!(size >= sieves.front() && size <= sieves.back())) return std::nullopt;
  const std::size_t k = sieve_of(sieves, size);
  if (k == 0) return passing.front();
  const double part = std::log(size / sieves[k - 1]) / std::log(sieves[k] / sieves[k - 1]);
  return passing[k - 1] + part * (passing[k] - passing[k - 1]);
}

void SieveTally::add(const std::vector<double>& sieves, double size, double fragment_mass,
                     std::int64_t fragment_particles) {
  sieve_mass.resize(sieves.size() + 1);
  ++fragments;
  particles += fragment_particles;
  mass += fragment_mass;
  sieve_mass[sieve_of(sieves, size)] += fragment_mass;
  if (fragment_particles == 1) singles_mass += fragment_mass;
}

ProductRow SieveTally::row(const std::vector<double>& sieves, double time) const {
  ProductRow row;
  row.sieves = sieves;
  row.time = time;
  row.mass = mass;
  row.particles = particles;
  row.fragments = fragments;
  row.passing.assign(sieves.size(), 0.0);
  if (!(mass > 0)) return row;
  row.singles_share = singles_mass / mass;
  double total = 0, finer = 0;
  for (const double m : sieve_mass) total += m;
  for (std::size_t k = 0; k < row.passing.size(); ++k) {
    finer += sieve_mass[k];
    row.passing[k] = finer / total;
  }
  row.p80 = passing_size(sieves, row.passing, 0.8);
  row.p50 = passing_size(sieves, row.passing, 0.5);
  return row;
}

}  // namespace gyro

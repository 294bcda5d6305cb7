// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fines_law.hpp"

#include "core/fragments/incomplete_beta.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

struct BetaParameters {
  double alpha, beta;
};
/// By TnFamily::n_values; alpha = beta = 1 makes t10 itself.
constexpr std::array<BetaParameters, TnFamily::n_values.size()> tn_parameters{
    {{0.51, 11.95}, {1.07, 13.87}, {1.01, 8.09}, {1.08, 3.03}, {1, 1}, {1.01, 0.53}, {1.03, 0.36}, {1.03, 0.30}}};

/// A rock of one particle has not broken.
constexpr double larger_than_its_particle = 1 + 1e-9;

}  // namespace

double t10_of(const BreakageFines& ore, double energy) {
  return -ore.A * std::expm1(-ore.b * (std::max(energy, 0.0) / ore.released_share));
}

TnFamily tn_family(double t10) {
  TnFamily family{};
  for (std::size_t k = family.t.size(); k-- > 0;) {
    family.t[k] = incomplete_beta(t10, tn_parameters[k].alpha, tn_parameters[k].beta);
    if (k + 1 < family.t.size()) family.t[k] = std::max(family.t[k], family.t[k + 1]);
  }
  return family;
}

double tn_of(const TnFamily& family, double n) {
  const auto& values = TnFamily::n_values;
  if (n <= values.front()) return family.t.front();
  // The interval of the table that contains n. Beyond the table the last interval is extrapolated.
  const auto end = std::min<std::size_t>(
      static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), n) - values.begin()), values.size() - 1);
  const double begin = values[end - 1], share = family.t[end - 1];
  if (!(family.t[end] > 0)) return 0;
  return share * std::pow(family.t[end] / share, std::log(n / begin) / std::log(values[end] / begin));
}

FragmentFines::FragmentFines(const FinesLaw& law, const FragmentOrigin& origin) : origin_(origin) {
  if (const auto* ore = std::get_if<BreakageFines>(&law)) {
    t10_ = t10_of(*ore, origin.energy);
    any_ = *t10_ > 0 && origin.rock_size > larger_than_its_particle * origin.resolution;
    if (any_) family_ = tn_family(*t10_);
  } else {
    exponent_ = std::get<SchuhmannFines>(law).m;
    any_ = origin.single && origin.rock_size > larger_than_its_particle * origin.resolution;
  }
}

double FragmentFines::finer_than(double size) const {
  if (!any_) return 0;
  const double limited = std::min(size, origin_.resolution);
  return t10_ ? tn_of(family_, origin_.rock_size / limited) : std::pow(limited / origin_.resolution, exponent_);
}

}  // namespace gyro

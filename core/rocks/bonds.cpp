// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/bonds.hpp"

#include "core/base/errors.hpp"
#include "core/scene/bond_colours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyro {
namespace {

double section_radius(const RelativeBondRadius& rule, double ri, double rj) {
  return rule.factor * std::min(ri, rj);
}
double section_radius(const AbsoluteBondRadius& rule, double, double) {
  return rule.radius;
}
double section_radius(const ContactAreaBond& rule, double ri, double rj) {
  return std::sqrt(rule.factor) * 2 * ri * rj / (ri + rj);
}

}  // namespace

double bond_radius(const BondRule& rule, double ri, double rj) {
  return std::visit([&](const auto& r) { return section_radius(r, ri, rj); }, rule.radius);
}

void check_rule(const BondRule& rule) {
  if (!(rule.gap >= 0 && rule.gap < 1)) {
    throw BadInput("bonds.gap is " + std::to_string(rule.gap) +
                   "; it must be >= 0 and < 1, in radii of the smaller particle");
  }
  const double radius = bond_radius(rule, 1, 1);
  if (!(std::isfinite(radius) && radius > 0)) throw BadInput("bonds.radius must be a finite number above 0");
}

std::vector<TemplateBond> make_bonds(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     const BondRule& rule) {
  const Index n = static_cast<Index>(centres.size());
  // Sweep along x: the distance of bonded spheres is at most the largest possible reach.
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return centres[a].x != centres[b].x ? centres[a].x < centres[b].x : a < b; });
  const double largest = radii.empty() ? 0 : *std::max_element(radii.begin(), radii.end());
  std::vector<TemplateBond> bonds;
  for (Index a = 0; a < n; ++a) {
    for (Index b = a + 1; b < n; ++b) {
      const auto [i, j] = std::pair{std::min(order[a], order[b]), std::max(order[a], order[b])};
      if (centres[order[b]].x - centres[order[a]].x > (1 + rule.gap) * radii[order[a]] + largest) break;
      const double length = norm(centres[j] - centres[i]), smaller = std::min(radii[i], radii[j]);
      if (length - radii[i] - radii[j] < rule.gap * smaller) {
        bonds.push_back({i, j, length, bond_radius(rule, radii[i], radii[j])});
      }
    }
  }
  std::sort(bonds.begin(), bonds.end(),
            [](const TemplateBond& p, const TemplateBond& q) { return p.i != q.i ? p.i < q.i : p.j < q.j; });
  return bonds;
}

std::vector<Index> colour_bonds(std::vector<TemplateBond>& bonds, Index particles) {
  std::sort(bonds.begin(), bonds.end(),
            [](const TemplateBond& p, const TemplateBond& q) { return p.i != q.i ? p.i < q.i : p.j < q.j; });
  BondColours colours(static_cast<std::size_t>(particles));
  std::vector<std::vector<TemplateBond>> groups;
  for (const TemplateBond& bond : bonds) {
    const std::size_t colour = colours.next(bond.i, bond.j);
    if (groups.size() <= colour) groups.resize(colour + 1);
    groups[colour].push_back(bond);
  }
  std::vector<Index> begin{0};
  bonds.clear();
  for (const auto& group : groups) {
    bonds.insert(bonds.end(), group.begin(), group.end());
    begin.push_back(static_cast<Index>(bonds.size()));
  }
  return begin;
}

std::vector<Index> largest_piece(const std::vector<TemplateBond>& bonds, Index particles) {
  std::vector<Index> parent(particles), size(particles, 0);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const TemplateBond& bond : bonds) {
    const Index a = root(bond.i), b = root(bond.j);
    parent[std::max(a, b)] = std::min(a, b);
  }
  for (Index p = 0; p < particles; ++p) ++size[root(p)];
  const Index best = static_cast<Index>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<Index> piece;
  for (Index p = 0; p < particles; ++p) {
    if (root(p) == best) piece.push_back(p);
  }
  return piece;
}

}  // namespace gyro

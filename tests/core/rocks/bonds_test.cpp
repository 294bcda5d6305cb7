// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/bonds.hpp"
#include "core/base/errors.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"

#include <set>

using namespace gyro;

namespace {

struct Spheres {
  std::vector<Vec3d> centres;
  std::vector<double> radii;
};

/// Spheres of mixed sizes at random positions, so dense that many overlap.
Spheres strewn(int n) {
  Spheres s;
  for (int k = 0; k < n; ++k) {
    const auto draw = [&](std::uint32_t d) { return uniform(9, Stream::place, k, d); };
    s.centres.push_back({draw(0), draw(1), draw(2)});
    s.radii.push_back(0.02 + 0.08 * draw(3));
  }
  return s;
}

}  // namespace

TEST_CASE("A bond needs a gap below the fraction of the smaller radius") {
  const std::vector<double> radii{1, 0.5};
  const BondRule rule{0.1, RelativeBondRadius{0.5}};
  CHECK(make_bonds({{0, 0, 0}, {1.5499, 0, 0}}, radii, rule).size() == 1);
  CHECK(make_bonds({{0, 0, 0}, {1.5501, 0, 0}}, radii, rule).empty());
  const TemplateBond bond = make_bonds({{0, 0, 0}, {0, 1.52, 0}}, radii, rule)[0];
  CHECK(bond.length == Approx(1.52));
  CHECK(bond.radius == 0.25);
  CHECK(make_bonds({{0, 0, 0}, {0, 1.52, 0}}, radii, {0.1, AbsoluteBondRadius{0.7}})[0].radius == 0.7);
}

TEST_CASE("A bond by contact area has a section proportional to the square of the harmonic mean radius") {
  const BondRule rule{0.1, ContactAreaBond{0.3}};
  const auto section = [&](double ri, double rj) {
    const double b = make_bonds({{0, 0, 0}, {ri + rj, 0, 0}}, {ri, rj}, rule).at(0).radius;
    return b * b;
  };
  CHECK(section(1, 1) == Approx(0.3));
  CHECK(section(3, 3) == Approx(0.3 * 9));
  CHECK(section(1, 3) == Approx(0.3 * 1.5 * 1.5));
  CHECK(section(1e-3, 1e3) == Approx(0.3 * 4e-6));  // the smaller sphere determines it
  CHECK_THROWS_AS(check_rule({0.1, ContactAreaBond{0}}), BadInput);
}

TEST_CASE("The sweep finds the same bonds as a test of all pairs") {
  const Spheres s = strewn(300);
  const BondRule rule{0.3, RelativeBondRadius{1}};
  std::vector<std::pair<Index, Index>> expected, found;
  for (Index i = 0; i < 300; ++i) {
    for (Index j = i + 1; j < 300; ++j) {
      const double gap = norm(s.centres[i] - s.centres[j]) - s.radii[i] - s.radii[j];
      if (gap < 0.3 * std::min(s.radii[i], s.radii[j])) expected.emplace_back(i, j);
    }
  }
  for (const TemplateBond& b : make_bonds(s.centres, s.radii, rule)) found.emplace_back(b.i, b.j);
  CHECK(expected.size() > 400);
  CHECK(found == expected);
}

TEST_CASE("Two bonds of one colour share no particle") {
  const Spheres s = strewn(300);
  std::vector<TemplateBond> bonds = make_bonds(s.centres, s.radii, {0.3, RelativeBondRadius{1}});
  const std::size_t count = bonds.size();
  std::vector<int> degree(300, 0);
  for (const TemplateBond& b : bonds) ++degree[b.i], ++degree[b.j];
  const int maximum = *std::max_element(degree.begin(), degree.end());
  const std::vector<Index> begin = colour_bonds(bonds, 300);
  REQUIRE(bonds.size() == count);
  CHECK(begin.front() == 0);
  CHECK(begin.back() == static_cast<Index>(count));
  CHECK(static_cast<int>(begin.size()) - 1 >= maximum);
  CHECK(static_cast<int>(begin.size()) - 1 <= 2 * maximum - 1);
  for (std::size_t c = 0; c + 1 < begin.size(); ++c) {
    std::set<Index> met;
    for (Index k = begin[c]; k < begin[c + 1]; ++k) {
      CHECK(met.insert(bonds[k].i).second);
      CHECK(met.insert(bonds[k].j).second);
      if (k > begin[c]) CHECK(std::pair(bonds[k - 1].i, bonds[k - 1].j) < std::pair(bonds[k].i, bonds[k].j));
    }
  }
}

TEST_CASE("The largest piece is found, and a set without bonds is allowed") {
  const auto bond = [](Index i, Index j) { return TemplateBond{i, j, 1, 1}; };
  CHECK(largest_piece({bond(0, 1), bond(2, 4), bond(4, 5)}, 6) == std::vector<Index>{2, 4, 5});
  CHECK(largest_piece({}, 3) == std::vector<Index>{0});
  CHECK(largest_piece({}, 0).empty());
  std::vector<TemplateBond> no_bonds;
  CHECK(colour_bonds(no_bonds, 3) == std::vector<Index>{0});
}

TEST_CASE("A rule out of range is refused") {
  CHECK_NOTHROW(check_rule({}));
  for (const BondRule& rule : {BondRule{-0.1, RelativeBondRadius{1}}, BondRule{1, RelativeBondRadius{1}},
                               BondRule{0.1, RelativeBondRadius{0}}, BondRule{0.1, AbsoluteBondRadius{-1}}}) {
    CHECK_THROWS_AS(check_rule(rule), BadInput);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/library.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

const RangeFill range{0.008, 0.045, 0.8};

/// Largest overlap / smaller radius.
double deepest(const std::vector<Vec3d>& centres, const std::vector<double>& radii) {
  double overlap = 0;
  for (const TemplateBond& b : make_bonds(centres, radii, {0, RelativeBondRadius{1}}))
    overlap = std::max(overlap, (radii[b.i] + radii[b.j] - b.length) / std::min(radii[b.i], radii[b.j]));
  return overlap;
}

}  // namespace

TEST_CASE("The grading is a power law of volume") {
  const Grading grading{5.625, 0.8};
  CHECK(radius_at(grading, 0) == Approx(1));
  CHECK(radius_at(grading, 1) == Approx(5.625));
  double volume = 0, finer_than_3 = 0;
  constexpr int n = 100000;
  for (int k = 0; k < n; ++k) {
    const double r = radius_at(grading, (k + 0.5) / n);
    volume += r * r * r;
    if (r < 3) finer_than_3 += r * r * r;
  }
  CHECK(volume / n == Approx(mean_cubed_radius(grading)).epsilon(1e-3));
  CHECK(finer_than_3 / volume == Approx((std::pow(3, 0.8) - 1) / (std::pow(5.625, 0.8) - 1)).epsilon(1e-3));
  const Grading logarithmic{4, 3};  // the exponent at which the formula has a hole
  CHECK(radius_at(logarithmic, 0.5) == Approx(2));
  CHECK(mean_cubed_radius(logarithmic) == Approx(21 / std::log(4.0)));
  CHECK(mean_cubed_radius({1, 0.8}) == 1);
}

TEST_CASE("A packing of many sizes is denser than one of equal spheres, and hardly overlaps") {
  const Packing& packing = rock_packing(Grading{3, 0.8});
  CHECK(packing.fraction > 0.655);  // equal spheres: 0.632
  CHECK(packing.fraction < 0.72);
  CHECK(packing.overlap < 0.01);
  double volume = 0;
  for (const double r : packing.radii) volume += 4 * std::numbers::pi / 3 * r * r * r;
  CHECK(packing.fraction == Approx(volume / std::pow(packing.side, 3)));
  CHECK(*std::min_element(packing.radii.begin(), packing.radii.end()) == Approx(1).epsilon(0.01));
  CHECK(*std::max_element(packing.radii.begin(), packing.radii.end()) == Approx(3).epsilon(0.01));
}

TEST_CASE("Rocks filled with a range of sizes: one piece, exact mass, small errors") {
  const double diameter = GENERATE(0.05, 0.08, 0.13);
  LibraryRecipe recipe;
  recipe.shapes = ProceduralShapes{3};
  recipe.sizes = PassingTable{{{0.99 * diameter, 0}, {1.01 * diameter, 1}}};
  recipe.samples = 3;
  recipe.fill = range;
  recipe.rock_density = 2600;
  recipe.bond_parameters = {1.67e12, 6.67e11, 36e6, 24e6, 0.05};
  for (const RockTemplate& rock : make_library(recipe).rocks) {
    CAPTURE(rock.diameter, rock.centres.size(), rock.packing_fraction, rock.inertia_error, rock.coordination);
    CHECK(rock.centres.size() >= 40);
    CHECK(largest_piece(rock.bonds, static_cast<Index>(rock.centres.size())).size() == rock.centres.size());
    CHECK(std::abs(rock.mass_error) < 1e-12);
    CHECK(rock.packing_fraction > 0.6);
    CHECK(rock.packing_fraction < 0.73);
    CHECK(rock.inertia_error < 0.10);
    CHECK(rock.centre_error < 0.03);
    CHECK(rock.coordination > 4);
    CHECK(norm(centre_of_mass(rock.centres, rock.radii)) < 1e-12 * rock.diameter);
    CHECK(deepest(rock.centres, rock.radii) < 0.01);
    const auto [minimum, maximum] = std::minmax_element(rock.radii.begin(), rock.radii.end());
    CHECK(2 * *minimum > 0.008);
    CHECK(2 * *minimum < 0.0085);
    CHECK(2 * *maximum < rock.diameter / 3);
    CHECK(2 * *maximum > 0.6 * rock.diameter / 3);
  }
}

TEST_CASE("Rocks of similar size share a packing, and a large one has the whole range") {
  CHECK(grading_of(range, 0.5) == Grading{45.0 / 8, 0.8});
  CHECK(grading_of(range, 0.136) == Grading{45.0 / 8, 0.8});
  CHECK(grading_of(range, 0.120) == grading_of(range, 0.116));
  CHECK(grading_of(range, 0.100).ratio <= 100.0 / 3 / 8);
  CHECK(grading_of(range, 0.024).ratio == Approx(1));
}

TEST_CASE("Ranges that cannot fill a rock are refused with the reason") {
  const Mould mould(procedural_shape(1, 0));
  CHECK_THROWS_WITH(fill(mould, range, {}, {0.02, 1, 0}), Contains("too small for particles from 8 mm on"));
  CHECK_THROWS_WITH(fill(mould, range, {}, {1.5, 1, 0}), Contains("the limit is 100000"));
  CHECK_THROWS_WITH(fill(mould, RangeFill{0.045, 0.008}, {}, {0.5, 1, 0}), Contains("must be above the smallest"));
  CHECK_THROWS_WITH(fill(mould, RangeFill{0.001, 0.045}, {}, {0.5, 1, 0}), Contains("at most 8 times"));
  CHECK_THROWS_WITH(fill(mould, RangeFill{0.008, 0.045, 0}, {}, {0.5, 1, 0}), Contains("exponent"));
  CHECK_THROWS_AS(fill(mould, RangeFill{NAN, 0.045}, {}, {0.5, 1, 0}), BadInput);
}

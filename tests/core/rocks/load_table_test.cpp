// SPDX-License-Identifier: GPL-3.0-or-later
// What loads on the particles of a rock that moves as a rigid body do to its bonds.
#include "core/rocks/load_table.hpp"
#include "core/laws/bond/failure.hpp"
#include "core/rocks/linear_rock.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/small_rocks.hpp"

#include "core/math/random.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyro;
using namespace gyro::small_rocks;

namespace {

/// A load on one particle.
struct PointLoad {
  Index particle;
  Vec3d force, moment;
};

Vec3d random_direction(std::uint64_t seed, std::uint64_t k) {
  const auto draw = [&](std::uint32_t n) { return uniform(seed, Stream::size, k, n) - 0.5; };
  const Vec3d v{draw(0), draw(1), draw(2)};
  return (1 / norm(v)) * v;
}

/// Largest stress ratio of each bond under these loads: pseudo-inverse of the whole matrix, stresses by the bond law at
/// displaced particles.
std::vector<double> stress_ratios(const RockTemplate& rock, const BondParameters& bonds,
                                  const std::vector<PointLoad>& loads) {
  const LinearRock linear = linearise(rock, bonds, {});
  const Eigen::VectorXd root = linear.inverse_root_mass.cwiseInverse();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(root.size());
  for (const PointLoad& l : loads) {
    const Eigen::Index row = 6 * Eigen::Index{l.particle};
    load.segment<3>(row) += Eigen::Vector3d(l.force.x, l.force.y, l.force.z);
    load.segment<3>(row + 3) += Eigen::Vector3d(l.moment.x, l.moment.y, l.moment.z);
  }
  // In unit masses, inertia relief is the projection onto the modes that deform the rock.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(linear.stiffness.toDense());
  const Eigen::VectorXd share = modes.eigenvectors().transpose() * root.cwiseInverse().cwiseProduct(load);
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(root.size());
  for (Eigen::Index k = 6; k < root.size(); ++k) amplitude[k] = share[k] / modes.eigenvalues()[k];
  const Eigen::VectorXd moved = root.cwiseInverse().cwiseProduct(modes.eigenvectors() * amplitude);

  const BondConstants<double> law{bonds, 0, 0};
  std::vector<double> ratios;
  for (const TemplateBond& b : rock.bonds) {
    const auto at = [&](Index p, int k) { return Vec3d{moved[6 * p + k], moved[6 * p + k + 1], moved[6 * p + k + 2]}; };
    const auto turned = [&](Index p) {
      const Vec3d v = at(p, 3);
      return normalised(Quatd{1, 0.5 * v.x, 0.5 * v.y, 0.5 * v.z});
    };
    const Vec3d span = rock.centres[static_cast<std::size_t>(b.j)] - rock.centres[static_cast<std::size_t>(b.i)];
    const double arm =
        (b.length + rock.radii[static_cast<std::size_t>(b.i)] - rock.radii[static_cast<std::size_t>(b.j)]) /
        (2 * b.length);
    const BondStrain<double> strain = bond_strain<double>({(1 / norm(span)) * span, b.length, arm},
                                                          {span + at(b.j, 0) - at(b.i, 0), turned(b.i), turned(b.j)});
    BondSection<double> section{};
    section.radius = b.radius, section.length = b.length, section.arm = arm;
    const auto found = ConstantStrength::ratios(law, 1.0, bond_stress(law, section, strain));
    ratios.push_back(std::max(found.tension, found.shear));
  }
  return ratios;
}

double bound_of(const LoadTable& table, const std::vector<PointLoad>& loads, Index bond) {
  double sum = 0;
  for (const PointLoad& l : loads) {
    const LoadRow<const float> row = table.row(l.particle);
    sum += norm(l.force) * static_cast<double>(row.force()[bond]) +
           norm(l.moment) * static_cast<double>(row.moment()[bond]);
  }
  return sum;
}

}  // namespace

TEST_CASE("The load table of a pair is that of beam theory with inertia relief") {
  const double radius = 0.01, bond = 0.004;
  const RockTemplate rock = pair(radius, bond);
  const BondParameters p = bonds_with(0);
  const LoadTable table = load_table(rock, p);
  REQUIRE(table.particles == 2);
  REQUIRE(table.bonds == 1);
  const double area = std::numbers::pi * bond * bond;
  // Along the axis the bond accelerates the other half: F/2. Across it the shear force is F/7 and the couple zero.
  const double tension = 0.5 / area / p.tensile_strength, shear = 1.0 / 7 / area / p.shear_strength;
  // A couple across the axis gives the bond half of it, and the shear force M/(2.8 R); one along the axis half of it.
  const double bending = 0.5 * 4 / (area * bond) / p.tensile_strength;
  const double sheared = (1 / (2.8 * radius) / area + 0.5 * 2 / (area * bond)) / p.shear_strength;
  for (const Index particle : {0, 1}) {
    const LoadRow<const float> row = table.row(particle);
    CHECK(static_cast<double>(*row.force()) == Approx(std::max(tension, shear)).epsilon(1e-5));
    CHECK(static_cast<double>(*row.moment()) == Approx(std::max(bending, sheared)).epsilon(1e-5));
  }
}

TEST_CASE("The load table bounds the stresses of any loads, and no load alone by much") {
  const RockTemplate rock = cluster(4, 0.02, {0.05, RelativeBondRadius{0.5}});
  const BondParameters p = bonds_with(0.05);
  const LoadTable table = load_table(rock, p);
  const auto count = static_cast<std::uint64_t>(rock.centres.size());
  REQUIRE(table.bonds == static_cast<Index>(rock.bonds.size()));
  double closest = 0;  // largest ratio over its bound
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    std::vector<PointLoad> loads;
    for (std::uint64_t k = 0; k < 1 + draw % 4; ++k) {
      const auto particle = static_cast<Index>(uniform(7, Stream::size, draw, 10 * static_cast<std::uint32_t>(k)) *
                                               static_cast<double>(count));
      loads.push_back({particle, 20.0 * random_direction(1, 10 * draw + k), 0.02 * random_direction(2, 10 * draw + k)});
    }
    const std::vector<double> ratios = stress_ratios(rock, p, loads);
    for (Index b = 0; b < table.bonds; ++b) {
      const double bound = bound_of(table, loads, b), ratio = ratios[static_cast<std::size_t>(b)];
      CHECK(ratio <= bound * (1 + 1e-4));
      if (loads.size() == 1) closest = std::max(closest, ratio / bound);
    }
  }
  CHECK(closest > 0.7);
}

namespace {

/// Stress ratio of a bond by the responses of the table.
double ratio_of(const LoadTable& table, const std::vector<PointLoad>& loads, Index bond) {
  double s[bond_stresses] = {};
  for (const PointLoad& l : loads) {
    const double load[] = {l.force.x, l.force.y, l.force.z, l.moment.x, l.moment.y, l.moment.z};
    for (int c = 0; c < point_loads; ++c)
      for (int r = 0; r < bond_stresses; ++r)
        s[r] += load[c] * static_cast<double>(table.row(l.particle).response(c, r)[bond]);
  }
  return std::max(s[0] + std::hypot(s[3], s[4]), std::hypot(s[1], s[2]) + std::abs(s[5]));
}

}  // namespace

TEST_CASE("The responses of the load table are the stresses of a static solution with inertia relief") {
  const RockTemplate rock = cluster(4, 0.02, {0.05, RelativeBondRadius{0.5}}, 2);
  const BondParameters p = bonds_with(0.05);
  const LoadTable table = load_table(rock, p);
  for (const std::uint64_t draw : {1, 2, 3}) {
    std::vector<PointLoad> loads;
    for (Index k = 0; k < 5; ++k)
      loads.push_back({static_cast<Index>(6 * k + static_cast<Index>(draw)),
                       20.0 * random_direction(3, 10 * draw + static_cast<std::uint64_t>(k)),
                       0.02 * random_direction(4, 10 * draw + static_cast<std::uint64_t>(k))});
    const std::vector<double> ratios = stress_ratios(rock, p, loads);
    const double largest = *std::max_element(ratios.begin(), ratios.end());
    for (Index b = 0; b < table.bonds; ++b)
      CHECK(ratio_of(table, loads, b) == Approx(ratios[static_cast<std::size_t>(b)]).margin(1e-4 * largest));
  }
}

TEST_CASE("The bound of a pressed rock is some times its largest stress") {
  const RockTemplate rock = cluster(5, 0.02, {0.05, RelativeBondRadius{0.5}}, 1);
  const BondParameters p = bonds_with(0.05);
  const LoadTable table = load_table(rock, p);
  Index top = 0, bottom = 0;
  for (Index k = 0; k < table.particles; ++k) {
    const auto z = [&](Index n) { return rock.centres[static_cast<std::size_t>(n)].z; };
    if (z(k) > z(top)) top = k;
    if (z(k) < z(bottom)) bottom = k;
  }
  const std::vector<PointLoad> loads{{top, {0, 0, -100}, {0, 0, 0}}, {bottom, {0, 0, 100}, {0, 0, 0}}};
  const std::vector<double> ratios = stress_ratios(rock, p, loads);
  double bound = 0;
  for (Index b = 0; b < table.bonds; ++b) bound = std::max(bound, bound_of(table, loads, b));
  const double largest = *std::max_element(ratios.begin(), ratios.end());
  CAPTURE(bound, largest);
  CHECK(bound < 10 * largest);
  CHECK(bound >= largest);
}

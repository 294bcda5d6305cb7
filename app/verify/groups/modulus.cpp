// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic modulus of a bonded packing: a slow test between platens against a static solution and Voigt's bound.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/math/regression.hpp"
#include "core/rocks/bonds.hpp"
#include "core/rocks/linear_rock.hpp"
#include "core/rocks/packing.hpp"

#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

using namespace fixtures;

constexpr double radius = grain / 2;

/// A prism that is cut from the same packing as rocks. The platens hold two layers at each end.
struct Specimen {
  RockTemplate rock;
  std::vector<int> grip;  ///< for each sphere: -1 held by the lower platen, +1 by the upper one, 0 free
  double height;          ///< between the outermost centres [m]

  explicit Specimen(double width);
};

Specimen::Specimen(double width) {
  const Packing& packing = rock_packing();
  height = packing.side * radius;
  std::vector<Vec3d> centres;
  for (const Vec3d& c : packing.centres)
    if (c.x < width && c.y < width) centres.push_back(radius * c);
  const BondRule rule{0.05, AbsoluteBondRadius{grain_bond}};
  const std::vector<double> radii(centres.size(), radius);
  for (const Index k : largest_piece(make_bonds(centres, radii, rule), static_cast<Index>(centres.size())))
    rock.centres.push_back(centres[static_cast<std::size_t>(k)]);
  rock.radii.assign(rock.centres.size(), radius);
  rock.particle_density = rock_density;
  rock.bonds = make_bonds(rock.centres, rock.radii, rule);
  rock.colour_begin = colour_bonds(rock.bonds, static_cast<Index>(rock.centres.size()));
  for (const Vec3d& c : rock.centres) grip.push_back(c.z < 3 * radius ? -1 : c.z > height - 3 * radius ? 1 : 0);
}

/// Strain along z, from a line fitted to the displacements of the spheres well away from the platens, and the modulus
/// by Voigt's hypothesis for the bonds in this region:
///   E_V = (N L^2/3 V) kn A (2 + 3 kappa)/(4 + kappa)   for N bonds of length L in a volume V, kappa = ks/kn
struct Gauge {
  double low, high;  ///< [m]
  explicit Gauge(const Specimen& s) : low(7 * radius), high(s.height - 7 * radius) {}
  bool holds(double z) const { return z > low && z < high; }

  double strain(const Specimen& s, const std::vector<double>& displacement) const {
    std::vector<double> height, moved;
    for (std::size_t k = 0; k < s.rock.centres.size(); ++k) {
      if (!holds(s.rock.centres[k].z)) continue;
      height.push_back(s.rock.centres[k].z);
      moved.push_back(displacement[k]);
    }
    return regression_slope(height, moved).value();
  }
  /// E_V times the cross-section [N]. The product is used because a rough prism has no well-defined cross-section.
  double voigt_stiffness(const Specimen& s) const {
    const BondStiffness k(paper_bonds());
    const double kappa = k.shear / k.normal;
    double sum = 0;
    for (const TemplateBond& b : s.rock.bonds)
      if (holds(0.5 *
                (s.rock.centres[static_cast<std::size_t>(b.i)].z + s.rock.centres[static_cast<std::size_t>(b.j)].z)))
        sum += b.length * b.length;
    return sum / (3 * (high - low)) * k.normal * (2 + 3 * kappa) / (4 + kappa);
  }
};

/// Force on a platen [N/m] and strain of the gauge [1/m], both per metre of approach of the platens.
struct Response {
  double force = 0, strain = 0;
};

/// Response in the engine: the two groups of held spheres approach at a constant speed. The differences between two
/// times contain neither the start-up nor the constant part of the damping.
Response slow_test(const Specimen& s, Precision precision) {
  constexpr double dt = 2e-6, speed = 1e-4;
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.3;
  NewRock rock;
  rock.id = 0;
  for (std::size_t k = 0; k < s.rock.centres.size(); ++k)
    rock.particles.push_back({static_cast<ParticleId>(k),
                              s.rock.centres[k],
                              {0, 0, -0.5 * speed * s.grip[k]},
                              {0, 0, 0},
                              radius,
                              s.grip[k] != 0 ? immovable : rock_density});
  for (const TemplateBond& b : s.rock.bonds) rock.bonds.push_back({b.i, b.j, b.length, b.radius, 1});
  rock.colour_begin = s.rock.colour_begin;
  Stage stage(bonded_scene(dt, bonds), precision);
  stage.insert({rock});
  const Gauge gauge(s);
  const auto now = [&] {
    const ParticleSnapshot p = stage.dem().particles();
    Response r;
    std::vector<double> moved;
    for (std::size_t k = 0; k < p.size(); ++k) {
      if (s.grip[k] > 0) r.force += p.force[k].z;
      moved.push_back(p.position[k].z - s.rock.centres[k].z);
    }
    r.strain = gauge.strain(s, moved);
    return r;
  };
  stage.advance(2000);
  const Response a = now();
  stage.advance(1000);
  const Response b = now();
  const double closed = speed * 1000 * dt;
  return {(b.force - a.force) / closed, (a.strain - b.strain) / closed};
}

/// Response by the linear equations of the rock: the displacements of the held spheres are given, those of the others
/// are solved for.
Response static_solution(const Specimen& s) {
  const LinearRock linear = linearise(s.rock, paper_bonds(), {});
  const Eigen::Index size = linear.inverse_root_mass.size();
  const Eigen::VectorXd root_mass = linear.inverse_root_mass.cwiseInverse();
  Eigen::VectorXd given = Eigen::VectorXd::Zero(size);
  std::vector<Eigen::Index> row(static_cast<std::size_t>(size), -1);
  Eigen::Index free = 0;
  for (Eigen::Index k = 0; k < size; ++k) {
    const int grip = s.grip[static_cast<std::size_t>(k / 6)];
    if (grip == 0) row[static_cast<std::size_t>(k)] = free++;
    if (grip != 0 && k % 6 == 2) given[k] = -0.5 * grip;
  }
  const Eigen::SparseMatrix<double> stiffness = root_mass.asDiagonal() * linear.stiffness * root_mass.asDiagonal();
  const Eigen::VectorXd load = -(stiffness * given);
  std::vector<Eigen::Triplet<double>> inner;
  Eigen::VectorXd right(free);
  for (Eigen::Index c = 0; c < size; ++c) {
    const Eigen::Index column = row[static_cast<std::size_t>(c)];
    if (column < 0) continue;
    right[column] = load[c];
    for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, c); it; ++it)
      if (row[static_cast<std::size_t>(it.row())] >= 0)
        inner.emplace_back(row[static_cast<std::size_t>(it.row())], column, it.value());
  }
  Eigen::SparseMatrix<double> matrix(free, free);
  matrix.setFromTriplets(inner.begin(), inner.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd solved = solver.solve(right);
  for (Eigen::Index k = 0; k < size; ++k)
    if (row[static_cast<std::size_t>(k)] >= 0) given[k] = solved[row[static_cast<std::size_t>(k)]];
  const Eigen::VectorXd force = stiffness * given;
  Response r;
  std::vector<double> moved;
  for (std::size_t k = 0; k < s.grip.size(); ++k) {
    const auto z = static_cast<Eigen::Index>(6 * k + 2);
    if (s.grip[k] > 0) r.force -= force[z];
    moved.push_back(given[z]);
  }
  r.strain = -Gauge(s).strain(s, moved);
  return r;
}

void platens(Recorder& out) {
  const Specimen specimen(14);
  const Response dynamic = slow_test(specimen, out.precision()), exact = static_solution(specimen);
  out.relative("force", dynamic.force, exact.force, {1e-4, 1e-4}, "sparse static solution of the same packing");
  out.relative("strain", dynamic.strain, exact.strain, {1e-4, 1e-4}, "sparse static solution of the same packing");
  out.within("modulus-to-voigt", dynamic.force / dynamic.strain / Gauge(specimen).voigt_stiffness(specimen), 0.8, 1.0,
             "Voigt bound, Liao et al. (1997)");
}

}  // namespace

std::vector<Verification> modulus_cases() {
  return {{"modulus/platens", platens}};
}

}  // namespace gyro::verify

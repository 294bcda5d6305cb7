// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/load_table.hpp"

#include "core/base/errors.hpp"
#include "core/laws/bond/springs.hpp"
#include "core/rocks/linear_rock.hpp"
#include "core/rocks/rock_springs.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace gyro {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Matrix23 = Eigen::Matrix<double, 2, 3>;
using Loads = Eigen::Matrix<double, Eigen::Dynamic, 6>;  ///< a column for each unit load on one particle
using Stresses = Eigen::Matrix<double, bond_stresses, point_loads>;

Eigen::Vector3d vector(const Vec3d& v) {
  return {v.x, v.y, v.z};
}

Matrix3 cross_matrix(const Vec3d& r) {  // cross_matrix(r) x = r x x
  Matrix3 m;
  m << 0, -r.z, r.y, r.z, 0, -r.x, -r.y, r.x, 0;
  return m;
}

/// Masses of a rock as one rigid body about its centre of mass.
struct RigidMass {
  std::vector<Inertia> particles;
  std::vector<Vec3d> arms;  ///< from the centre of mass
  double mass = 0;
  Matrix3 inverse_inertia;

  explicit RigidMass(const RockTemplate& rock) {
    Vec3d middle{0, 0, 0};
    for (std::size_t k = 0; k < rock.centres.size(); ++k) {
      particles.push_back(inertia_of(rock.radii[k], rock.particle_density));
      mass += particles[k].mass;
      middle += particles[k].mass * rock.centres[k];
    }
    middle = (1 / mass) * middle;
    Matrix3 inertia = Matrix3::Zero();
    for (std::size_t k = 0; k < rock.centres.size(); ++k) {
      arms.push_back(rock.centres[k] - middle);
      const Matrix3 c = cross_matrix(arms[k]);
      inertia += particles[k].moment * Matrix3::Identity() - particles[k].mass * c * c;
    }
    inverse_inertia = inertia.inverse();
  }
};

/// The six unit loads on a particle less the loads that accelerate all particles with the rock.
Loads balanced_loads(const RigidMass& body, std::size_t loaded) {
  const auto count = static_cast<Eigen::Index>(body.arms.size());
  Eigen::Matrix<double, 3, 6> force = Eigen::Matrix<double, 3, 6>::Zero(), torque = force;
  force.leftCols<3>().setIdentity();
  torque.leftCols<3>() = cross_matrix(body.arms[loaded]);
  torque.rightCols<3>().setIdentity();
  const Eigen::Matrix<double, 3, 6> acceleration = force / body.mass, rotation = body.inverse_inertia * torque;
  Loads loads(6 * count, 6);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    loads.middleRows<3>(6 * k) = -body.particles[at].mass * (acceleration - cross_matrix(body.arms[at]) * rotation);
    loads.middleRows<3>(6 * k + 3) = -body.particles[at].moment * rotation;
  }
  const auto first = static_cast<Eigen::Index>(6 * loaded);
  loads.block<6, 6>(first, 0) += Eigen::Matrix<double, 6, 6>::Identity();
  return loads;
}

/// Largest singular value.
double size_of(const Matrix23& m) {
  const Eigen::Matrix2d square = m * m.transpose();
  const double mean = 0.5 * square.trace(), half = 0.5 * (square(0, 0) - square(1, 1));
  return std::sqrt(std::max(0.0, mean + std::hypot(half, square(0, 1))));
}

/// The rock with its first particle held: loads in balance leave it where it is.
class HeldRock {
 public:
  HeldRock(const RockTemplate& rock, const BondParameters& bonds) {
    const LinearRock linear = linearise(rock, bonds, {});
    const Eigen::Index size = linear.stiffness.rows();
    scale_ = linear.inverse_root_mass;
    factor_.compute(linear.stiffness.bottomRightCorner(size - 6, size - 6));
    if (factor_.info() != Eigen::Success)
      throw BadInput(rock.name + ": its bonds do not hold it together; see rocks.fill and bonds.gap");
  }
  /// Displacements and rotations of all particles.
  Loads displacements(const Loads& loads) const {
    const Eigen::Index free = loads.rows() - 6;
    const auto scale = scale_.tail(free).asDiagonal();
    const Eigen::Matrix<double, Eigen::Dynamic, 6> right = scale * loads.bottomRows(free);
    Loads found = Loads::Zero(loads.rows(), 6);
    found.bottomRows(free) = scale * factor_.solve(right);
    return found;
  }

 private:
  Eigen::VectorXd scale_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

/// What turns displacements of the ends into stress ratios of one bond.
class BondResponse {
 public:
  BondResponse(const RockTemplate& rock, const TemplateBond& bond, const BondParameters& p)
      : bond_(bond), frame_(bond_frame(rock, bond)) {
    const Vec3d n = frame_.n, helper = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d across = cross(n, helper), t = (1 / norm(across)) * across;
    sides_.row(0) = vector(t).transpose();
    sides_.row(1) = vector(cross(n, t)).transpose();
    const double kn = stiffness_per_area(p.normal_stiffness, p.normal_modulus, bond.length);
    const double ks = stiffness_per_area(p.shear_stiffness, p.shear_modulus, bond.length);
    normal_ = kn / p.tensile_strength, bending_ = kn * bond.radius / p.tensile_strength;
    shear_ = ks / p.shear_strength, torsion_ = ks * bond.radius / p.shear_strength;
  }

  /// @param u  displacements under the six unit loads
  /// @return a column of stresses for each load
  Stresses stresses(const Loads& u) const {
    using Part = Eigen::Matrix<double, 3, 6>;
    const auto at = [&](Index particle) -> Part { return u.middleRows<3>(6 * Eigen::Index{particle}); };
    const auto turn = [&](Index particle) -> Part { return u.middleRows<3>(6 * Eigen::Index{particle} + 3); };
    const Part rotation = frame_.arm_i * turn(bond_.i) + frame_.arm_j * turn(bond_.j);
    const Part stretch = at(bond_.j) - at(bond_.i) + cross_matrix(frame_.n) * rotation;
    const Part turned = turn(bond_.j) - turn(bond_.i);
    Stresses s;
    s.row(0) = normal_ * vector(frame_.n).transpose() * stretch;
    s.middleRows<2>(1) = shear_ * sides_ * stretch;
    s.middleRows<2>(3) = bending_ * sides_ * turned;
    s.row(5) = torsion_ * vector(frame_.n).transpose() * turned;
    return s;
  }

 private:
  TemplateBond bond_;
  BondFrame frame_;
  Matrix23 sides_;
  double normal_, bending_, shear_, torsion_;  ///< stress ratio of a displacement or rotation of 1
};

/// Largest ratio for loads of size 1 in any direction. @param s  stresses under three unit loads
double largest_ratio(const Eigen::Matrix<double, 6, 3>& s) {
  const double tension = s.row(0).norm() + size_of(s.middleRows<2>(3));
  const double shear = size_of(s.middleRows<2>(1)) + s.row(5).norm();
  return std::max(tension, shear);
}

/// Everything that the rows of a table need.
class RockResponse final : public LoadResponse {
 public:
  RockResponse(const RockTemplate& rock, const BondParameters& bonds) : held_(rock, bonds), body_(rock) {
    responses_.reserve(rock.bonds.size());
    for (const TemplateBond& bond : rock.bonds) responses_.emplace_back(rock, bond, bonds);
  }

  void fill(Index particle, const LoadRow<float>& to) const override {
    const Loads u = held_.displacements(balanced_loads(body_, static_cast<std::size_t>(particle)));
    for (std::size_t b = 0; b < responses_.size(); ++b) {
      const Stresses s = responses_[b].stresses(u);
      to.force()[b] = static_cast<float>(largest_ratio(s.leftCols<3>()));
      to.moment()[b] = static_cast<float>(largest_ratio(s.rightCols<3>()));
      for (int load = 0; load < point_loads; ++load)
        for (int stress = 0; stress < bond_stresses; ++stress)
          to.response(load, stress)[b] = static_cast<float>(s(stress, load));
    }
  }

 private:
  HeldRock held_;
  RigidMass body_;
  std::vector<BondResponse> responses_;
};

}  // namespace

LoadTable load_table(const RockTemplate& rock, const BondParameters& bonds) {
  LoadTable table(static_cast<Index>(rock.centres.size()), static_cast<Index>(rock.bonds.size()));
  const RockResponse response(rock, bonds);
  for (Index particle = 0; particle < table.particles; ++particle) response.fill(particle, table.row(particle));
  return table;
}

std::unique_ptr<LoadResponse> load_response(const RockTemplate& rock, const BondParameters& bonds) {
  return std::make_unique<RockResponse>(rock, bonds);
}

RockTemplate shape_of(const NewRock& rock) {
  RockTemplate made;
  made.name = "rock " + std::to_string(rock.id);
  for (const NewParticle& p : rock.particles) {
    made.centres.push_back(p.position);
    made.radii.push_back(p.radius);
    made.particle_density = p.density;
  }
  for (const NewBond& b : rock.bonds) made.bonds.push_back({b.i, b.j, b.length, b.radius});
  return made;
}

}  // namespace gyro

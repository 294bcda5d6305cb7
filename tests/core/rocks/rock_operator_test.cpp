// SPDX-License-Identifier: GPL-3.0-or-later
// A rock as an operator, and its largest mode, against assembled matrices and a dense solver.
#include "core/rocks/rock_operator.hpp"
#include "core/math/random.hpp"
#include "core/rocks/largest_mode.hpp"
#include "core/rocks/linear_rock.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/small_rocks.hpp"

#include <Eigen/Eigenvalues>

using namespace gyro;
using namespace gyro::small_rocks;

namespace {

Eigen::VectorXd random_vector(Eigen::Index size, std::uint64_t seed) {
  Eigen::VectorXd v(size);
  for (Eigen::Index k = 0; k < size; ++k) v[k] = uniform(seed, Stream::place, static_cast<std::uint64_t>(k), 0) - 0.5;
  return v;
}

/// Some forty particles of different sizes.
RockTemplate graded_cluster() {
  RockTemplate rock = cluster(4, 0.02, {0.05, RelativeBondRadius{0.4}});
  for (std::size_t p = 0; p < rock.radii.size(); ++p) rock.radii[p] *= 1 - 0.3 * uniform(3, Stream::size, p, 0);
  return rock;
}

Mode largest_of(const Eigen::MatrixXd& matrix, double tolerance) {
  const auto apply = [&](const Eigen::VectorXd& x, Eigen::VectorXd& image) { image = matrix * x; };
  return largest_mode(apply, random_vector(matrix.rows(), 5), tolerance);
}

}  // namespace

TEST_CASE("A rock applied bond by bond is its assembled matrix") {
  const RockTemplate rock = graded_cluster();
  REQUIRE(rock.centres.size() > 30);
  REQUIRE(rock.bonds.size() > 60);
  const BondParameters bonds = bonds_with(0.2);
  const BedContacts bed = GENERATE(BedContacts{}, BedContacts{6, 5e8, 4e8, 0.3, 0.2});
  const LinearRock linear = linearise(rock, bonds, bed);
  RockOperator rock_operator(rock, bonds, bed);
  const double dt = 3e-6;
  rock_operator.set_step(dt);
  const Eigen::MatrixXd matrix = dt * dt * linear.stiffness.toDense() + 2 * dt * linear.damping.toDense();
  REQUIRE(rock_operator.size() == matrix.rows());
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Eigen::VectorXd x = random_vector(matrix.rows(), seed);
    Eigen::VectorXd image(matrix.rows());
    rock_operator.apply(x, image);
    CHECK((image - matrix * x).norm() < 1e-14 * matrix.norm() * x.norm());
    const Eigen::VectorXd unit = x.normalized();
    const double step = rock_operator.step_of_mode(unit);
    const double a = unit.dot(linear.stiffness * unit), b = unit.dot(linear.damping * unit);
    CHECK(step * step * a + 2 * step * b == Approx(4).epsilon(1e-12));
  }
}

TEST_CASE("Row sums are those of the assembled matrices") {
  const RockTemplate rock = graded_cluster();
  const BondParameters bonds = bonds_with(0.2);
  const BedContacts bed{6, 5e8, 4e8, 0.3, 0.2};
  const LinearRock linear = linearise(rock, bonds, bed);
  const double dt = gershgorin_step(rock, bonds, bed);
  const Eigen::MatrixXd sums = dt * dt * linear.stiffness.toDense().cwiseAbs().rowwise().sum() +
                               2 * dt * linear.damping.toDense().cwiseAbs().rowwise().sum();
  CHECK(sums.maxCoeff() == Approx(4).epsilon(1e-12));
}

TEST_CASE("The critical step is that of a dense solver") {
  const auto factor = GENERATE(0.1, 0.5, 1.0);
  const double damping = GENERATE(0.0, 0.05, 0.5);
  for (int number = 0; number < 4; ++number) {
    const RockTemplate rock = cluster(4, 0.02, {0.05, RelativeBondRadius{factor}}, number);
    const BedContacts bed = number % 2 == 0 ? no_bed : BedContacts{6, 5e8, 4e8, 0.3, 0.3};
    const double dt = critical_step(rock, bonds_with(damping), bed);
    const LinearRock linear = linearise(rock, bonds_with(damping), bed);
    const Eigen::MatrixXd map = dt * dt * linear.stiffness.toDense() + 2 * dt * linear.damping.toDense();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(map, Eigen::EigenvaluesOnly);
    CHECK(solver.eigenvalues().maxCoeff() == Approx(4).epsilon(1e-5));
  }
}

TEST_CASE("The largest mode is that of a dense solver, also of few, equal and no eigenvalues") {
  const Eigen::MatrixXd root = [] {
    Eigen::MatrixXd m(60, 60);
    for (Eigen::Index k = 0; k < 60; ++k) m.col(k) = random_vector(60, 10 + static_cast<std::uint64_t>(k));
    return m;
  }();
  const Eigen::MatrixXd matrix = root * root.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const double largest = solver.eigenvalues()[59];
  const Mode mode = largest_of(matrix, 1e-6);
  CHECK(mode.value == Approx(largest).epsilon(1e-10));
  CHECK(mode.vector.norm() == Approx(1).epsilon(1e-12));
  CHECK((matrix * mode.vector - mode.value * mode.vector).norm() < 1.01e-6 * largest);
  CHECK(largest_of(Eigen::MatrixXd::Constant(1, 1, 7), 1e-6).value == Approx(7));
  CHECK(largest_of(Eigen::Vector2d(2, 3).asDiagonal(), 1e-6).value == Approx(3).epsilon(1e-10));
  CHECK(largest_of(Eigen::Matrix3d(Eigen::Vector3d(5, 5, 5).asDiagonal()), 1e-6).value == Approx(5));
  CHECK(largest_of(Eigen::MatrixXd::Zero(4, 4), 1e-6).value == 0);
}

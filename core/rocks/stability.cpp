// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/stability.hpp"

#include "core/math/random.hpp"
#include "core/rocks/linear_rock.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

/// A unit vector and its Rayleigh quotient.
struct Mode {
  double value;
  Eigen::VectorXd vector;
};

/// Lanczos basis with its tridiagonal matrix.
struct Lanczos {
  Eigen::MatrixXd basis;
  Eigen::VectorXd diagonal, beside;
  int size = 0;

  Lanczos(Eigen::Index n, int maximum) : basis(n, maximum), diagonal(maximum), beside(maximum) {}

  /// Extends the basis by one vector. @return the part of its image that is orthogonal to the basis
  template <class Operator>
  Eigen::VectorXd extend(const Operator& apply, const Eigen::VectorXd& next) {
    basis.col(size) = next;
    Eigen::VectorXd rest = apply(next);
    diagonal[size] = next.dot(rest);
    ++size;
    for (int pass = 0; pass < 2; ++pass) {  // two passes are enough for full orthogonality
      rest -= basis.leftCols(size) * (basis.leftCols(size).transpose() * rest).eval();
    }
    beside[size - 1] = rest.norm();
    return rest;
  }
};

/// Largest eigenvalue of a symmetric operator, to the relative tolerance, by restarted Lanczos iteration.
template <class Operator>
Mode largest_mode(const Operator& apply, Eigen::VectorXd start, double tolerance) {
  const Eigen::Index n = start.size();
  const int maximum = static_cast<int>(std::min<Eigen::Index>(n, 80));
  constexpr int check_every = 8, restarts = 50;
  Mode mode{0, start.normalized()};
  for (int restart = 0; restart < restarts; ++restart) {
    Lanczos lanczos(n, maximum);
    Eigen::VectorXd next = mode.vector;
    for (bool full = false; !full;) {
      const Eigen::VectorXd rest = lanczos.extend(apply, next);
      const double beta = lanczos.beside[lanczos.size - 1];
      const bool closed = !(beta > 1e-13 * std::abs(lanczos.diagonal[0]));  // an invariant subspace
      full = lanczos.size == maximum || closed;
      if (full || lanczos.size % check_every == 0) {
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
        small.computeFromTridiagonal(lanczos.diagonal.head(lanczos.size), lanczos.beside.head(lanczos.size - 1));
        const Eigen::VectorXd top = small.eigenvectors().col(lanczos.size - 1);
        mode = {small.eigenvalues()[lanczos.size - 1], (lanczos.basis.leftCols(lanczos.size) * top).normalized()};
        const double residual = beta * std::abs(top[lanczos.size - 1]);
        if (closed || residual <= tolerance * mode.value) return mode;
      }
      if (!full) next = rest / beta;
    }
  }
  return mode;
}

/// Smallest dt > 0 with dt^2 a + 2 dt b = 4.
double step_of(double a, double b) {
  const double sum = b + std::sqrt(b * b + 4 * a);
  return sum > 0 ? 4 / sum : std::numeric_limits<double>::infinity();
}

/// The smallest step at which 4 - 2 dt B - dt^2 A is singular. Each round finds the most unstable mode at the present
/// step, then the step that this mode allows. Converges monotonically from above, quadratically near the end.
double critical_step_of(const LinearRock& rock, double guess) {
  constexpr double tolerance = 1e-4, settled = 2e-5;
  constexpr int rounds = 30;
  Eigen::VectorXd vector(rock.stiffness.rows());
  for (Eigen::Index k = 0; k < vector.size(); ++k) {
    vector[k] = uniform(1, Stream::shape, static_cast<std::uint64_t>(k), 0) - 0.5;
  }
  double dt = guess;
  for (int round = 0; round < rounds && std::isfinite(dt); ++round) {
    const auto apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
      return (dt * dt) * (rock.stiffness * v) + (2 * dt) * (rock.damping * v);
    };
    vector = largest_mode(apply, vector, tolerance).vector;
    const double next = step_of(vector.dot(rock.stiffness * vector), vector.dot(rock.damping * vector));
    const bool done = std::abs(next / dt - 1) < settled;
    dt = next;
    if (done) break;
  }
  return dt;
}

double gershgorin_of(const LinearRock& rock) {
  double dt = std::numeric_limits<double>::infinity();
  Eigen::VectorXd a = Eigen::VectorXd::Zero(rock.stiffness.rows()), b = a;
  for (Eigen::Index column = 0; column < rock.stiffness.outerSize(); ++column) {  // symmetric: columns are rows
    for (Eigen::SparseMatrix<double>::InnerIterator it(rock.stiffness, column); it; ++it)
      a[column] += std::abs(it.value());
    for (Eigen::SparseMatrix<double>::InnerIterator it(rock.damping, column); it; ++it)
      b[column] += std::abs(it.value());
    dt = std::min(dt, step_of(a[column], b[column]));
  }
  return dt;
}

}  // namespace

double critical_step(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed) {
  const LinearRock linear = linearise(rock, bonds, bed);
  return critical_step_of(linear, gershgorin_of(linear));
}

double gershgorin_step(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed) {
  return gershgorin_of(linearise(rock, bonds, bed));
}

double loose_critical_step(double radius, double density, const BedContacts& bed) {
  RockTemplate single;
  single.centres = {{0, 0, 0}};
  single.radii = {radius};
  single.particle_density = density;
  return gershgorin_step(single, BondParameters{}, bed);  // exact: the matrices are diagonal
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace gyro {

/// A unit vector and its Rayleigh quotient.
struct Mode {
  double value = 0;
  Eigen::VectorXd vector;
};

/// result = A x with a symmetric A that has no negative eigenvalue. The result has its size already.
using SymmetricOperator = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& result)>;

/// Largest eigenvalue of an operator, to the relative tolerance |A x - value x| <= tolerance value, by the locally
/// optimal conjugate gradient iteration (Knyazev, SIAM J. Sci. Comput. 23 (2001) 517, with one vector): the next x is
/// the best in the space of x, its residual and its last change. It needs about as many images as Lanczos iteration,
/// but only five vectors, the start among them.
Mode largest_mode(const SymmetricOperator& apply, Eigen::VectorXd start, double tolerance);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/largest_mode.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace gyro {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The iterate x, its residual w = A x - value x, the last change p of x, and the images of p and w.
struct Iteration {
  double value = 0;
  Eigen::VectorXd x, w, p, image_p, image_w;
  Matrix3d products;  ///< of x, w, p with each other

  void begin(const SymmetricOperator& apply, Eigen::VectorXd start);
  Matrix3d images() const;
  void combine(const Vector3d& factor, double next_value);
};

void Iteration::begin(const SymmetricOperator& apply, Eigen::VectorXd start) {
  x = std::move(start);
  x.normalize();
  w.resize(x.size());
  apply(x, w);
  value = x.dot(w);
  w -= value * x;
  p = image_p = image_w = Eigen::VectorXd::Zero(x.size());
  products.setZero();
  products(0, 0) = x.squaredNorm();
  products(0, 1) = products(1, 0) = x.dot(w);
  products(1, 1) = w.squaredNorm();
}

/// Products of x, w, p with their images; the image of x is w + value x.
Matrix3d Iteration::images() const {
  double ww = 0, wp = 0, pp = 0;
  for (Index k = 0; k < x.size(); ++k) {
    ww += w[k] * image_w[k];
    wp += p[k] * image_w[k];
    pp += p[k] * image_p[k];
  }
  const Vector3d first = products.col(1) + value * products.col(0);
  Matrix3d m;
  m << first[0], first[1], first[2], first[1], ww, wp, first[2], wp, pp;
  return m;
}

/// x = f_x x + f_w w + f_p p and all that belongs to it, in one pass.
void Iteration::combine(const Vector3d& factor, double next_value) {
  const double fx = factor[0], fw = factor[1], fp = factor[2];
  double xx = 0, xw = 0, xp = 0, ww = 0, wp = 0, pp = 0;
  for (Index k = 0; k < x.size(); ++k) {
    const double image_x = w[k] + value * x[k];
    const double change = fw * w[k] + fp * p[k], image_change = fw * image_w[k] + fp * image_p[k];
    const double next = fx * x[k] + change, rest = fx * image_x + image_change - next_value * next;
    p[k] = change;
    image_p[k] = image_change;
    x[k] = next;
    w[k] = rest;
    xx += next * next;
    xw += next * rest;
    xp += next * change;
    ww += rest * rest;
    wp += rest * change;
    pp += change * change;
  }
  value = next_value;
  products << xx, xw, xp, xw, ww, wp, xp, wp, pp;
}

struct Best {
  double value;
  Vector3d factor;
};

/// The vector of norm 1 with the largest Rayleigh quotient in a space of three vectors, which may depend on each other.
Best best_in(const Matrix3d& products, const Matrix3d& images) {
  const Vector3d scale = products.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0; });
  const Eigen::SelfAdjointEigenSolver<Matrix3d> space(scale.asDiagonal() * products * scale.asDiagonal());
  constexpr double independent = 1e-10;
  Matrix3d basis = Matrix3d::Zero();  // orthonormal; columns of vectors that depend on the others stay zero
  for (int k = 0; k < 3; ++k) {
    const double size = space.eigenvalues()[k];
    if (size > independent) basis.col(k) = scale.cwiseProduct(space.eigenvectors().col(k)) / std::sqrt(size);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> small(basis.transpose() * images * basis);
  return {small.eigenvalues()[2], basis * small.eigenvectors().col(2)};
}

}  // namespace

Mode largest_mode(const SymmetricOperator& apply, Eigen::VectorXd start, double tolerance) {
  constexpr int iterations = 4000;
  Iteration iteration;
  iteration.begin(apply, std::move(start));
  for (int k = 0; k < iterations; ++k) {
    if (!(std::sqrt(iteration.products(1, 1)) > tolerance * iteration.value)) break;
    apply(iteration.w, iteration.image_w);
    const Best best = best_in(iteration.products, iteration.images());
    iteration.combine(best.factor, best.value);
  }
  return {iteration.value, std::move(iteration.x)};
}

}  // namespace gyro

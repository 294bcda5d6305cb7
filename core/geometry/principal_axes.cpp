// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/principal_axes.hpp"

#include <Eigen/Eigenvalues>

namespace gyro {

PrincipalAxes principal_axes(const std::array<double, 6>& t) {
  Eigen::Matrix3d m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  const auto axis = [&](int k) {
    const Eigen::Vector3d v = solver.eigenvectors().col(k);
    return Vec3d{v[0], v[1], v[2]};
  };
  const Eigen::Vector3d l = solver.eigenvalues();
  return {{l[0], l[1], l[2]}, {axis(0), axis(1), cross(axis(0), axis(1))}};
}

}  // namespace gyro

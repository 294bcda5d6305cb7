// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

#include <array>

namespace gyro {

/// Principal values and axes of a symmetric tensor, ascending.
struct PrincipalAxes {
  Vec3d moments;              ///< in the tensor's unit
  std::array<Vec3d, 3> axes;  ///< unit, right-handed; axes[0] belongs to the smallest value
};

/// @param tensor  xx, yy, zz, xy, yz, zx
/// Equal tensors give equal axes, also where they are not unique (equal values; an axis and its opposite).
PrincipalAxes principal_axes(const std::array<double, 6>& tensor);

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

namespace gyro {

/// k_n or k_s of a bond [Pa/m]: a stiffness per area, plus a modulus divided by the bond's length. Cases give one of
/// the two.
template <class T>
GYRO_HD T stiffness_per_area(T stiffness, T modulus, T length) {
  return stiffness + modulus / length;
}

/// The four springs of a bond: for its stretch and its shear [N/m], for its twist and its bending [N m].
template <class T>
struct BondSprings {
  T normal, shear, twist, bending;
};

/// Springs of a bond of circular section (Potyondy & Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329):
///
///   k_n A, k_s A, k_s J, k_n I        A = pi Rb^2, I = pi Rb^4/4, J = pi Rb^4/2
///
/// @param normal, shear  k_n and k_s [Pa/m]
/// @param radius         Rb [m]
template <class T>
GYRO_HD BondSprings<T> bond_springs(T normal, T shear, T radius) {
  const T square = radius * radius, area = T(3.14159265358979323846) * square;
  return {normal * area, shear * area, T(0.5) * shear * area * square, T(0.25) * normal * area * square};
}

}  // namespace gyro

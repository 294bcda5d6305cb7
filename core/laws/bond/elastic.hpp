// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/bond.hpp"
#include "core/laws/bond/springs.hpp"
#include "core/laws/bond/strain.hpp"

namespace gyro {

/// Energy of an intact bond [J]:
///
///   U = 1/2 kn A (L - L0)^2 + 1/2 ks A L0^2 |gamma|^2 + 1/2 ks J theta_n^2 + 1/2 kn I |theta_s|^2
///
/// @param length0  L0 [m]
template <class T>
GYRO_HD T elastic_energy(const BondSprings<T>& k, T length0, const BondStrain<T>& s) {
  return T(0.5) * (k.normal * s.stretch * s.stretch + k.shear * length0 * length0 * norm2(s.shear) +
                   k.twist * s.twist * s.twist + k.bending * norm2(s.bend));
}

/// Elastic loads of an intact bond on j; i receives the opposite. World frame.
template <class T>
struct ElasticLoads {
  Vec3<T> force;   ///< acts at the section [N]
  Vec3<T> couple;  ///< [N m]
};

/// Minus the gradient of U, at strains of any size. To the first power of the strains
///
///   F_j = -kn A (L - L0) n + ks A L0^2 (c/L) gamma          M_j = -ks J theta_n n - kn I theta_s
///
/// Small rotations f_i, f_j of the ends change
///
///   theta by w (f_j - f_i) + 1/2 (f_i + f_j) x theta           w = sqrt(1 - |theta|^2/4)
///   e_w   by (f + kappa/2 (f_j - f_i) x theta) x e_w           kappa = a_i a_j / N, N = 1 - 2 a_i a_j (1 - w)
///
/// where f = (a_i f_i + a_j f_j) + 2 kappa (1 - w) (1/2 - a_i) (f_j - f_i). The higher powers keep the energy: without
/// them a crushed rock of soft bonds lost 2e-4 of its work, at any time step.
///
/// @param length0  L0 [m]
/// @param arm      a_i [-]
template <class T>
GYRO_HD ElasticLoads<T> elastic_loads(const BondSprings<T>& k, T length0, T arm, const BondStrain<T>& s) {
  using std::sqrt;
  const T ratio = length0 / s.length;
  const Vec3<T> shear = (k.shear * length0 * ratio * s.along) * s.shear;
  const Vec3<T> tilt = ((k.bending - k.twist) * s.twist / s.length) * s.bend;  // n rotates in a twisted and bent bond

  const Vec3<T> theta = s.bend + s.twist * s.normal;
  const T w = sqrt(positive(T(1) - T(0.25) * norm2(theta))), missing = T(1) - w;
  const T both = arm * (T(1) - arm), kappa = both / (T(1) - (both + both) * missing);
  const Vec3<T> span = s.length * s.normal, lever = cross(span, shear);
  const Vec3<T> uneven = cross(span, tilt) - ((kappa + kappa) * missing) * lever;
  return {shear + tilt - (k.normal * s.stretch) * s.normal,
          (T(0.5) - arm) * uneven - (T(0.5) * kappa) * cross(theta, lever) - (w * k.twist * s.twist) * s.normal -
              (w * k.bending) * s.bend};
}

}  // namespace gyro

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact.hpp"

namespace gyro {

/// Result of the tangential law.
template <class T>
struct FrictionLoad {
  Vec3<T> force;    ///< on i [N]
  Vec3<T> elastic;  ///< its elastic part [N]
  T slipped;        ///< work lost to sliding in this step [J]
};

/// Mindlin's tangential spring with a dashpot, cut to Coulomb's limit.
///
///   Ft = Ft0 - St vt dt - ct vt, |Ft| <= mu Fn
///
/// Ft0 is the elastic tangential force of the last step, laid into the present tangent plane at equal size and, while
/// unloading, scaled by St/St_old: otherwise a loop load-shear-unload would create energy (Thornton & Randall 1988;
/// `rescale` variants of later codes). While sliding there is no tangential damping: the sum is cut to mu Fn.
///
/// Work is force times displacement with the mean of the forces at both ends of the step, as velocity Verlet spends
/// them. What goes into the spring less what it stores is lost to sliding.
template <class T>
GYRO_HD FrictionLoad<T> friction_load(const ContactConstants<T>& law, const Vec3<T>& normal, const Vec3<T>& slide,
                                      const NormalLoad<T>& n, const ContactHistory<T>& history) {
  const T limit = law.friction * n.push, last_size2 = norm2(history.elastic);
  const Vec3<T> laid = laid_into_plane(history.elastic, last_size2, normal);

  const Vec3<T> trial = n.unloading * laid - (n.tangential_stiffness * law.dt) * slide;
  const auto slides = norm2(trial) > limit * limit;
  const Vec3<T> wanted = select(slides, trial, trial - n.tangential_damping * slide);
  FrictionLoad<T> out;
  out.force = share_within(norm(wanted), limit) * wanted;
  out.elastic = select(slides, out.force, trial);

  // What the spring stores now and stored before, with 1/St_old = (St/St_old)/St.
  const T stored = T(0.5) / larger(n.tangential_stiffness, T(1e-30)) * (norm2(out.elastic) - n.stiffening * last_size2);
  out.slipped = T(-0.5) * law.dt * dot(laid + out.elastic, slide) - stored;
  return out;
}

/// Energy of the tangential spring, Ft^2/(2 St) [J].
template <class T>
GYRO_HD T friction_energy(T tangential_stiffness, const Vec3<T>& elastic) {
  return norm2(elastic) / larger(T(2) * tangential_stiffness, T(1e-30));
}

}  // namespace gyro

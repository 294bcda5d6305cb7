// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact.hpp"

namespace gyro {

/// Inverse mass that a tangential force at the surface of a sphere meets, over 1/m: 1 + m R^2/I = 3.5.
inline constexpr double spin_share = 3.5;

/// The largest coefficient that the normal dashpot of a contact may have in this step [N s/m]; the tangential one has
/// 1/3.5 of it.
///
///   c_n <= beta q/(H (Qi/mi + Qj/mj)),   q = max(c_n, 3.5 c_t),   Q = sum of q over the contacts of a body
///
/// H is the time for which forces act, m the mass of the particle; a wall has no term. Explicit dashpots add energy
/// where H M^-1 C has an eigenvalue above 2, which a particle with several contacts reaches long before its springs
/// limit the step. With this cap the eigenvalues are at most beta, whatever the contacts:
///
///   v' C v = sum c (vi - vj)^2 <= sum c (Qi/mi + Qj/mj) (mi vi^2/Qi + mj vj^2/Qj) <= beta/H sum of m v^2
///
/// by Cauchy and Schwarz, and the springs' stable step falls to sqrt(4 - 2 beta) over their frequency. The cap scales
/// a pair of opposite forces, so momentum is exact. Where damping was resolved before, nothing changes.
///
/// Rolling resistance is not part of the bound.
///
/// Q is that of the last evaluation, with the q of this contact replaced by what it is now; the q of other contacts
/// lag by one evaluation.
///
/// Source: derived for this program; the alternative, dashpots treated implicitly particle by particle, loses momentum.
/// @param c     kinematics; c.damping_rate is Qi/mi + Qj/mj
/// @param own   q of this contact now [N s/m]
/// @param last  q at the last evaluation, 0 for a new contact [N s/m]
template <class T>
GYRO_HD T largest_dashpot(const ContactConstants<T>& law, const ContactMotion<T>& c, T own, T last) {
  const T all = larger(c.damping_rate * c.mass + (own - last), own);
  return law.max_rate * own * c.mass / larger(all, T(1e-30));
}

}  // namespace gyro

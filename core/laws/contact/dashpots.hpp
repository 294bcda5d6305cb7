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
/// A particle may have a beta of its own, beta_i (held_damping_cap()): then Qi/(beta_i mi) stands for Qi/mi, and H M^-1
/// C is bounded by the largest beta_i of the particles that move in an eigenvector.
///
/// Rolling resistance is not part of the bound.
///
/// Q is that of the last evaluation, with the q of this contact replaced by what it is now; the q of other contacts
/// lag by one evaluation.
///
/// Source: derived for this program; the alternative, dashpots treated implicitly particle by particle, loses momentum.
/// @param c     kinematics; c.damping_rate is Qi/(beta_i mi) + Qj/(beta_j mj)
/// @param own   q of this contact now [N s/m]
/// @param last  q at the last evaluation, 0 for a new contact [N s/m]
template <class T>
GYRO_HD T largest_dashpot(const ContactConstants<T>& law, const ContactMotion<T>& c, T own, T last) {
  const T all = larger(c.damping_rate * c.mass + (own - last), own);
  return law.max_rate * own * c.mass / larger(all, T(1e-30));
}

/// beta_i of a particle on few bonds (kernels/held_caps.hpp) whose rock takes several sub-steps in a step of the scene,
/// in which contact forces are held.
///
/// The velocity of a contact is that of one sub-step, in the middle of the vibration of a bond. A dashpot that is held
/// for half the period of this vibration pushes it further: z = H c/m adds z/pi to it in each step, and the bond's
/// damping takes pi zeta away, the vibration's period being 2H. It decays while z < pi^2 zeta, so that
///
///   beta_i = 6 zeta < pi^2 zeta,   at most 1
///
/// where zeta is the damping of bonds. Measured with a pair of bonded particles that is pinched between two plates,
/// over 89 bond radii (tests/hard/held_dashpots_test.cpp): with beta = 1 and zeta = 0.05 eleven of them gain energy
/// without end, with this cap none.
///
/// Source: derived for this program; that held forces need damped vibrations is known from molecular dynamics (Barth &
/// Schlick, J. Chem. Phys. 109 (1998) 1617).
/// @param bond_damping  fraction of critical damping of bonds [-]
constexpr double held_damping_cap(double bond_damping) {
  constexpr double share = 6, smallest = 0.02;
  const double cap = share * bond_damping;
  return cap < smallest ? smallest : cap > 1 ? 1 : cap;
}

}  // namespace gyro

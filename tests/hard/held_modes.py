#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How held contact forces act on one vibration of a bond: largest growth in a hold, from the eigenvalues of the map.

A mass of 1 on a bond (angular frequency w, damping zeta w/w_max of critical) touches a contact with a spring (stiffness kappa) and
a dashpot (coefficient c). A hold is 1 long and has k sub-steps of velocity Verlet; the contact force is evaluated after the
first of them, for the middle of the time for which it holds (core/dem/step.hpp). Two ways to see this middle:

  v    x + v s,             v           as the engine does; s = (1 - 1/k)/2
  va   x + v s + a s^2/2,   v + a s     with the acceleration a of the bond

Prints, for each k, kappa and c, the growth and the frequencies at which there is one. Needs python3-numpy.
"""
import numpy

ZETA, SHARE = 0.05, 1.33  # damping of bonds; w_max dt at 0.7 of the limit of the bond
CONTACTS = ((0.1, 0.3), (0.3, 0.3), (0.3, 0.6), (0.3, 1.0), (1.0, 0.6), (1.0, 1.0))  # kappa, c


def after_hold(state, w, zeta, kappa, c, k, with_acceleration):
    """Position, velocity and contact force after a hold."""
    x, v, force = state
    dt = 1 / k
    s = (1 - dt) / 2 if k > 1 else 0
    for substep in range(k):
        half = v + dt / 2 * (-w * w * x - 2 * zeta * w * v + force)
        x = x + dt * half
        bond = -w * w * x - 2 * zeta * w * half
        if substep == 0:
            a = bond if with_acceleration else 0
            force = -kappa * (x + half * s + a * s * s / 2) - c * (half + a * s)
        v = half + dt / 2 * (bond + force)
    return x, v, force


def growth(w, k, kappa, c, with_acceleration):
    zeta = ZETA * w / (SHARE * k)
    columns = [after_hold(unit, w, zeta, kappa, c, k, with_acceleration) for unit in numpy.eye(3)]
    return max(abs(numpy.linalg.eigvals(numpy.array(columns).T)))


def main():
    print("| seen | k |" + "".join(f" kappa {kappa}, c {c} |" for kappa, c in CONTACTS))
    print("|---" * (2 + len(CONTACTS)) + "|")
    for name, with_acceleration in (("v", False), ("va", True)):
        for k in (2, 3, 4, 6, 9):
            cells = []
            for kappa, c in CONTACTS:
                grows = [(w, growth(w, k, kappa, c, with_acceleration)) for w in numpy.arange(0.1, SHARE * k, 0.05)]
                grows = [(w, factor) for w, factor in grows if factor > 1 + 1e-6]
                worst = max((factor for _, factor in grows), default=0)
                cells.append(f"{worst:.2f} at {grows[0][0]:.1f}-{grows[-1][0]:.1f}" if grows else "none")
            print(f"| {name} | {k} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()

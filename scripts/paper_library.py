#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers behind figures 11, 12 and 13a of the reference paper, from `gyrosim library`, beside the paper's.

Usage: paper_library.py [--gyrosim PROGRAM] [--json FILE]
  --json FILE   also write the rocks of all libraries to FILE; `plot.py library FILE` draws the figures from it

Builds the libraries of cases/mkii-62-75/case.yaml (rocks of 50 to 500 mm): filled with particles of 8 to 45 mm (Fig. 11:
particles per rock), and with equal particles at ratios 10, 6, 4 and 2 (Fig. 12: particles per rock; Fig. 13a: number of
bonds). The paper is Xiong et al., Minerals 14 (2024) 774. The count that it prints for ratio 2 is that of ratio 4 here, and
its numbers of bonds are given as curves only.
"""
import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASE = ROOT / "cases" / "mkii-62-75" / "case.yaml"
RATIOS = (10, 6, 4, 2)  # of rock to particle diameter
PAPER_ENDS = ((50, 50), (500, 20000))  # Fig. 11: rock [mm], particles
PAPER_COUNTS = {10: 640, 6: 140, 2: 40}  # Fig. 12, as printed
DENSITY = 2600  # of the case's rock [kg/m3]


def library(gyrosim, fill):
    command = [str(gyrosim), "library", str(CASE), "--json", "--set", f"rocks.fill={fill}"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"paper_library.py: {' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return json.loads(done.stdout)["rocks"]


def bonds_per_tonne(rocks):
    """Each rock of the library stands for the same mass of feed."""
    return 1000 * sum(r["bonds"] / (DENSITY * math.pi / 6 * r["diameter"] ** 3) for r in rocks) / len(rocks)


def mean_by_number(rocks):
    weights = [r["diameter"] ** -3 for r in rocks]
    return sum(w * r["particles"] for w, r in zip(weights, rocks)) / sum(weights)


def print_tables(ranged, equal):
    counts = [r["particles"] for r in ranged]
    print("| Fig. 11: particles of 8 to 45 mm in rocks of 50 to 500 mm | here | paper |\n|---|---|---|")
    for name, rock, (size, count) in zip(("smallest", "largest"), (ranged[0], ranged[-1]), PAPER_ENDS):
        print(f"| {name} rock, {1e3 * rock['diameter']:.0f} mm | {rock['particles']} | {count:,}, at {size} mm |")
    print(f"| mean over the library | {sum(counts) / len(counts):.0f} | |")
    print(f"| mean over the rocks fed, by number | {mean_by_number(ranged):.0f} | about 1500 |")
    phi = [r["packing_fraction"] for r in ranged]
    print(f"| share of the rock's volume | {min(phi):.3f} to {max(phi):.3f} | |\n")
    print("| ratio | Fig. 12: particles here | paper | bonds a rock | Fig. 13a: bonds per tonne of feed |")
    print("|---|---|---|---|---|")
    for ratio, rocks in equal.items():
        n, b = [r["particles"] for r in rocks], [r["bonds"] for r in rocks]
        print(f"| {ratio} | {min(n)} to {max(n)} | {PAPER_COUNTS.get(ratio, '-')} | {min(b)} to {max(b)} | "
              f"{bonds_per_tonne(rocks):.4g} |")


def main():
    parser = argparse.ArgumentParser(description="Numbers of the paper's figures 11, 12 and 13a.")
    parser.add_argument("--gyrosim", type=Path, default=ROOT / "build" / "release" / "gyrosim")
    parser.add_argument("--json", type=Path, metavar="FILE", help="also write the rocks to FILE, for plot.py library")
    arguments = parser.parse_args()
    ranged = library(arguments.gyrosim, "{sizes: [8 mm, 45 mm]}")
    equal = {ratio: library(arguments.gyrosim, f"{{ratio: {ratio}}}") for ratio in RATIOS}
    print_tables(ranged, equal)
    if arguments.json:
        arguments.json.write_text(json.dumps({"ranged": ranged, "equal": equal}), encoding="utf-8")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 11, 12 and 13a of the reference paper from `gyrosim library`, beside the paper's numbers.

Usage: paper_library.py [--out DIR]

Builds the libraries of cases/mkii-62-75/case.yaml (rocks of 50 to 500 mm): filled with particles of 8 to 45 mm (Fig. 11:
particles per rock), and with equal particles at ratios 10, 6, 4 and 2 (Fig. 12: particles per rock; Fig. 13a: number of
bonds). Prints the table and draws DIR/paper_library.png. Needs python3-matplotlib; the paper is Xiong et al., Minerals
14 (2024) 774. Its ratio "2" has the count of ratio 4, and its bond numbers are given as curves only.
"""
import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASE = ROOT / "cases" / "mkii-62-75" / "case.yaml"
PAPER_COUNTS = {10: "640", 6: "140", 4: "40 (as ratio 2)", 2: "-"}
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


def print_tables(ranged, mono):
    counts = [r["particles"] for r in ranged]
    print("| Fig. 11: particles of 8 to 45 mm in rocks of 50 to 500 mm | here | paper |\n|---|---|---|")
    print(f"| smallest rock of the library, {1e3 * ranged[0]['diameter']:.0f} mm | {counts[0]} | 50 |")
    print(f"| largest, {1e3 * ranged[-1]['diameter']:.0f} mm | {counts[-1]} | 20,000 |")
    print(f"| mean over the library | {sum(counts) / len(counts):.0f} | |")
    print(f"| mean over the rocks fed, by number | {mean_by_number(ranged):.0f} | about 1500 |")
    phi = [r["packing_fraction"] for r in ranged]
    print(f"| share of the rock's volume | {min(phi):.3f} to {max(phi):.3f} | |\n")
    print("| ratio | Fig. 12: particles here | paper | bonds a rock | Fig. 13a: bonds per tonne of feed |")
    print("|---|---|---|---|---|")
    for ratio, rocks in mono.items():
        n, b = [r["particles"] for r in rocks], [r["bonds"] for r in rocks]
        print(f"| {ratio} | {min(n)} to {max(n)} | {PAPER_COUNTS[ratio]} | {min(b)} to {max(b)} | "
              f"{bonds_per_tonne(rocks):.4g} |")


def draw(ranged, mono, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.6))
    left.loglog([1e3 * r["diameter"] for r in ranged], [r["particles"] for r in ranged], "o", color="#3f5d73",
                label="library")
    left.loglog([50, 500], [50, 20000], "x", color="#b04a3a", markersize=9, label="paper, ends")
    left.set_title("Fig. 11: particles of 8 to 45 mm", fontsize=10)
    left.set_xlabel("rock [mm]")
    left.set_ylabel("particles in the rock")
    left.legend()
    ratios = list(mono)
    middle.loglog(ratios, [sum(r["particles"] for r in rocks) / len(rocks) for rocks in mono.values()], "o-",
                  color="#3f5d73", label="library")
    middle.loglog([10, 6, 2], [640, 140, 40], "x", color="#b04a3a", markersize=9, label="paper as printed")
    middle.set_title("Fig. 12: equal particles", fontsize=10)
    middle.set_xlabel("rock / particle diameter")
    middle.set_ylabel("particles in the rock")
    middle.legend()
    right.loglog(ratios, [bonds_per_tonne(rocks) for rocks in mono.values()], "o-", color="#3f5d73")
    right.set_title("Fig. 13a: bonds", fontsize=10)
    right.set_xlabel("rock / particle diameter")
    right.set_ylabel("bonds per tonne of feed")
    for axis in (middle, right):
        axis.set_xticks(ratios, [str(ratio) for ratio in ratios])
        axis.minorticks_off()
    left.set_xticks([50, 100, 200, 500], ["50", "100", "200", "500"])
    left.minorticks_off()
    for axis in (left, middle, right):
        axis.grid(color="#dddddd", linewidth=0.5, which="both")
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    print(f"\n{path}")


def main():
    parser = argparse.ArgumentParser(description="Figures 11, 12 and 13a from library output.")
    parser.add_argument("--gyrosim", type=Path, default=ROOT / "build" / "release" / "gyrosim")
    parser.add_argument("--out", type=Path, default=Path("."))
    arguments = parser.parse_args()
    ranged = library(arguments.gyrosim, "{sizes: [8 mm, 45 mm]}")
    mono = {ratio: library(arguments.gyrosim, f"{{ratio: {ratio}}}") for ratio in (10, 6, 4, 2)}
    print_tables(ranged, mono)
    arguments.out.mkdir(parents=True, exist_ok=True)
    draw(ranged, mono, arguments.out / "paper_library.png")


if __name__ == "__main__":
    main()

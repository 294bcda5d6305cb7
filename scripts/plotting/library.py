# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 11, 12 and 13a of Xiong et al., Minerals 14 (2024) 774, from what `paper_library.py --json` has written:
particles and bonds of the rocks of a library, beside the paper's numbers."""
import json
from pathlib import Path

from paper_library import PAPER_COUNTS, PAPER_ENDS, bonds_per_tonne
from plotting.style import MAIN, REFERENCE, PlotError, plt, save


def add_arguments(parser):
    parser.add_argument("library", type=Path, metavar="LIBRARY.json")
    parser.add_argument("--out", type=Path, help="default: LIBRARY.png")


def read(file):
    """(rocks of the range of particle sizes, {ratio: rocks} of equal particles)"""
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
        return found["ranged"], {int(ratio): rocks for ratio, rocks in found["equal"].items()}
    except (OSError, ValueError, KeyError) as error:
        raise PlotError(f"{file} cannot be read ({error}); give a file of `paper_library.py --json`") from error


def draw_range(axis, rocks):
    axis.loglog([1e3 * r["diameter"] for r in rocks], [r["particles"] for r in rocks], "o", color=MAIN, label="library")
    axis.loglog(*zip(*PAPER_ENDS), "x", color=REFERENCE, markersize=9, label="paper, ends")
    axis.set(title="Fig. 11: particles of 8 to 45 mm", xlabel="rock [mm]", ylabel="particles in the rock")
    axis.set_xticks([50, 100, 200, 500], ["50", "100", "200", "500"])
    axis.legend()


def draw_counts(axis, equal):
    means = [sum(r["particles"] for r in rocks) / len(rocks) for rocks in equal.values()]
    axis.loglog(list(equal), means, "o-", color=MAIN, label="library")
    axis.loglog(*zip(*PAPER_COUNTS.items()), "x", color=REFERENCE, markersize=9, label="paper as printed")
    axis.set(title="Fig. 12: equal particles", ylabel="particles in the rock")
    axis.legend()


def draw_bonds(axis, equal):
    axis.loglog(list(equal), [bonds_per_tonne(rocks) for rocks in equal.values()], "o-", color=MAIN)
    axis.set(title="Fig. 13a: bonds", ylabel="bonds per tonne of feed")


def draw(arguments):
    ranged, equal = read(arguments.library)
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.6))
    draw_range(left, ranged)
    draw_counts(middle, equal)
    draw_bonds(right, equal)
    for axis in (middle, right):
        axis.set_xticks(list(equal), [str(ratio) for ratio in equal])
        axis.set_xlabel("rock / particle diameter")
    for axis in (left, middle, right):
        axis.minorticks_off()
        axis.grid(True, which="both")
    save(figure, arguments.out or arguments.library.with_suffix(".png"))

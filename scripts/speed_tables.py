#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the tables "All scenes" of tests/bench/README.md from `gyrosim bench speed --json`.

    gyrosim bench speed --repeat 5 --json > speed.json
    gyrosim bench speed --scene F --precision mixed --json > f.json
    scripts/speed_tables.py speed.json f.json

Rates are by processor time with one thread and by wall time with two.
"""
import json
import sys
from pathlib import Path

from errors import fail

GROUPS = {
    "rocks advanced: sums, moves, bonds": ("advance rocks", "bonds of large rocks"),
    "pair forces": ("pair forces",),
    "wall forces": ("wall forces",),
    "sums for the ledger": ("sum bonds", "sum contacts", "sum particles", "book walls"),
}
LISTS = ("bounds", "carry", "cell", "count", "crowd", "ends", "extent", "find", "levels", "list", "sort", "speeds")


def group_of(phase):
    """The row of the table of shares to which a phase of the solver belongs."""
    for group, phases in GROUPS.items():
        if phase in phases:
            return group
    if phase != "other" and any(word in phase for word in LISTS):
        return "neighbour lists"
    return "other"


def number(value, digits=3):
    return f"{value:.{digits}g}"


def rates(scenes):
    """The lines of the table of rates."""
    lines = ["| scene | precision | M particle-steps/s | with two threads | M bond-steps/s | M contact evaluations/s | "
             "simulated s/hour, one and two threads | rebuilds | set-up [s] | bytes per particle |", "|" + "---|" * 10]
    found = {(s["scene"], s["precision"], s["threads"]): s for s in scenes}
    for (scene, precision, threads), one in found.items():
        if threads != 1:
            continue
        two = found.get((scene, precision, 2))
        rate = one["particle_steps_per_second"]
        bonds = one["bond_steps_per_second"]
        more = f"{number(two['particle_steps_per_second'] / 1e6)}, {two['particle_steps_per_second'] / rate:.2f} times" if two else ""
        hours = ", ".join(number(s["simulated_seconds_per_hour"]) for s in (one, two) if s)
        lines.append(f"| {scene} | {precision} | {number(rate / 1e6)} | {more} | {number(bonds / 1e6) if bonds else ''} | "
                     f"{one['contact_evaluations_per_second'] / 1e6:.2f} | {hours} | {one['rebuilds']} | "
                     f"{one['setup_seconds']:.2f} | {one['bytes_per_particle']:.0f} |")
    return lines


def shares(scenes):
    """The lines of the table of shares: one thread, mixed precision."""
    chosen = [s for s in scenes if s["threads"] == 1 and s["precision"] == "mixed"]
    lines = ["| shares [%], one thread, mixed | " + " | ".join(s["scene"] for s in chosen) + " |",
             "|" + "---|" * (len(chosen) + 1)]
    for group in (*list(GROUPS)[:3], "neighbour lists", "sums for the ledger", "other"):
        sums = [sum(share for phase, share in s["phases"].items() if group_of(phase) == group) for s in chosen]
        lines.append(f"| {group} | " + " | ".join(f"{100 * x:.0f}" if x >= 0.005 else "" for x in sums) + " |")
    return lines


def main(files):
    if not files:
        fail("speed_tables.py needs files of `gyrosim bench speed --json`")
    scenes = []
    for name in files:
        try:
            scenes += json.loads(Path(name).read_text())["scenes"]
        except (OSError, ValueError, KeyError) as problem:
            fail(f"{name}: {problem}; give a file of `gyrosim bench speed --json`")
    print("\n".join([*rates(scenes), "", *shares(scenes)]))


if __name__ == "__main__":
    main(sys.argv[1:])

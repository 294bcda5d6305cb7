#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the drives of several runs into one picture: speed of the eccentric and crushing power over time, with what happened
to each drive (stall, trip, standstill) listed and marked.

Usage: plot_drives.py RUNDIR... [--out FILE.png] [--smooth SECONDS]

Lines are named after the directories. Power is averaged over --smooth. Needs python3-h5py and python3-matplotlib.
"""
import argparse
import json
import sys
from pathlib import Path

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

RPM = 30 / np.pi
COLOURS = ["#c98a2b", "#3f5d73", "#a33b3b", "#5c7a4f", "#7a5c8a"]


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws speed and power of several runs over time.")
    parser.add_argument("runs", type=Path, nargs="+", metavar="RUNDIR")
    parser.add_argument("--out", type=Path, default=Path("drives.png"))
    parser.add_argument("--smooth", type=float, default=0.02, metavar="SECONDS", help="mean of the power over this time")
    return parser.parse_args()


def fail(text):
    sys.exit("plot_drives.py: " + text)


def read(run):
    """(time, speed in rpm, power in kW, [(time, event)])."""
    try:
        with h5py.File(run / "results.h5", "r", locking=False) as file:
            series = file["series"]
            columns = [series[name][:] for name in ("time", "eccentric_speed", "crushing_power")]
        events = json.loads((run / "summary.json").read_text())["drive_events"]
    except (OSError, KeyError, ValueError) as error:
        fail(f"{run} cannot be read ({error}); the directory of a crusher's run is accepted")
    if len(columns[0]) < 2:
        fail(f"{run} has less than two rows; a longer run is accepted")
    return columns[0], columns[1] * RPM, columns[2] / 1e3, [(event["time"], event["event"]) for event in events]


def mean_over(time, values, span):
    """Means over whole spans of time, and the middles of the spans."""
    rows = max(1, round(span / np.median(np.diff(time))))
    whole = len(time) // rows * rows
    if whole == 0:
        fail("--smooth is longer than the run; a shorter time is accepted")
    return time[:whole].reshape(-1, rows).mean(axis=1), values[:whole].reshape(-1, rows).mean(axis=1)


def main():
    arguments = parse_arguments()
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(8, 5.4), sharex=True)
    notes = []
    for k, run in enumerate(arguments.runs):
        time, speed, power, events = read(run)
        colour = COLOURS[k % len(COLOURS)]
        upper.plot(time, speed, color=colour, label=run.name)
        lower.plot(*mean_over(time, power, arguments.smooth), color=colour)
        for moment, what in events:
            upper.plot([moment], [np.interp(moment, time, speed)], "o", color=colour, markersize=4)
            notes.append((f"{run.name}: {what}, {moment:.3f} s", colour))
    for n, (text, colour) in enumerate(notes):
        upper.text(0.02, 0.05 + 0.085 * (len(notes) - 1 - n), text, color=colour, fontsize=8, transform=upper.transAxes)
    upper.set(ylabel="speed of the eccentric [rpm]")
    upper.legend(frameon=False, fontsize=9)
    lower.set(xlabel="time [s]", ylabel="crushing power [kW]")
    for axis in (upper, lower):
        axis.grid(alpha=0.3)
        axis.axhline(0, color="#888888", linewidth=0.6)
    figure.tight_layout()
    try:
        figure.savefig(arguments.out, dpi=110)
    except OSError as error:
        fail(f"{arguments.out} cannot be written ({error.strerror})")
    print(arguments.out)


if __name__ == "__main__":
    main()

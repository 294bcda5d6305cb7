# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives of several runs in one picture: speed of the eccentric and crushing power over time, with the events of each
drive (stall, trip, standstill) marked and listed. Lines are named after the directories."""
from pathlib import Path

import numpy as np

from plotting.run_data import mean_over, open_results, read_series, read_summary
from plotting.style import COLOURS, WIDTH, PlotError, label, plt, save, shown_units

NAMES = ("time", "eccentric_speed", "crushing_power")


def add_arguments(parser):
    parser.add_argument("runs", type=Path, nargs="+", metavar="RUNDIR")
    parser.add_argument("--out", type=Path, default=Path("drives.png"), help="default: drives.png")
    parser.add_argument("--smooth", type=float, default=0.02, metavar="SECONDS",
                        help="average the power over this time; default: 0.02")


def read(run):
    """(series, [(time, event)])"""
    with open_results(run) as file:
        series = read_series(file, NAMES)
    if len(series) < len(NAMES) or len(series["time"].values) < 2:
        raise PlotError(f"{run} has no drive or fewer than two rows; give the directory of a crusher's run")
    return series, [(event["time"], event["event"]) for event in read_summary(run).get("drive_events", [])]


def draw(arguments):
    runs = [(run.name, *read(run)) for run in arguments.runs]
    figure, axes = plt.subplots(2, 1, figsize=(WIDTH, 5.4), sharex=True)
    shown = []
    for axis, name in zip(axes, NAMES[1:]):
        largest = max(abs(series[name].values).max() for _, series, _ in runs)
        shown.append(shown_units(runs[0][1][name].units, largest))
        axis.set_ylabel(label(name, shown[-1][0]))
        axis.axhline(0, color="#888888", linewidth=0.6)
    notes = []
    for number, (name, series, events) in enumerate(runs):
        colour = COLOURS[number % len(COLOURS)]
        time, speed, power = (series[column].values for column in NAMES)
        speed = shown[0][1] * speed
        axes[0].plot(time, speed, color=colour, label=name)
        axes[1].plot(*mean_over(time, shown[1][1] * power, arguments.smooth), color=colour)
        for moment, what in events:
            axes[0].plot([moment], [np.interp(moment, time, speed)], "o", color=colour)
            notes.append((f"{name}: {what}, {moment:.3f} s", colour))
    for number, (text, colour) in enumerate(reversed(notes)):
        axes[0].text(0.02, 0.05 + 0.085 * number, text, color=colour, fontsize=8, transform=axes[0].transAxes)
    axes[0].legend()
    axes[1].set_xlabel("time [s]")
    save(figure, arguments.out)

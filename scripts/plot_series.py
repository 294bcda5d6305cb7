#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the time series of a run: speed of the eccentric, crushing power, broken bonds, discharged mass.

Usage: plot_series.py RUNDIR [--out FILE.png]

What a scene does not have is left out. Needs python3-h5py and python3-matplotlib.
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

RPM = 60 / (2 * np.pi)


def broken(series):
    return series["bonds_broken_tension"][:] + series["bonds_broken_shear"][:]


# dataset that must be there, label, value from /series
PANELS = [("eccentric_speed", "eccentric speed [rpm]", lambda s: s["eccentric_speed"][:] * RPM),
          ("crushing_power", "crushing power [W]", lambda s: s["crushing_power"][:]),
          ("bonds_broken_tension", "broken bonds", broken),
          ("discharged_mass", "discharged mass [kg]", lambda s: s["discharged_mass"][:])]


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws the time series of a run.")
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/series.png")
    return parser.parse_args()


def read(run):
    """(time, [(label, values)]) of the panels that the run has; rows of a run in progress are cut to the shortest."""
    try:
        with h5py.File(run / "results.h5", "r", locking=False) as file:
            series = file["series"]
            time = series["time"][:]
            curves = [(label, value(series)) for name, label, value in PANELS if name in series]
    except (OSError, KeyError) as error:
        sys.exit(f"plot_series.py: {run / 'results.h5'} cannot be read ({error}); a directory of a run is accepted")
    rows = min([len(time)] + [len(values) for _, values in curves])
    return time[:rows], [(label, values[:rows]) for label, values in curves]


def title_of(run):
    try:
        return json.loads((run / "summary.json").read_text()).get("title") or run.name
    except (OSError, ValueError):
        return run.name


def main():
    arguments = parse_arguments()
    time, curves = read(arguments.run)
    if not curves:
        sys.exit(f"plot_series.py: {arguments.run} has none of: {', '.join(label for _, label, _ in PANELS)}")
    figure, axes = plt.subplots(len(curves), sharex=True, figsize=(8, 1.6 * len(curves) + 0.6), squeeze=False)
    for axis, (label, values) in zip(axes[:, 0], curves):
        axis.plot(time, values, color="#3f5d73", linewidth=1)
        axis.set_ylabel(label.replace(" [", "\n["), fontsize=8)
        axis.tick_params(labelsize=8)
        axis.grid(color="#dddddd", linewidth=0.5)
    axes[-1, 0].set_xlabel("time [s]", fontsize=9)
    axes[0, 0].set_title(title_of(arguments.run), fontsize=10)
    figure.align_ylabels()
    figure.tight_layout()
    out = arguments.out or arguments.run / "series.png"
    try:
        figure.savefig(out, dpi=110)
    except OSError as error:
        sys.exit(f"plot_series.py: {out} cannot be written ({error.strerror})")
    print(out)


if __name__ == "__main__":
    main()

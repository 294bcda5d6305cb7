#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what a crusher's drive and liners say: torque and power over the eccentric's angle, the radial force of the rock
on the mantle as a polar plot, and maps of pressure and sliding work of the liners.

Usage: plot_machine.py RUNDIR [--from SECONDS] [--out FILE.png]

The polar plot shows the horizontal force on the mantle in the frame of the eccentric: 0 degrees is where the gap is closed,
positive angles lie ahead of it. Maps need output.liners in the case. Needs python3-h5py and python3-matplotlib.
"""
import argparse
import sys
from pathlib import Path

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

BINS = 72
COLOUR = "#3f5d73"


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws torque over angle, radial force and liner maps of a run.")
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--from", dest="begin", type=float, default=0, metavar="SECONDS", help="leave out what was before")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/machine.png")
    return parser.parse_args()


def fail(text):
    sys.exit("plot_machine.py: " + text)


def read(run, begin):
    """Series as arrays of equal length, and {wall: (heights, azimuths, mean pressure, sum of work)}."""
    try:
        with h5py.File(run / "results.h5", "r", locking=False) as file:
            names = ["time", "eccentric_angle", "mantle_torque", "crushing_power", "mantle_force"]
            if any(name not in file["series"] for name in names):
                fail(f"{run} has no drivetrain; a run of a crusher is accepted")
            series = {name: file["series"][name][:] for name in names}
            maps = {wall: read_map(group, begin) for wall, group in file.get("liners", {}).items()}
    except (OSError, KeyError) as error:
        fail(f"{run / 'results.h5'} cannot be read ({error}); a directory of a run is accepted")
    rows = min(len(values) for values in series.values())
    keep = series["time"][:rows] >= begin
    return {name: values[:rows][keep] for name, values in series.items()}, maps


def read_map(group, begin):
    heights, azimuths = group["heights"][:], group["azimuths"][:]
    rows = min(len(group["time"]), len(group["pressure"]), len(group["work"]))
    keep = group["time"][:rows] > begin
    shape = (len(heights) - 1, len(azimuths) - 1)
    pressure, work = group["pressure"][:rows][keep], group["work"][:rows][keep]
    if len(pressure) == 0:
        return heights, azimuths, np.zeros(shape), np.zeros(shape)
    return heights, azimuths, pressure.mean(axis=0).reshape(shape), work.sum(axis=0).reshape(shape)


def draw_by_angle(axis, series):
    angle = np.degrees(np.mod(series["eccentric_angle"], 2 * np.pi))
    edges = np.linspace(0, 360, BINS + 1)
    count = np.histogram(angle, edges)[0]
    total = np.histogram(angle, edges, weights=series["mantle_torque"])[0]
    middle = (edges[1:] + edges[:-1]) / 2
    axis.plot(angle, series["mantle_torque"], ".", markersize=1, color="#b8c4cc")
    axis.plot(middle[count > 0], (total / np.maximum(count, 1))[count > 0], color=COLOUR)
    axis.set(xlabel="eccentric angle [deg]", ylabel="torque of the rock [N m]", xlim=(0, 360), xticks=range(0, 361, 90))


def draw_polar(axis, series):
    force = series["mantle_force"]
    size = np.hypot(force[:, 0], force[:, 1])
    lag = np.arctan2(force[:, 1], force[:, 0]) - series["eccentric_angle"] + np.pi  # rock pushes away from the gap
    axis.plot(lag, size, ".", markersize=2, color=COLOUR)
    axis.set_title("radial force [N] seen from the closed side", fontsize=9)
    axis.tick_params(labelsize=7)


def draw_map(figure, axis, values, heights, azimuths, label):
    mesh = axis.pcolormesh(np.degrees(azimuths), heights, values, cmap="cividis", shading="flat")
    figure.colorbar(mesh, ax=axis)
    axis.set(xlabel="azimuth [deg]", ylabel="height [m]", xticks=range(0, 361, 90))
    axis.set_title(label, fontsize=9)


def main():
    arguments = parse_arguments()
    series, maps = read(arguments.run, arguments.begin)
    if len(series["time"]) == 0:
        fail("no row is left; an earlier --from is accepted")
    figure = plt.figure(figsize=(10, 3.6 * (1 + len(maps))))
    rows = 1 + len(maps)
    draw_by_angle(figure.add_subplot(rows, 2, 1), series)
    draw_polar(figure.add_subplot(rows, 2, 2, projection="polar"), series)
    for k, (wall, (heights, azimuths, pressure, work)) in enumerate(sorted(maps.items())):
        draw_map(figure, figure.add_subplot(rows, 2, 3 + 2 * k), pressure, heights, azimuths, f"{wall}: mean pressure [Pa]")
        draw_map(figure, figure.add_subplot(rows, 2, 4 + 2 * k), work, heights, azimuths, f"{wall}: sliding work [J]")
    figure.tight_layout()
    out = arguments.out or arguments.run / "machine.png"
    try:
        figure.savefig(out, dpi=110)
    except OSError as error:
        fail(f"{out} cannot be written ({error.strerror})")
    print(out)


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads of a crusher's drive and liners: torque of the rock over the eccentric's angle, the radial force on the mantle as a
polar plot, and maps of pressure and sliding work on the liners.

The polar plot shows the horizontal force on the mantle in the frame of the eccentric: the gap is closed at 0 degrees, and
positive angles lie ahead of it. Maps need `output.liners` in the case."""
from pathlib import Path

import numpy as np
from matplotlib.ticker import MaxNLocator

from plotting.maps import draw_map, end_of_scale
from plotting.run_data import open_results, read_series, read_title
from plotting.style import FAINT, MAIN, PlotError, label, plt, save, shown_units

BINS = 72
NAMES = ("time", "eccentric_angle", "mantle_torque", "mantle_force")


def add_arguments(parser):
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--from", dest="begin", type=float, default=0, metavar="SECONDS", help="leave out earlier rows")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/machine.png")


def read(run, begin):
    """({name: Column} of the rows from `begin` on, [(title, units, heights, azimuths, map)])"""
    with open_results(run) as file:
        series = read_series(file, NAMES)
        if len(series) < len(NAMES):
            raise PlotError(f"{run} has no drivetrain; give the directory of a crusher's run")
        maps = [part for wall, group in sorted(file.get("liners", {}).items()) for part in read_maps(wall, group, begin)]
    keep = series["time"].values >= begin
    for column in series.values():
        column.values = column.values[keep]
    if len(series["time"].values) == 0:
        raise PlotError("no row is left; use an earlier --from")
    return series, maps


def read_maps(wall, group, begin):
    """Maps of one liner: mean of the pressure and sum of the sliding work since `begin`."""
    heights, azimuths = group["heights"][:], group["azimuths"][:]
    rows = min(len(group[name]) for name in ("time", "pressure", "work"))
    keep = group["time"][:rows] > begin
    for name, title, reduce in (("pressure", "mean pressure", np.mean), ("work", "sliding work", np.sum)):
        cells = group[name][:rows][keep]
        total = reduce(cells, axis=0) if len(cells) else np.zeros(group[name].shape[1])
        yield f"{wall}: {title}", group[name].attrs.get("units", ""), heights, azimuths, total.reshape(
            len(heights) - 1, len(azimuths) - 1)


def draw_by_angle(axis, angle, torque, units):
    angle = np.degrees(np.mod(angle, 2 * np.pi))
    edges = np.linspace(0, 360, BINS + 1)
    count = np.histogram(angle, edges)[0]
    total = np.histogram(angle, edges, weights=torque)[0]
    middle = (edges[1:] + edges[:-1]) / 2
    axis.plot(angle, torque, ".", markersize=1, color=FAINT)
    axis.plot(middle[count > 0], (total / np.maximum(count, 1))[count > 0], color=MAIN)
    axis.set(xlabel="eccentric angle [deg]", ylabel=label("torque of the rock", units), xlim=(0, 360),
             xticks=range(0, 361, 90))


def draw_polar(axis, force, angle, units):
    size = np.hypot(force[:, 0], force[:, 1])
    ahead = np.arctan2(force[:, 1], force[:, 0]) - angle + np.pi  # the rock pushes the mantle away from the gap
    axis.plot(ahead, size, ".", markersize=2, color=MAIN)
    axis.set_rlabel_position(200)
    axis.yaxis.set_major_locator(MaxNLocator(4))
    axis.set_title(label("radial force", units) + " seen from the closed side")


def draw_load(figure, axis, title, units, heights, azimuths, values):
    units, factor = shown_units(units, end_of_scale(values))
    draw_map(figure, axis, title, units, heights, azimuths, factor * values)


def draw(arguments):
    series, maps = read(arguments.run, arguments.begin)
    rows = 1 + (len(maps) + 1) // 2
    figure = plt.figure(figsize=(11, 3.6 * rows))
    title = read_title(arguments.run)
    figure.suptitle(f"{title}: loads from {arguments.begin:.3g} to {series['time'].values[-1]:.3g} s", fontsize=11)
    angle, torque, force = (series[name] for name in NAMES[1:])
    units, factor = shown_units(torque.units, abs(torque.values).max())
    draw_by_angle(figure.add_subplot(rows, 2, 1), angle.values, factor * torque.values, units)
    units, factor = shown_units(force.units, abs(force.values).max())
    draw_polar(figure.add_subplot(rows, 2, 2, projection="polar"), factor * force.values, angle.values, units)
    for number, part in enumerate(maps):
        draw_load(figure, figure.add_subplot(rows, 2, 3 + number), *part)
    save(figure, arguments.out or arguments.run / "machine.png")

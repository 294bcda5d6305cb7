# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear of the liners in mm per 1000 h of operation at the mean rate of the run: an unrolled map for each liner, height
in the liner's own frame against azimuth, and beside it the mean at each height. The colour scale ends where 98 % of the
worn cells do; the title has the largest value.

Depth by Archard's law: coefficient x normal force x sliding distance / area = coefficient x work of friction / (friction x
area), from the maps of `output.liners`. The coefficient is output.liners.wear_coefficient of the case; --coefficient takes
another one, or one for a run without."""
from pathlib import Path

import numpy as np

from plotting.case import friction, read_case
from plotting.maps import draw_map, end_of_scale
from plotting.run_data import open_results, read_title
from plotting.style import MAIN, PlotError, plt, save

UNITS = "mm per 1000 h"
PER_METRE_A_SECOND = 1e3 * 1000 * 3600  # mm per 1000 h


def add_arguments(parser):
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--from", dest="begin", type=float, default=0, metavar="SECONDS", help="leave out earlier maps")
    parser.add_argument("--coefficient", type=float, metavar="K",
                        help="volume worn / (normal force x sliding distance) [1/Pa]; default: that of the case")
    parser.add_argument("--max", type=float, metavar="WEAR", help="end of the colour scale [mm per 1000 h]")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/wear.png")


class WearMap:
    """Wear of one liner.

    heights, azimuths  edges of the cells [m], [rad]
    rate               [mm per 1000 h], a row of cells for each height; NaN where the liner has no surface
    area               of the surface in each cell [m2]
    begin, end         of the time that it is a mean of [s]
    """

    def __init__(self, group, begin, factor):
        """factor: coefficient / friction [1/Pa]. @raises PlotError without a map after `begin`"""
        rows = min(len(group["time"]), len(group["work"]))
        time = group["time"][:rows]
        first = int(np.searchsorted(time, begin * (1 + 1e-9), side="right"))
        if first == rows:
            raise PlotError(f"there is no map of {group.name} after {begin:g} s; use an earlier --from, or wait for the "
                            "first one (output.liners.interval)")
        self.begin, self.end = float(time[first - 1]) if first else 0.0, float(time[-1])
        self.heights, self.azimuths = group["heights"][:], group["azimuths"][:]
        shape = len(self.heights) - 1, len(self.azimuths) - 1
        self.area = group["area"][:].reshape(shape)
        work = group["work"][first:rows].sum(axis=0, dtype=float).reshape(shape)
        depth = factor * work / np.where(self.area > 0, self.area, np.nan)
        self.rate = PER_METRE_A_SECOND * depth / (self.end - self.begin)

    def mean_by_height(self):
        """Mean over the surface at each height."""
        area = self.area.sum(axis=1)
        worn = np.nansum(self.rate * self.area, axis=1)
        return worn / np.where(area > 0, area, np.nan)


def read(run, begin, coefficient):
    """{wall: WearMap}"""
    with open_results(run) as file:
        case = read_case(file)
        if not file.get("liners"):
            raise PlotError(f"{run} has no maps of liners; run the case with --set output.liners.interval=...")
        coefficient = coefficient or case["output"]["liners"].get("wear_coefficient")
        if coefficient is None:
            raise PlotError(f"the case of {run} has no output.liners.wear_coefficient; give --coefficient")
        return {wall: WearMap(group, begin, float(coefficient) / friction(case, wall) if friction(case, wall) else 0)
                for wall, group in sorted(file["liners"].items())}


def draw_profile(axis, worn):
    values = worn.mean_by_height()
    axis.stairs(np.nan_to_num(values), worn.heights, orientation="horizontal", fill=True, color=MAIN)
    axis.set(xlabel=f"wear [{UNITS}]", title="mean over the azimuth", xlim=(0, 1.05 * np.nanmax(values) or 1))


def draw(arguments):
    maps = read(arguments.run, arguments.begin, arguments.coefficient)
    figure, axes = plt.subplots(len(maps), 2, figsize=(10, 3.4 * len(maps) + 0.4), squeeze=False, sharey="row",
                                gridspec_kw={"width_ratios": (3, 1)})
    end = arguments.max or end_of_scale(*(worn.rate for worn in maps.values()))
    for (left, right), (wall, worn) in zip(axes, maps.items()):
        draw_map(figure, left, f"{wall}: wear", UNITS, worn.heights, worn.azimuths, worn.rate, end)
        draw_profile(right, worn)
    title = read_title(arguments.run)
    span = next(iter(maps.values()))
    figure.suptitle(f"{title}: wear of the liners at the mean rate from {span.begin:.3g} to {span.end:.3g} s", fontsize=11)
    save(figure, arguments.out or arguments.run / "wear.png")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Size curves of a crusher's run: cumulative passing of the feed, of the rock in the chamber and of the product at the end
of the run, with their P80 and the side settings.

The feed is the size distribution that the case states, by equal-volume diameter. Chamber and product are sieved, and
interpolated between sieves on the logarithm of the size, as P80 is in results.h5. Sizes of particles, the smallest
pieces, are shaded. Finer product is unknown; with output.fines its estimate is a dashed line."""
from pathlib import Path

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator

from plotting.case import feed_curve, read_case, settings
from plotting.run_data import open_results, read_title
from plotting.style import BAND, COLOURS, WIDTH, PlotError, plt, save

MARGIN = 1.3  # of the axis of sizes beyond the curves
DECADE = (1, 2, 5)
SETTING = "#444444"
COLOUR = dict(zip(("feed", "chamber", "product"), COLOURS))
LAWS = {"breakage": "by the energy of breakage", "gates_gaudin_schuhmann": "by a Gates-Gaudin-Schuhmann distribution"}


def add_arguments(parser):
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--from", dest="begin", type=float, default=0, metavar="SECONDS",
                        help="only the product discharged after this time")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/curves.png")


class Curve:
    """Share of the mass that passes a size.

    sizes    rising [m]
    passing  rising from 0 to 1
    mass     [kg]; None of a feed, which is a law
    p80      [m]
    """

    def __init__(self, sizes, passing, mass=None):
        self.sizes, self.passing, self.mass = sizes, passing, mass
        self.p80 = passing_size(sizes, passing, 0.8)


def passing_size(sizes, passing, share):
    """Size that a share passes, between two points of a curve linear on the logarithm of the size."""
    above = int(np.searchsorted(passing, share))
    if not 0 < above < len(passing):
        return float("nan")
    part = (share - passing[above - 1]) / (passing[above] - passing[above - 1])
    return float(sizes[above - 1] * (sizes[above] / sizes[above - 1]) ** part)


def read_sieved(group, begin=0, column="passing"):
    """(time of the last row, Curve of the mass that was added after `begin`); the curve is None without such mass."""
    rows = min(len(group[name]) for name in ("time", column, "mass"))
    time, passing, mass = (group[name][:rows] for name in ("time", column, "mass"))
    if rows == 0:
        return 0.0, None
    added, finer = mass[-1], mass[-1] * passing[-1]
    before = np.flatnonzero(time <= begin)
    if before.size:
        added, finer = added - mass[before[-1]], finer - mass[before[-1]] * passing[before[-1]]
    return float(time[-1]), Curve(group["sizes"][:], finer / added, float(added)) if added > 0 else None


class Resolution:
    """Where the curves end.

    finest, coarsest  sizes of particles [m]; None of a run whose rock cannot break, or of an older version
    fines             {name: Curve} with estimated fines
    law               how these are estimated
    """

    def __init__(self, groups, case, begin):
        attributes = groups["product"].attrs
        self.coarsest, self.finest = attributes.get("resolution"), attributes.get("finest_particle")
        self.law = LAWS.get(next(iter((case.get("output") or {}).get("fines") or {}), None), "")
        self.fines = {name: read_sieved(group, begin if name == "product" else 0, "passing_with_fines")[1]
                      for name, group in groups.items() if "passing_with_fines" in group}
        self.fines = {name: curve for name, curve in self.fines.items() if curve}


def read(run, begin):
    """(time, {name: Curve} of those that there are, Resolution, {name: side setting [m]})"""
    with open_results(run) as file:
        if "product" not in file:
            raise PlotError(f"{run} has no crusher; give the directory of a crusher's run")
        case = read_case(file)
        time, product = read_sieved(file["product"], begin)
        if begin >= time > 0:
            raise PlotError(f"the run is at {time:g} s; use an earlier --from")
        curves = {"chamber": read_sieved(file["holdup"])[1], "product": product}
        resolution = Resolution({"chamber": file["holdup"], "product": file["product"]}, case, begin)
    feed = feed_curve(case)
    if feed:
        curves = {"feed": Curve(*feed), **curves}
    return time, {name: curve for name, curve in curves.items() if curve}, resolution, settings(case)


def limits(curves):
    """(smallest, largest) size of the axis: where the curves rise from 0 to 1."""
    low = min(c.sizes[max(0, np.count_nonzero(c.passing <= 0) - 1)] for c in curves)
    high = max(c.sizes[min(len(c.sizes) - 1, np.count_nonzero(c.passing < 1 - 1e-9))] for c in curves)
    return low, high


def draw_curve(axis, name, curve):
    mass = "case" if curve.mass is None else f"{curve.mass:.3g} kg"
    p80 = f"P80 = {1e3 * curve.p80:.3g} mm" if np.isfinite(curve.p80) else "P80 beyond the sieves"
    axis.plot(1e3 * curve.sizes, 100 * curve.passing, color=COLOUR[name], label=f"{name} ({mass}): {p80}")
    axis.plot([1e3 * curve.p80] * 2, [0, 80], ":", color=COLOUR[name], linewidth=1)
    axis.plot([1e3 * curve.p80], [80], "o", color=COLOUR[name], markersize=6)


def draw_fines(axis, resolution):
    for name, curve in resolution.fines.items():
        p80 = f"P80 = {1e3 * curve.p80:.3g} mm" if np.isfinite(curve.p80) else "P80 beyond the sieves"
        axis.plot(1e3 * curve.sizes, 100 * curve.passing, color=COLOUR[name], linestyle=(0, (4, 2)), linewidth=1.3,
                  label=f"{name} with estimated fines: {p80}")


def draw_resolution(axis, resolution, low):
    """Shades the sizes that the particles do not resolve: lightly those of the particles, and darker what is finer.

    low  left end of the axis [m]"""
    if resolution.coarsest is None:
        return
    finest, coarsest = resolution.finest, resolution.coarsest
    axis.axvspan(1e3 * low, 1e3 * finest, color=BAND, alpha=0.75, linewidth=0)
    sizes = f"{1e3 * coarsest:.3g}"
    if coarsest > 1.001 * finest:
        axis.axvspan(1e3 * finest, 1e3 * coarsest, color=BAND, alpha=0.35, linewidth=0)
        sizes = f"{1e3 * finest:.3g} to {sizes}"
    known = f"below {1e3 * coarsest:.3g} mm\nestimated,\n{resolution.law}" if resolution.fines else "finer rock\nis unknown"
    axis.annotate(f"particles of\n{sizes} mm:\n{known}", (0, 0.98), xycoords="axes fraction", xytext=(4, 0),
                  textcoords="offset points", ha="left", va="top", fontsize=7.5, color=SETTING)


def draw_settings(axis, sides):
    """Vertical lines with their names above the picture, on the sides that face away from each other."""
    for (name, size), (text, side) in zip(sides.items(), (("{} {:.3g} mm ", "right"), (" {} {:.3g} mm", "left"))):
        axis.axvline(1e3 * size, color=SETTING, linestyle="--", linewidth=1)
        axis.annotate(text.format(name, 1e3 * size), (1e3 * size, 1), xycoords=("data", "axes fraction"), ha=side,
                      va="bottom", fontsize=8, xytext=(0, 3), textcoords="offset points", color=SETTING)


def draw(arguments):
    time, curves, resolution, sides = read(arguments.run, arguments.begin)
    if not curves:
        raise PlotError(f"{arguments.run} has no rock yet; wait until the run has some")
    figure, axis = plt.subplots(figsize=(WIDTH, 5))
    axis.axhline(80, color="#999999", linewidth=0.8)
    draw_settings(axis, sides)
    for name, curve in curves.items():
        draw_curve(axis, name, curve)
    draw_fines(axis, resolution)
    low, high = limits([*curves.values(), *resolution.fines.values()])
    low, high = min([low, *sides.values()]), max([high, *sides.values()])
    if resolution.finest is not None:
        low = min(low, resolution.finest)
    draw_resolution(axis, resolution, low / MARGIN)
    axis.set(xscale="log", xlim=(1e3 * low / MARGIN, 1e3 * high * MARGIN), ylim=(0, 101), xlabel="size [mm]",
             ylabel="cumulative passing [% of the mass]", yticks=range(0, 101, 10))
    axis.xaxis.set_major_locator(LogLocator(subs=DECADE))
    axis.xaxis.set_major_formatter(FuncFormatter("{:g}".format))
    axis.xaxis.set_minor_formatter("")
    title = read_title(arguments.run)
    since = f", product since {arguments.begin:g} s" if arguments.begin > 0 else ""
    axis.set_title(f"{title}: size curves at {time:.3f} s{since}", pad=20)  # above the names of the settings
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.11), ncol=2 if resolution.fines else len(curves), handlelength=1.8, columnspacing=1.5)
    save(figure, arguments.out or arguments.run / "curves.png")

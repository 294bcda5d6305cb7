# SPDX-License-Identifier: GPL-3.0-or-later
"""Time series of a run: speed of the eccentric, crushing power, broken bonds, mass in the chamber and discharged. Panels
that the scene does not have are left out. Where summary.json says that the run became steady, that part is shaded, with the
mean power since then."""
from pathlib import Path

from plotting.run_data import Column, open_results, read_series, read_summary, read_title
from plotting.style import MAIN, REFERENCE, STEADY, WIDTH, PlotError, label, plt, save, shown_units

BROKEN = ("bonds_broken_tension", "bonds_broken_shear")
PANELS = ("eccentric_speed", "crushing_power", "broken_bonds", "holdup_mass", "discharged_mass")
NAMES = {"holdup_mass": "chamber mass"}  # where the name of the column is not what a reader expects


def add_arguments(parser):
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/series.png")


def read(run):
    """({name: Column} of `time` and the panels, summary)"""
    with open_results(run) as file:
        series = read_series(file, ("time", *PANELS, *BROKEN))
    if all(name in series for name in BROKEN):
        series["broken_bonds"] = Column(sum(series.pop(name).values for name in BROKEN), "1")
    if len(series) < 2:
        raise PlotError(f"{run} has none of {', '.join(PANELS)}; give the directory of a crusher's run")
    if len(series["time"].values) == 0:
        raise PlotError(f"{run} has no row yet; wait for the first one (output.series)")
    return series, read_summary(run)


def draw_steady(axes, steady, time, panels, factors):
    """Shades the steady part of all panels; the mean power in it is a dashed line."""
    begin = steady["from"]
    for axis in axes:
        axis.axvspan(begin, time[-1], color=STEADY, linewidth=0)
    axes[0].plot([], [], linewidth=8, color=STEADY, label=f"steady from {begin:.3g} s")
    axes[0].legend(loc="best")
    if "crushing_power" in panels and steady.get("crushing_power") is not None:
        at = panels.index("crushing_power")
        axes[at].plot([begin, time[-1]], [factors[at][1] * steady["crushing_power"]] * 2, "--", color=REFERENCE,
                      label=f"mean {factors[at][1] * steady['crushing_power']:.3g} {factors[at][0]}")
        axes[at].legend(loc="best")


def draw(arguments):
    series, summary = read(arguments.run)
    time = series["time"].values
    panels = [name for name in PANELS if name in series]
    factors = [shown_units(series[name].units, abs(series[name].values).max()) for name in panels]
    figure, axes = plt.subplots(len(panels), sharex=True, figsize=(WIDTH, 1.5 * len(panels) + 0.6), squeeze=False)
    axes = axes[:, 0]
    for axis, name, (units, factor) in zip(axes, panels, factors):
        axis.plot(time, factor * series[name].values, color=MAIN)
        axis.set_ylabel(label(NAMES.get(name, name), units, "\n"))
        axis.ticklabel_format(axis="y", useOffset=False)  # 452.5, not 0.5 above 4.52e2
        axis.margins(x=0.01)
    if summary.get("steady"):
        draw_steady(axes, summary["steady"], time, panels, factors)
    axes[-1].set_xlabel("time [s]")
    axes[0].set_title(read_title(arguments.run))
    figure.align_ylabels()
    save(figure, arguments.out or arguments.run / "series.png")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Time series of a run: speed of the eccentric, crushing power, broken bonds, discharged mass. Panels that the scene
does not have are left out."""
from pathlib import Path

from plotting.run_data import Column, open_results, read_series, read_summary
from plotting.style import MAIN, WIDTH, PlotError, label, plt, save, shown_units

BROKEN = ("bonds_broken_tension", "bonds_broken_shear")
PANELS = ("eccentric_speed", "crushing_power", "broken_bonds", "discharged_mass")


def add_arguments(parser):
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/series.png")


def draw(arguments):
    with open_results(arguments.run) as file:
        series = read_series(file, ("time", *PANELS, *BROKEN))
    if all(name in series for name in BROKEN):
        series["broken_bonds"] = Column(sum(series[name].values for name in BROKEN), series[BROKEN[0]].units)
    panels = [name for name in PANELS if name in series]
    if not panels:
        raise PlotError(f"{arguments.run} has none of {', '.join(PANELS)}; give the directory of a crusher's run")
    figure, axes = plt.subplots(len(panels), sharex=True, figsize=(WIDTH, 1.6 * len(panels) + 0.6), squeeze=False)
    for axis, name in zip(axes[:, 0], panels):
        values = series[name].values
        units, factor = shown_units(series[name].units, abs(values).max(initial=0))
        axis.plot(series["time"].values, factor * values, color=MAIN)
        axis.set_ylabel(label(name, units, "\n"))
    axes[-1, 0].set_xlabel("time [s]")
    axes[0, 0].set_title(read_summary(arguments.run).get("title") or arguments.run.name)
    figure.align_ylabels()
    save(figure, arguments.out or arguments.run / "series.png")

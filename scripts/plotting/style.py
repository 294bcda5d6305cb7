# SPDX-License-Identifier: GPL-3.0-or-later
"""What all pictures share: fonts, colours, grid, sizes, and units that read well."""
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

COLOURS = ["#3f5d73", "#c98a2b", "#a33b3b", "#5c7a4f", "#7a5c8a", "#4a8f9c"]
MAIN, REFERENCE = COLOURS[0], COLOURS[2]  # what was computed here, and what it is compared with
FAINT = "#b8c4cc"
BAND = "#cccccc"
STEADY = "#e6eedf"  # behind what is steady
WIDTH = 8  # of a picture with one column of panels [inch]

STYLE = {
    "figure.dpi": 110, "savefig.dpi": 110, "figure.constrained_layout.use": True,
    "font.size": 9, "axes.titlesize": 10, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8,
    "legend.fontsize": 8, "legend.frameon": False,
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS), "lines.linewidth": 1.2, "lines.markersize": 4,
    "axes.grid": True, "axes.axisbelow": True, "grid.color": "#dddddd", "grid.linewidth": 0.5,
    "axes.edgecolor": "#888888", "axes.linewidth": 0.6,
}

# Units of results.h5 that a reader expects otherwise: (name, factor).
SHOWN_AS = {"rad/s": ("rpm", 30 / math.pi), "rad": ("deg", 180 / math.pi), "1": ("", 1)}
TAKES_PREFIX = ("W", "N", "N m", "J", "Pa")


class PlotError(Exception):
    """A picture that cannot be drawn; the text says why and what to do."""


def use_style():
    plt.rcParams.update(STYLE)


def shown_units(units, largest):
    """(units to show, factor) for values in `units` up to `largest`: rpm for rad/s, kW for thousands of W."""
    if units in SHOWN_AS:
        return SHOWN_AS[units]
    if units in TAKES_PREFIX:
        for prefix, size in (("M", 1e6), ("k", 1e3)):
            if largest >= 2 * size:
                return prefix + units, 1 / size
    return units, 1


def label(name, units, separator=" "):
    """`crushing power [kW]`"""
    return name.replace("_", " ") + (f"{separator}[{units}]" if units else "")


def save(figure, path):
    try:
        figure.savefig(path)
    except OSError as error:
        raise PlotError(f"{path} cannot be written ({error.strerror}); name another file with --out") from error
    print(path)

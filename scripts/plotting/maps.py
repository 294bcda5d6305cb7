# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of liners, unrolled: height against azimuth."""
import numpy as np

from plotting.style import label

COLOURS = "YlOrBr"
NO_SURFACE = "#dddddd"
SHOWN = 0.98  # share of the loaded cells that the colour scale tells apart


def end_of_scale(*maps):
    """Where the colours of maps end: few cells carry far more than the others, and would leave all of them pale."""
    loaded = np.concatenate([values[values > 0] for values in maps])
    return float(np.quantile(loaded, SHOWN)) if loaded.size else 1.0


def draw_map(figure, axis, title, units, heights, azimuths, values, end=None):
    """@param values  by height and azimuth, NaN where there is no surface; heights, azimuths  edges of the cells [m], [rad]"""
    end = end or end_of_scale(values)
    largest = np.nanmax(values)
    mesh = axis.pcolormesh(np.degrees(azimuths), heights, values, cmap=COLOURS, vmin=0, vmax=end, shading="flat")
    figure.colorbar(mesh, ax=axis, extend="max" if largest > end else "neither")
    axis.set(xlabel="azimuth [deg]", ylabel="height [m]", xticks=range(0, 361, 45), facecolor=NO_SURFACE,
             title=f"{label(title, units)}, at most {largest:.3g}")
    axis.grid(False)

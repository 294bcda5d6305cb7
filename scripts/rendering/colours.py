# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of fragments, and scales from numbers to colours with their legends."""
import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

# Stone, ochre, rust, slate and moss: neighbours differ, nothing shouts.
PALETTE = ["#c9a26b", "#8c5a3c", "#5b7a8c", "#d9c08a", "#a3453a", "#6f8f6a", "#3f5d73", "#b98b5e", "#7d6a8a",
           "#c77b4a", "#93a7b0", "#54745a", "#e0b15a", "#7a4b4b", "#4f8a8b", "#a89a7d", "#b5654d", "#66708c"]
FINES = "#b9b2a4"  # fragments of one particle, in scenes that have larger ones
VIRIDIS = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"]
STEEL = ["#bcc3cb", "#f1c56d", "#dd7f38", "#a3313f", "#3f1238"]  # of walls: what carries nothing looks like steel
NO_NUMBER = (0.8, 0.82, 0.85)
TEXT = (0.2, 0.23, 0.27)
STEPS = (1, 1.2, 1.6, 2, 2.4, 3.2, 4, 5, 6, 8, 10)  # ends of scales, whose quarters read well


def rgb(text):
    return tuple(int(text[k:k + 2], 16) / 255 for k in (1, 3, 5))


def category_colours(names, fines):
    """Fixed pseudo-random palette entries, so that a fragment keeps its colour over frames."""
    hashed = (names.astype(np.uint64) * np.uint64(2654435761)) & np.uint64(0xFFFFFFFF)
    palette = np.array([rgb(colour) for colour in PALETTE])
    colours = palette[(hashed >> np.uint64(16)) % np.uint64(len(palette))]
    colours *= (0.9 + 0.2 * ((hashed & np.uint64(255)) / 255.0))[:, None]
    if fines:
        _, place, count = np.unique(names, return_inverse=True, return_counts=True)
        if count.size and count.max() > 1:
            colours[count[place] == 1] = rgb(FINES)
    return np.clip(255 * colours, 0, 255).astype(np.uint8)


def end_of_scale(values, share):
    """A round number that this share of the values lies below."""
    values = values[np.isfinite(values)]
    high = float(np.quantile(values, share)) if values.size else 0
    if high <= 0:
        return 1.0
    decade = 10.0 ** math.floor(math.log10(high))
    return decade * next(step for step in STEPS if high <= step * decade * (1 + 1e-9) or step == STEPS[-1])


def prefix_of(high):
    """(prefix, factor) that makes a number read well: ("k", 1e-3) of 2500."""
    for prefix, size in (("G", 1e9), ("M", 1e6), ("k", 1e3), ("", 1), ("m", 1e-3)):
        if high >= size:
            return prefix, 1 / size
    return ("µ", 1e6) if high > 0 else ("", 1)


def scale_of(low, high, stops=VIRIDIS):
    """Colours between two values."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    stops = np.array([rgb(colour) for colour in stops])
    for k in range(256):
        at = k / 255 * (len(stops) - 1)
        table.SetTableValue(k, *(np.interp(at, range(len(stops)), stops[:, c]) for c in range(3)), 1)
    table.SetTableRange(low, high if high > low else low + 1)
    table.SetNanColor(*NO_NUMBER, 1)
    return table


def legend(table, title, height, place, places):
    """A colour bar at the right edge. @param height of the picture [pixels] if it were 4:3; the bar is number `place` of `places` from above"""
    room = 0.9 / places
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(f"{title}\n")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    length = min(0.45, room - 0.08)
    bar.SetPosition(0.88, 0.94 - room * (place + 0.5) - length / 2)
    bar.SetWidth(0.09)
    bar.SetHeight(length)
    bar.SetBarRatio(0.25)
    bar.SetTextPad(height // 250)
    bar.UnconstrainedFontSizeOn()
    for style, size in ((bar.GetTitleTextProperty(), height // 46), (bar.GetLabelTextProperty(), height // 50)):
        style.SetColor(*TEXT)
        style.SetFontSize(size)
        style.ItalicOff()
        style.BoldOff()
        style.ShadowOff()
    return bar

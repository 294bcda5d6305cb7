# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what a run has written so far; a run in progress may be read."""
import contextlib
import json

import h5py
import numpy as np

from plotting.style import PlotError


class Column:
    """A quantity of /series with its units.

    values  array, one row an output interval; vectors have a second axis
    units   attribute of the dataset, SI
    """

    def __init__(self, values, units):
        self.values, self.units = values, units


@contextlib.contextmanager
def open_results(run):
    try:
        with h5py.File(run / "results.h5", "r", swmr=True, locking=False) as file:
            yield file
    except (OSError, KeyError) as error:
        raise PlotError(f"{run / 'results.h5'} cannot be read ({error}); give the directory of a run") from error


def read_series(file, names):
    """{name: Column} of those of `names` that the run has, cut to equally many rows."""
    series = file["series"]
    found = {name: Column(series[name][:], series[name].attrs.get("units", "")) for name in names if name in series}
    rows = min((len(column.values) for column in found.values()), default=0)
    for column in found.values():
        column.values = column.values[:rows]
    return found


def read_summary(run):
    """summary.json as a dictionary; empty where the run has none yet."""
    try:
        return json.loads((run / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def read_title(run):
    """Title of the case, which a run has from its start; else the name of the directory."""
    with open_results(run) as file:
        title = file["case"].attrs.get("title") if "case" in file else ""
    return title or run.name


def mean_over(time, values, span):
    """Means over whole spans of `span` seconds, and the middles of the spans."""
    rows = max(1, round(span / np.median(np.diff(time))))
    whole = len(time) // rows * rows
    if whole == 0:
        raise PlotError("--smooth is longer than the run; use a shorter time")
    return time[:whole].reshape(-1, rows).mean(axis=1), values[:whole].reshape(-1, rows).mean(axis=1)

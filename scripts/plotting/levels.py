# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost against change of results, from `cases/bench/levels/levels.py --json`: one row for each file, one panel for each figure.

Both are relative to the first setting of the file. Bars are standard errors from the differences seed by seed; the grey band is
5 % to each side."""
import json
import math
import statistics
from pathlib import Path

from plotting.style import BAND, COLOURS, PlotError, plt, save

FIGURES = (("mean_crushing_power", "crushing power"), ("broken", "broken bonds"), ("breakage", "breakage energy"), ("p80", "P80"))
WANTED = 5  # half width of the band [%]


def add_arguments(parser):
    parser.add_argument("results", type=Path, nargs="+", metavar="RESULTS.json")
    parser.add_argument("--out", type=Path, default=Path("levels.png"))


def read(file):
    """{setting: runs}, the first one the reference."""
    try:
        results = json.loads(file.read_text(encoding="utf-8"))
        complete = all(name in run for runs in results.values() for run in runs for name in ("cost", *dict(FIGURES)))
    except (OSError, ValueError, AttributeError, TypeError) as error:
        raise PlotError(f"{file} cannot be read ({error}); give the output of cases/bench/levels/levels.py --json") from error
    if not complete or len(results) < 2:
        raise PlotError(f"{file} has no two settings; give the output of cases/bench/levels/levels.py --json")
    return results


def change(runs, reference, name):
    """Mean change of a figure and its standard error [%]."""
    scale = statistics.mean(run[name] for run in reference) / 100
    pairs = [(a[name] - b[name]) / scale for a, b in zip(runs, reference)]
    return statistics.mean(pairs), statistics.stdev(pairs) / math.sqrt(len(pairs)) if len(pairs) > 1 else 0


def draw_row(axes, file):
    results = read(file)
    settings = list(results)
    reference = results[settings[0]]
    full = statistics.mean(run["cost"] for run in reference)
    for axis, (name, title) in zip(axes, FIGURES):
        axis.axvspan(-WANTED, WANTED, color=BAND, alpha=0.5, linewidth=0)
        axis.axvline(0, color="#888888", linewidth=0.6)
        for k, setting in enumerate(settings):
            off, error = change(results[setting], reference, name)
            cost = statistics.mean(run["cost"] for run in results[setting]) / full
            axis.errorbar([off], [cost], xerr=[error], fmt="o", color=COLOURS[k % len(COLOURS)],
                          label=setting.replace("numerics.", "") or "reference")
        axis.set(ylim=(0, 1.1), title=title, xlabel="change [%]")
    axes[0].set_ylabel(f"{file.stem}: cost / reference")


def draw(arguments):
    rows = len(arguments.results)
    figure, axes = plt.subplots(rows + 1, len(FIGURES), figsize=(11, 2.6 * rows + 0.8), sharex="all", sharey="row",
                                gridspec_kw={"height_ratios": [1] * rows + [0.25]})
    for row, file in zip(axes, arguments.results):
        draw_row(row, file)
    for axis in axes[:-1].flat:
        axis.tick_params(labelbottom=True)
    for axis in axes[-1]:  # room for the legend
        axis.axis("off")
    legend = axes[-1][0].legend(*axes[0][0].get_legend_handles_labels(), loc="upper left", ncol=2)
    legend.set_in_layout(False)  # wider than its panel
    save(figure, arguments.out)

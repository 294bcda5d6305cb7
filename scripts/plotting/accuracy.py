# SPDX-License-Identifier: GPL-3.0-or-later
"""Work against error from `gyrosim bench accuracy --json`: one row for each scene, one panel for each metric.

The grey band is the noise of the reference: a point inside it cannot be told from the reference. Bars are standard errors
over the seeds. Errors of 0, and errors below a thousandth of the noise, are drawn at the left edge as open marks."""
import json
from pathlib import Path

from plotting.style import BAND, COLOURS, PlotError, plt, save

MARKS = {"hold": "P-", "step": "o-", "step_double": "s--", "precision": "D", "substeps": "^:", "substeps_within": "v:", "window": "x-."}
NOTHING = 1e-3  # an error below this share of the noise is drawn as none
DENSE = {"axes.titlesize": 8, "axes.labelsize": 7, "xtick.labelsize": 6, "ytick.labelsize": 6, "legend.fontsize": 7,
         "lines.linewidth": 1, "savefig.dpi": 120}


def add_arguments(parser):
    parser.add_argument("bench", type=Path, metavar="BENCH.json")
    parser.add_argument("--out", type=Path, help="default: BENCH.png")


def read(file):
    """{scene: {metric: points}} in the order of the file. Settings that change no bit, and metrics that are names and not
    numbers, are left out."""
    try:
        points = json.loads(file.read_text(encoding="utf-8"))["points"]
    except (OSError, ValueError, KeyError) as error:
        raise PlotError(f"{file} cannot be read ({error}); give the output of `gyrosim bench accuracy --json`") from error
    panels = {}
    for point in points:
        drawn = point.get("against", "reference") == "reference" and point.get("family") != "identity"
        if drawn and point["error"] is not None:
            panels.setdefault(point["scene"], {}).setdefault(point["metric"], []).append(point)
    if not panels:
        raise PlotError(f"{file} has no points; give the output of `gyrosim bench accuracy --json`")
    return panels


def is_nothing(point):
    return point["error"] <= NOTHING * (point["noise"] or 0)


def left_edge(points):
    """Smallest error that the axis shows."""
    shown = [p["error"] for p in points if not is_nothing(p)] + [p["noise"] for p in points if p["noise"]]
    return min(shown) / 3 if shown else 1e-6


def draw_curve(axis, knob, points, edge):
    if knob in ("hold", "step", "window"):
        points = sorted(points, key=lambda p: p["value"])
    colour = COLOURS[list(MARKS).index(knob) % len(COLOURS)]
    errors = [max(p["error"], edge) for p in points]
    work = [p["seconds_per_simulated_second"] for p in points]
    spread = [[min(p["error_se"] or 0, 0.9 * e) for p, e in zip(points, errors)], [p["error_se"] or 0 for p in points]]
    axis.errorbar(errors, work, xerr=spread, fmt=MARKS[knob], elinewidth=0.6, color=colour, label=knob.replace("_", " "))
    for point, error, seconds in zip(points, errors, work):
        if is_nothing(point):
            axis.plot([error], [seconds], "o", markersize=7, fillstyle="none", color=colour)
        text = f"{1e3 * point['value']:g} ms" if knob == "window" else str(point["value"])
        axis.annotate(text, (error, seconds), fontsize=5, xytext=(3, 3), textcoords="offset points")


def draw_panel(axis, metric, points):
    edge = left_edge(points)
    for knob in MARKS:
        own = [p for p in points if p["knob"] == knob]
        if own:
            draw_curve(axis, knob, own, edge)
    axis.set(xscale="log", yscale="log", title=metric.replace("_", " "))
    axis.set_xlim(left=edge / 1.5)
    if points[0]["noise"]:
        axis.axvspan(edge / 1.5, points[0]["noise"], color=BAND, alpha=0.5, linewidth=0)


def draw(arguments):
    panels = read(arguments.bench)
    columns = max(len(metrics) for metrics in panels.values())
    with plt.rc_context(DENSE):
        figure, axes = plt.subplots(len(panels), columns, squeeze=False,
                                    figsize=(2.3 * columns, 2.5 * len(panels) + 0.5))
        for row, (scene, metrics) in zip(axes, panels.items()):
            for axis, (metric, points) in zip(row, metrics.items()):
                draw_panel(axis, metric, points)
            for axis in row[len(metrics):]:
                axis.set_visible(False)
            row[0].set_ylabel(f"{scene}\nprocessor s / simulated s")
        for axis in axes[-1]:
            axis.set_xlabel("error")
        named = {name: handle for axis in axes.flat for handle, name in zip(*axis.get_legend_handles_labels())}
        figure.legend(named.values(), named.keys(), loc="lower center", ncol=len(named))
        foot = 0.3 / figure.get_figheight()
        figure.get_layout_engine().set(rect=(0, foot, 1, 1 - foot))
        save(figure, arguments.out or arguments.bench.with_suffix(".png"))

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws work against error from `gyrosim bench accuracy --json`: one row a scene, one panel a metric.

Usage: plot_accuracy.py BENCH.json [--out FILE.png]

The grey band is the noise of the reference: a point inside it cannot be told from the reference. Bars are standard errors
over the seeds. Errors of 0, and those below a thousandth of the noise, are drawn at the left edge as open
marks. Needs python3-matplotlib.
"""
import argparse
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

CURVES = {"step": ("o-", "C0"), "step_double": ("s--", "C1"), "precision": ("D", "C2"), "substeps": ("^:", "C3"),
          "substeps_within": ("v:", "C4"), "window": ("x-.", "C5")}
NOTHING = 1e-3  # an error below this share of the noise is drawn as none


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws work against error.")
    parser.add_argument("bench", type=Path, metavar="BENCH.json")
    parser.add_argument("--out", type=Path, help="default: BENCH.png")
    return parser.parse_args()


def read(file):
    """Points by scene and metric, in the order of the file; no margins, which change nothing, and no names."""
    try:
        points = json.loads(file.read_text(encoding="utf-8"))["points"]
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot_accuracy.py: {file} cannot be read ({error}); what `gyrosim bench accuracy --json` prints is accepted")
    panels = {}
    for point in points:
        drawn = point.get("against", "reference") == "reference" and point.get("family") != "identity"
        if drawn and point["error"] is not None:
            panels.setdefault(point["scene"], {}).setdefault(point["metric"], []).append(point)
    return panels


def is_nothing(point):
    return point["error"] <= NOTHING * (point["noise"] or 0)


def left_edge(points):
    """Smallest error that the axis shows."""
    shown = [p["error"] for p in points if not is_nothing(p)] + [p["noise"] for p in points if p["noise"]]
    return min(shown) / 3 if shown else 1e-6


def draw(axis, metric, points, edge):
    for knob, (style, colour) in CURVES.items():
        own = [p for p in points if p["knob"] == knob]
        if not own:
            continue
        if knob in ("step", "window"):
            own.sort(key=lambda p: p["value"])
        errors = [max(p["error"], edge) for p in own]
        work = [p["seconds_per_simulated_second"] for p in own]
        spread = [[min(p["error_se"] or 0, 0.9 * e) for p, e in zip(own, errors)], [p["error_se"] or 0 for p in own]]
        line = axis.errorbar(errors, work, xerr=spread, fmt=style, markersize=4, linewidth=1, elinewidth=0.6,
                             color=colour, label=knob)
        zeros = [(e, w) for p, e, w in zip(own, errors, work) if is_nothing(p)]
        if zeros:
            axis.plot(*zip(*zeros), "o", markersize=7, fillstyle="none", color=line[0].get_color())
        for p, error, seconds in zip(own, errors, work):
            text = f"{1e3 * p['value']:g} ms" if knob == "window" else str(p["value"])
            axis.annotate(text, (error, seconds), fontsize=5, xytext=(3, 3), textcoords="offset points")
    noise = points[0]["noise"]
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_xlim(left=edge / 1.5)
    if noise:
        axis.axvspan(edge / 1.5, noise, color="#cccccc", alpha=0.5, linewidth=0)
    axis.set_title(metric.replace("_", " "), fontsize=8)
    axis.tick_params(which="both", labelsize=6)
    axis.grid(color="#dddddd", linewidth=0.5)


def main():
    arguments = parse_arguments()
    panels = read(arguments.bench)
    if not panels:
        sys.exit(f"plot_accuracy.py: {arguments.bench} has no points")
    columns = max(len(metrics) for metrics in panels.values())
    figure, axes = plt.subplots(len(panels), columns, figsize=(2.3 * columns, 2.5 * len(panels) + 0.5), squeeze=False)
    for row, (scene, metrics) in zip(axes, panels.items()):
        for axis, (metric, points) in zip(row, metrics.items()):
            draw(axis, metric, points, left_edge(points))
        for axis in row[len(metrics):]:
            axis.set_visible(False)
        row[0].set_ylabel(f"{scene}\nprocessor s / simulated s", fontsize=7)
    for axis in axes[-1]:
        axis.set_xlabel("error", fontsize=7)
    handles = {label: handle for row in axes for axis in row for handle, label in zip(*axis.get_legend_handles_labels())}
    figure.legend(handles.values(), handles.keys(), loc="lower center", ncol=len(handles), fontsize=7, frameon=False)
    figure.tight_layout(rect=(0, 0.4 / figure.get_figheight(), 1, 1))
    out = arguments.out or arguments.bench.with_suffix(".png")
    try:
        figure.savefig(out, dpi=120)
    except OSError as error:
        sys.exit(f"plot_accuracy.py: {out} cannot be written ({error.strerror})")
    print(out)


if __name__ == "__main__":
    main()

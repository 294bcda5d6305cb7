#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the steady figures of runs, each with its standard error.

    scripts/compare_runs.py [--limit L] RUNDIR RUNDIR...

Prints a table of the runs, and the largest difference of two of them in standard errors of that difference. Exit code 1
where a difference exceeds L (default 3), 2 where a run has no summary or is not steady.
"""
import argparse
import itertools
import json
import math
from pathlib import Path

import errors

FIGURES = (("throughput_tph", "throughput [t/h]", 1), ("crushing_power", "crushing power [kW]", 1e-3),
           ("p80", "P80 [mm]", 1e3), ("p50", "P50 [mm]", 1e3), ("specific_energy_kwh_per_t", "specific energy [kWh/t]", 1))


def summary_of(run):
    """summary.json of a steady run."""
    try:
        summary = json.loads(Path(run, "summary.json").read_text())
    except (OSError, ValueError) as problem:
        errors.fail(f"{run} has no summary of a run ({problem}); give the directory of a run that has ended")
    if not summary.get("steady"):
        errors.fail(f"{run} is not steady ({summary.get('not_steady')}); run it longer, with --until steady")
    return summary


def difference(a, b):
    """The difference of two (value, error) in standard errors."""
    error = math.hypot(a[1], b[1])
    return abs(a[0] - b[0]) / error if error > 0 else (0 if a[0] == b[0] else math.inf)


def rows_of(runs):
    """Cells of the table, and the largest difference."""
    summaries = [summary_of(run) for run in runs]
    rows = [["", *(Path(run).name for run in runs), "largest difference / its error"]]
    plain = lambda name, get, form: rows.append([name, *(format(get(s), form) for s in summaries), ""])
    plain("simulated [s]", lambda s: s["simulated_seconds"], ".2f")
    plain("steady from [s]", lambda s: s["steady"]["from"], ".2f")
    plain("gyrations since", lambda s: s["steady"]["gyrations"], "d")
    plain("hold-up at the end [kg]", lambda s: s["holdup_mass"], ".4g")
    worst = 0
    for key, name, scale in FIGURES:
        values = [(s["steady"].get(key), s["steady"].get(key + "_error")) for s in summaries]
        if any(value is None or error is None for value, error in values):
            continue
        apart = max(difference(a, b) for a, b in itertools.combinations(values, 2))
        worst = max(worst, apart)
        rows.append([name, *(f"{scale * v:.4g} +- {scale * e:.2g}" for v, e in values), f"{apart:.1f}"])
    plain("wall time [s]", lambda s: s["wall_seconds"], ".0f")
    return rows, worst


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=float, default=3, metavar="L")
    parser.add_argument("runs", nargs="+", metavar="RUNDIR")
    arguments = parser.parse_args()
    if len(arguments.runs) < 2:
        errors.fail("there is one run; give at least two")
    rows, worst = rows_of(arguments.runs)
    for number, row in enumerate(rows):
        print("| " + " | ".join(row) + " |")
        if number == 0:
            print("|" + "---|" * len(row))
    if worst > arguments.limit:
        print(f"the runs differ: {worst:.1f} standard errors, more than {arguments.limit:g}")
        raise SystemExit(1)
    print(f"the runs agree within {arguments.limit:g} standard errors")


if __name__ == "__main__":
    main()

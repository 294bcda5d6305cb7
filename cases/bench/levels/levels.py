#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What levels of detail change in a case, and what they save (README.md has the tables).

  levels.py CASE [--settings "SETTING" ...] [--set KEY=VALUE] [--seeds 8] [--until "1 s"] [--jobs 2] [--program build/release/gyrosim]

Each setting is a list of KEY=VALUE, divided by semicolons; the first one is the reference and may be empty. All run with
the seeds 1, 2, ... Of each figure the mean over the seeds is printed, and the difference from the reference in percent of
its mean, with its standard error from the differences seed by seed. rigid: particles in rigid rocks, mean over the run.
switched: energy lost where rocks became rigid, in parts of the work of the walls. cost: user seconds of a run, set-up included.

Needs python3-h5py and python3-numpy.
"""
import argparse
import json
import math
import os
import pathlib
import statistics
import sys

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "cases" / "bench"))
import seeds

SETTINGS = ("", "numerics.levels={rigid: rocks}", "numerics.levels={rigid: pieces, bonded_above: 0.3}",
            "numerics.fidelity=engineering")
FIGURES = (("mean_crushing_power", "crushing power [kW]", 1e-3), ("broken", "broken bonds [%]", 100),
           ("discharged_mass", "product [kg]", 1), ("p80", "P80 [mm]", 1e3), ("breakage", "breakage [J]", 1))


def figures(run):
    summary = json.loads((run / "summary.json").read_text())
    with h5py.File(run / "results.h5", "r") as file:
        series, ledger = file["series"], file["ledger"]
        rigid = series["rigid_particles"][:] / series["particles"][:] if "rigid_particles" in series else [0.0]
        switched = float(ledger["switched"][-1] / ledger["wall_work"][-1]) if "switched" in ledger else 0.0
        breakage = float(ledger["bond_breakage"][-1])
    return {"mean_crushing_power": summary["mean_crushing_power"], "discharged_mass": summary["discharged_mass"],
            "p80": summary["p80"] or math.nan, "broken": summary["bonds_broken"] / summary["bonds_initial"],
            "breakage": breakage, "rigid": float(sum(rigid) / len(rigid)), "switched": switched,
            "residual": summary["energy_residual_fraction"], "stalled": bool(summary["stalled"])}


def one_run(arguments, setting, seed, out):
    changes = [part.strip() for part in setting.split(";") if part.strip()]
    cost = seeds.run_case(arguments.program, arguments.case, [f"case.seed={seed}", *arguments.set, *changes], out,
                          ["--until", arguments.until] if arguments.until else [])
    return None if cost is None else {**figures(out), "cost": cost}


def print_table(results, settings):
    print("| setting | " + " | ".join(title for _, title, _ in FIGURES) +
          " | stalled | residual [% of work] | switched | rigid | cost [s] |")
    print("|---" * (len(FIGURES) + 6) + "|")
    for setting in settings:
        runs = results[setting]
        cells = [f"`{setting}`" if setting else "reference"]
        for name, _, unit in FIGURES:
            values = [unit * r[name] for r in runs]
            text = f"{statistics.mean(values):.3g}"
            if setting != settings[0]:
                off, error = seeds.difference(values, [unit * r[name] for r in results[settings[0]]])
                text += f" ({off:+.1f} +- {error:.1f} %)"
            cells.append(text)
        cells += [f"{sum(r['stalled'] for r in runs)} of {len(runs)}", f"{100 * max(abs(r['residual']) for r in runs):.2f}",
                  f"{max(abs(r['switched']) for r in runs):.0e}", f"{statistics.mean(r['rigid'] for r in runs):.2f}",
                  f"{statistics.mean(r['cost'] for r in runs):.1f}"]
        print("| " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case")
    parser.add_argument("--settings", nargs="+", default=SETTINGS, metavar="SETTING")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="in all runs")
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--until")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--program", default=str(ROOT / "build" / "release" / "gyrosim"))
    parser.add_argument("--json", metavar="FILE", help="writes the figures of every run")
    arguments = parser.parse_args()
    results = seeds.over_seeds(arguments.settings, arguments.seeds, arguments.jobs,
                               lambda setting, seed, out: one_run(arguments, setting, seed, out))
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(results, indent=1))
    print_table(results, arguments.settings)
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws pictures of runs and benchmarks, all in one style.

Usage:
  plot.py series RUNDIR                        speed, power, broken bonds, masses over time
  plot.py curves RUNDIR [--from SECONDS]       size curves of feed, chamber and product, P80, side settings
  plot.py wear RUNDIR [--from SECONDS]         wear of the liners in mm per 1000 h, unrolled
  plot.py machine RUNDIR [--from SECONDS]      torque over angle, radial force, maps of the liners
  plot.py drives RUNDIR... [--smooth SECONDS]  speed and power of several runs
  plot.py accuracy BENCH.json                  work against error
  plot.py levels RESULTS.json...               cost against change of results by levels of detail
  plot.py library LIBRARY.json                 particles and bonds of rock libraries

--out FILE.png (or .svg, .pdf) names the picture; `plot.py COMMAND --help` has all options. Needs python3-matplotlib,
python3-h5py and python3-yaml. A run that goes on or was killed can be drawn as far as it got.
"""
import argparse
import importlib
import sys

from errors import fail, need

COMMANDS = {
    "series": "speed, power, broken bonds and masses of a run over time",
    "curves": "size curves of feed, chamber and product, with P80 and side settings",
    "wear": "wear of the liners in mm per 1000 h, unrolled",
    "machine": "torque over angle, radial force and maps of the liners of a run",
    "drives": "speed and power of several runs over time",
    "accuracy": "work against error of a benchmark",
    "levels": "cost against change of results by levels of detail",
    "library": "particles and bonds of rock libraries, beside the reference paper",
}


def main():
    if sys.argv[1:2] in (["-h"], ["--help"]):  # also before the packages are installed
        print(__doc__)
        return
    need("numpy", "matplotlib", "h5py", "yaml")
    from plotting import style
    parser = argparse.ArgumentParser(description="Draws pictures of runs and benchmarks.")
    commands = parser.add_subparsers(dest="command", required=True)
    modules = {name: importlib.import_module(f"plotting.{name}") for name in COMMANDS}
    for name, module in modules.items():
        module.add_arguments(commands.add_parser(name, help=COMMANDS[name], description=module.__doc__))
    arguments = parser.parse_args()
    style.use_style()
    try:
        modules[arguments.command].draw(arguments)
    except style.PlotError as error:
        fail(f"{arguments.command}: {error}")


if __name__ == "__main__":
    main()

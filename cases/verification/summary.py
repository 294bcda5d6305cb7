#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what a probe has at the end of a run: ./summary.py RUNDIR [ID] (needs python3-h5py)."""
import sys

import h5py

run, probe = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "0"
with h5py.File(f"{run}/results.h5", swmr=True) as file:
    series = file["series"]
    print("time", series["time"][-1], "s")
    for quantity in "position", "velocity", "spin":
        data = series[f"probe_{probe}_{quantity}"]
        print(quantity, *(f"{x:.6g}" for x in data[-1]), data.attrs["units"])

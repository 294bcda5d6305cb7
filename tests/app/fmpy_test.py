#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Another master runs the exported drivetrain: FMPy validates the FMU and gets the motion that gyrosim gets.

Usage: fmpy_test.py GYROSIM CASE    Exit code 77, skipped, without PyPI's fmpy.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import fmpy
    import h5py
    import numpy
    from fmpy.validation import validate_fmu
except ImportError as missing:
    print(f"skipped: {missing} (pip install fmpy h5py)")
    sys.exit(77)

gyrosim, case = sys.argv[1:3]
end, window, row = 1.0, 0.5e-3, 10e-3
with tempfile.TemporaryDirectory() as place:
    fmu, run = str(Path(place, "drive.fmu")), str(Path(place, "run"))
    subprocess.run([gyrosim, "export", "fmu", case, "--out", fmu], check=True)
    problems = validate_fmu(fmu)
    print("validate_fmu:", problems)
    subprocess.run([gyrosim, "run", case, "--until", f"{end} s", "--out", run, "--threads", "1", "--quiet"], check=True)
    with h5py.File(Path(run, "results.h5")) as results:
        series = {name: results["series"][name][()] for name in ("time", "eccentric_angle", "motor_speed", "motor_power")}
    names = ["eccentric_angle", "eccentric_speed", "motor_speed", "motor_work"]
    got = fmpy.simulate_fmu(fmu, stop_time=end, output_interval=window, output=names)

every = round(row / window)
at_rows = got[::every]


def error(mine, theirs):
    return numpy.max(numpy.abs(mine - theirs)) / numpy.max(numpy.abs(theirs))


errors = {
    "eccentric_angle": error(series["eccentric_angle"], at_rows["eccentric_angle"][1:]),
    "motor_speed": error(series["motor_speed"], at_rows["motor_speed"][1:]),
    "motor_power": error(series["motor_power"], numpy.diff(at_rows["motor_work"]) / row),
}
print("rows:", len(series["time"]), "relative errors:", errors)
moved = at_rows["eccentric_speed"][-1] > 1
sys.exit(0 if not problems and moved and max(errors.values()) < 1e-9 else 1)

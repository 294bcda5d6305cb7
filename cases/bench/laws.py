#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the contact laws err by at a time step, and what they cost (README.md has the tables).

  laws.py error [--program build/release/gyrosim]    errors of an impact and of a ball that rolls to a stop
  laws.py cost [--repeats 3]                         user seconds of a bed of 2000 spheres on one thread

Needs python3-h5py and python3-yaml.
"""
import argparse
import pathlib
import random
import re
import resource
import subprocess
import tempfile

import h5py
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
FRACTIONS = (0.7, 0.35, 0.175, 0.0875)  # of the limit of the step
REFERENCE = 0.005  # of the limit: for what has no closed form
PHASES = 20  # steps up to 5 % shorter: the contact begins at another moment of a step
STOPPED = 4  # exit code of a run whose energy does not balance within 5 %
ROUND = 10  # steps in a coupling interval


def run(program, command, case, settings):
    arguments = [program, command, str(case)]
    for key, value in settings.items():
        arguments += ["--set", f"{key}={value}"]
    if command == "run":
        arguments += ["--quiet", "--threads", "1", "--out", str(case.parent / "out"), "--overwrite"]
    done = subprocess.run(arguments, capture_output=True, text=True)
    if done.returncode == STOPPED:
        return None
    if done.returncode:
        raise SystemExit(f"laws.py: {' '.join(arguments)}\n{done.stdout}{done.stderr}")
    return done.stdout


def both(wall, key, value):
    """A property of rock with rock and of rock with a wall."""
    return {f"contacts.rock/{other}.{key}": value for other in ("rock", wall)}


def limit(program, case, settings):
    """Limit of the step [s]."""
    value, unit = re.search(r"^step .*limit ([0-9.]+) (us|ms)", run(program, "check", case, settings), re.M).groups()
    return float(value) * {"us": 1e-6, "ms": 1e-3}[unit]


def last_row(program, case, settings, step, duration):
    """Position and velocity of the probe at the end of a run, in steps of whole nanoseconds; None if it was stopped."""
    ns = round(1e9 * step)
    row = max(1, round(1e9 * duration / (20 * ROUND * ns)))  # intervals in a row
    lengths = {
        "time.step": ns,
        "coupling.interval": ROUND * ns,
        "output.series": ROUND * ns * row,
        "time.duration": ROUND * ns * row * max(1, round(1e9 * duration / (ROUND * ns * row))),
    }
    given = settings | {key: f"{value / 1000:.3f} us" for key, value in lengths.items()} | {"time.safety": 1}
    if run(program, "run", case, given) is None:
        return None
    with h5py.File(case.parent / "out" / "results.h5") as file:
        series = file["series"]
        return series["probe_0_position"][-1], series["probe_0_velocity"][-1]


def worst(program, case, settings, duration, error):
    """Largest error over the phases and number of stopped runs, for each fraction of the limit."""
    whole = limit(program, case, settings)
    row = []
    for fraction in FRACTIONS:
        steps = [fraction * whole * (1 - 0.05 * k / PHASES) for k in range(PHASES)]
        ends = [last_row(program, case, settings, step, duration) for step in steps]
        row.append((max((abs(error(*end)) for end in ends if end), default=float("nan")), ends.count(None)))
    return whole, row


def errors(options, folder):
    source = ROOT / "cases/verification"
    for name in "impact", "rolling-stop":
        for suffix in ".yaml", ".csv":
            (folder / (name + suffix)).write_bytes((source / (name + suffix)).read_bytes())
    for restitution in 0.5, 0.2:
        for law in "hertz", "hysteretic":
            settings = both("wall", "normal", law) | both("wall", "restitution", restitution)
            show(
                f"rebound at e = {restitution}, {law}",
                worst(options.program, folder / "impact.yaml", settings, 4e-3,
                      lambda x, v, e=restitution: v[2] / 0.2 / e - 1),
            )
    for law in "constant", "spring_dashpot":
        settings = both("wall", "rolling", law)
        case = folder / "rolling-stop.yaml"
        exact, _ = last_row(options.program, case, settings, REFERENCE * limit(options.program, case, settings), 1)
        show(
            f"path of the stop, {law} (reference {exact[0]:.6g} m)",
            worst(options.program, case, settings, 1, lambda x, v, to=exact[0]: x[0] / to - 1),
        )


def show(name, result):
    whole, row = result
    print(f"{name}: limit {1e6 * whole:.4g} us, errors " + ", ".join(f"{error:.2g} ({stopped} stopped)" for error, stopped in row), flush=True)


def write_bed(folder):
    """2000 spheres of 8 to 12 mm radius, close above one another, in a box of 0.3 m."""
    case = yaml.safe_load((ROOT / "cases/box.yaml").read_text())
    for name, point in {"left": -0.15, "right": 0.15}.items():
        case["walls"][name]["plane"]["point"] = [point, 0, 0]
    for name, point in {"front": -0.15, "back": 0.15}.items():
        case["walls"][name]["plane"]["point"] = [0, point, 0]
    case["time"] = {"duration": "0.4 s", "step": "20 us"}
    case["coupling"] = {"interval": "1 ms"}
    case["particles"] = {"file": "bed.csv"}
    case["output"] = {"series": "100 ms", "snapshots": 0}
    (folder / "bed.yaml").write_text(yaml.safe_dump(case))
    random.seed(1)
    pitch, side = 0.0245, 12
    with open(folder / "bed.csv", "w", encoding="utf-8") as file:
        file.write("id,x,y,z,r,vx,vy,vz\n")
        for k in range(2000):
            place = [(n - (side - 1) / 2) * pitch for n in (k % side, k // side % side)]
            place.append((k // side**2 + 0.6) * pitch)
            x, y, z = (p + random.uniform(-2e-4, 2e-4) for p in place)
            file.write(f"{k},{x:.6f},{y:.6f},{z:.6f},{random.uniform(0.008, 0.012):.6f},0,0,-0.5\n")
    return folder / "bed.yaml"


def costs(options, folder):
    case = write_bed(folder)
    laws = [(normal, rolling) for normal in ("hertz", "hysteretic") for rolling in ("constant", "spring_dashpot")]
    spent = {law: [] for law in laws}
    for _ in range(options.repeats):
        for normal, rolling in laws:
            settings = both("steel", "normal", normal) | both("steel", "rolling", rolling)
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            run(options.program, "run", case, settings)
            spent[normal, rolling].append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    base = sorted(spent[laws[0]])[options.repeats // 2]
    for law, seconds in spent.items():
        middle = sorted(seconds)[options.repeats // 2]
        print(f"{law[0]} and {law[1]}: {' '.join(f'{s:.2f}' for s in seconds)} s, median over the first {middle / base:.3f}")


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("what", choices=("error", "cost"))
    ask.add_argument("--program", default=str(ROOT / "build/release/gyrosim"), help="default: %(default)s")
    ask.add_argument("--repeats", type=int, default=3)
    options = ask.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        {"error": errors, "cost": costs}[options.what](options, pathlib.Path(folder))


if __name__ == "__main__":
    main()

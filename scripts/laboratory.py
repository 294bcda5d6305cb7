#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laboratory tests over several seeds, and bond parameters fitted to laboratory values.

Usage:
  laboratory.py measure CASE... [--seeds N] [--jobs N] [--set KEY=VALUE]...
  laboratory.py fit [--ucs MPA] [--bts MPA] [--lump MPA] [--modulus GPA] [--seeds N] [--rounds N] [--set KEY=VALUE]...

`measure` runs each case with seeds 1 to N and prints every figure of the test with mean and standard deviation.

`fit` searches for bond strengths and stiffnesses with which the laboratory cases give the wanted values: --ucs and
--modulus from cases/laboratory/uniaxial.yaml, --bts (indirect tensile strength) from brazilian.yaml, --lump (0.9 F/d^2 of
an irregular lump) from platen.yaml.

In a slow test without gravity only ratios of stresses matter. If strengths, stiffnesses and the contact moduli, those of the
plates included, are all multiplied by y, all measured stresses are too. So the search has one unknown: the factor x on both
bond strengths of the case, at the case's stiffness, with which measured strength / modulus has the wanted ratio. Then all
stresses are multiplied by y = wanted / measured modulus. This fits rock as stiff as granite at the cost of the case's soft
rock. Without --modulus, y is 1 and x makes the strength itself right.

The search is a fixed-point iteration in logarithms: x <- x (wanted/measured)^(1/p), p = d log(measured)/d log(x). p is 1 at
first and then follows from the last two rounds, within 0.3 to 3. If several strengths are wanted, the mean of their
logarithms is fitted and the remaining difference of each is printed, because bonded spheres have a fixed ratio of
compressive to tensile strength. The ratio of the two bond strengths is that of the case of the first wanted strength; --set
changes it.

At the end the cases run once more with the result, without scaling, for the first two seeds. Their plates are y times as
stiff as steel: plates of real steel would sink into such rock, and because displacements are measured at the plates, the
rock would seem a third softer.

While runs go on, standard error says how many are done. Exit codes: 2 for arguments that cannot be used, 1 for a search that
found nothing or a run that failed.

Needs Python 3 and gyrosim, which is looked for in build/release and, when installed, in bin; --gyrosim names another.
"""
import argparse
import json
import math
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASES = ROOT / "cases" / "laboratory"
# In a checkout; installed, where ROOT is share/gyrosim.
PROGRAMS = (ROOT / "build" / "release" / "gyrosim", ROOT.parent.parent / "bin" / "gyrosim")
FIGURES = [("first_break_force", "first break", "N", 1), ("failure_force", "failure", "N", 1),
           ("failure_displacement", "at", "mm", 1e3), ("strength", "strength", "MPa", 1e-6),
           ("stiffness", "stiffness", "MN/m", 1e-6), ("modulus", "modulus", "GPa", 1e-9)]
STRENGTHS = ("bonds.tensile_strength", "bonds.shear_strength")
STIFFNESSES = ("bonds.normal_stiffness", "bonds.shear_stiffness", "bonds.modulus", "materials.rock.shear_modulus")
PLATES = "materials.steel.shear_modulus"
DURATION = "time.duration"


def number_above_zero(text):
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not (number > 0 and math.isfinite(number)):
        raise argparse.ArgumentTypeError(f"'{text}' is not a number above 0")
    return number


def count(text):
    if not (text.isascii() and text.isdigit() and 0 < int(text) <= 10000):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number between 1 and 10000")
    return int(text)


def setting(text):
    key, equals, value = text.partition("=")
    if not (key and equals and value):
        raise argparse.ArgumentTypeError(f"'{text}' is not an override; write key.path=value")
    return text


def case_file(text):
    if not Path(text).is_file():
        raise argparse.ArgumentTypeError(f"there is no case file '{text}'")
    return Path(text)


def parse_arguments():
    parser = argparse.ArgumentParser(description="Laboratory tests of bonded rock.")
    parser.add_argument("--gyrosim", type=Path, default=next(filter(Path.exists, PROGRAMS), PROGRAMS[0]))
    commands = parser.add_subparsers(dest="command", required=True)
    measure = commands.add_parser("measure", help="figures of laboratory cases over seeds")
    measure.add_argument("cases", type=case_file, nargs="+", metavar="CASE")
    fit = commands.add_parser("fit", help="bond parameters from laboratory values")
    fit.add_argument("--ucs", type=number_above_zero, help="uniaxial compressive strength [MPa]")
    fit.add_argument("--bts", type=number_above_zero, help="tensile strength of the Brazilian test [MPa]")
    fit.add_argument("--lump", type=number_above_zero, help="strength of irregular lumps, 0.9 F/d^2 [MPa]")
    fit.add_argument("--modulus", type=number_above_zero, help="modulus of the uniaxial test [GPa]")
    fit.add_argument("--rounds", type=count, default=5, help="rounds of the search, at most")
    fit.add_argument("--tolerance", type=number_above_zero, default=0.1, help="relative difference at which the search ends; seeds scatter by 15 %%")
    for command, seeds in ((measure, 5), (fit, 4)):
        command.add_argument("--seeds", type=count, default=seeds)
        command.add_argument("--jobs", type=count, default=2, help="runs at the same time, each on one thread")
        command.add_argument("--set", type=setting, action="append", default=[], metavar="KEY=VALUE", help="as for gyrosim run")
    arguments = parser.parse_args()
    if not arguments.gyrosim.is_file():
        parser.error(f"there is no program {arguments.gyrosim}; build it with scripts/build.sh, or name it with --gyrosim")
    if arguments.command == "fit" and not (arguments.ucs or arguments.bts or arguments.lump):
        fit.error("no strength is given; use --ucs, --bts or --lump, with or without --modulus")
    return arguments


class Progress:
    """How many runs of a set are done, on standard error: one line that changes on a terminal, otherwise a line a run."""

    def __init__(self, total):
        self.total, self.done, self.begin, self.lock = total, 0, time.monotonic(), threading.Lock()
        self.terminal = sys.stderr.isatty()

    def one_more(self, _):
        with self.lock:
            self.done += 1
            seconds = time.monotonic() - self.begin
            left = seconds / self.done * (self.total - self.done)
            line = f"{self.done} of {self.total} runs, {seconds:.0f} s, about {left:.0f} s left"
            end = "\n" if not self.terminal or self.done == self.total else ""
            print(f"\r{line:60}" if self.terminal else line, end=end, file=sys.stderr, flush=True)


def run(arguments, case, seed, settings):
    """The laboratory part of summary.json of one run."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "run"
        command = [str(arguments.gyrosim), "run", str(case), "--out", str(out), "--quiet", "--threads", "1",
                   "--set", f"case.seed={seed}", "--set", "output.snapshots=0"]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"laboratory.py: {' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
        figures = json.loads((out / "summary.json").read_text())["laboratory"]
    if figures is None:
        sys.exit(f"laboratory.py: {case} has no section `laboratory`; use a case like those in cases/laboratory")
    return figures


def measure(arguments, cases, settings, max_seeds=None, durations=None):
    """Figures of each case for all seeds; `durations` by case, in s, where they are not the case's own."""
    seeds = min(arguments.seeds, max_seeds or arguments.seeds)
    with ThreadPoolExecutor(arguments.jobs) as pool:
        own = {case: settings + ([f"time.duration={durations[case]:.4g}"] if durations else []) for case in cases}
        runs = {case: [pool.submit(run, arguments, case, seed, own[case]) for seed in range(1, seeds + 1)]
                for case in cases}
        progress = Progress(seeds * len(runs))
        for of_case in runs.values():
            for one in of_case:
                one.add_done_callback(progress.one_more)
        return {case: [r.result() for r in of_case] for case, of_case in runs.items()}


def spread(runs, name):
    """Values of a figure, without the runs that have none."""
    return [r[name] for r in runs if r[name] is not None]


def print_figures(case, runs):
    print(f"{case}: {runs[0]['test']}, {len(runs)} seeds")
    for name, label, unit, scale in FIGURES:
        values = [scale * v for v in spread(runs, name)]
        if not values:
            continue
        mean = statistics.mean(values)
        deviation = statistics.stdev(values) if len(values) > 1 else math.nan
        rows = " ".join(f"{v:.4g}" for v in values)
        print(f"  {label:12} {mean:8.4g} +- {deviation:.3g} {unit} ({100 * deviation / mean:.0f} %):  {rows}")
    held = sum(r["failure_force"] is None for r in runs)
    if held:
        print(f"  {held} of {len(runs)} did not fail before the end")


class Unknown:
    """A factor that is varied until a measured value is the wanted one."""

    def __init__(self):
        self.factor, self.trace = 1.0, []

    def learn(self, ratio):
        """Records measured/wanted at the present factor and moves to the next factor."""
        self.trace.append((math.log(self.factor), math.log(ratio)))
        power = 1.0
        if len(self.trace) > 1:
            (x0, y0), (x1, y1) = self.trace[-2:]
            if abs(x1 - x0) > 1e-3:
                power = min(3.0, max(0.3, (y1 - y0) / (x1 - x0)))
        self.factor *= math.exp(-math.log(ratio) / power)


def numbers_of(arguments, case):
    """Strengths and stiffnesses of the case with its settings, from the resolved case that `check` prints."""
    command = [str(arguments.gyrosim), "check", str(case)]
    for setting in arguments.set:
        command += ["--set", setting]
    checked = subprocess.run(command, capture_output=True, text=True)
    if checked.returncode != 0:
        sys.exit(f"laboratory.py: {case}:\n{checked.stderr}")
    found, path = {}, []
    for line in checked.stdout.splitlines():
        key, colon, value = line.strip().partition(":")
        if not colon:
            continue
        path = path[:(len(line) - len(line.lstrip())) // 2] + [key]
        name = ".".join(path)
        if name in STRENGTHS + STIFFNESSES + (PLATES, DURATION):
            found[name] = float(value)
    return found


def settings_of(numbers, strength, stiffness):
    return {key: value * (strength if key in STRENGTHS else stiffness) for key, value in numbers.items()
            if key != DURATION}


def wanted_strengths(arguments):
    """(case, SI value, label) of the strengths that are asked for."""
    asked = ((arguments.ucs, "uniaxial"), (arguments.bts, "brazilian"), (arguments.lump, "platen"))
    return [(CASES / f"{case}.yaml", value * 1e6, case) for value, case in asked if value is not None]


def mean_of(runs, case, figure):
    values = spread(runs[case], figure)
    if not values:
        sys.exit(f"laboratory.py fit: no run of {case} failed; a longer time.duration may help")
    return statistics.mean(values)


def fit(arguments):
    wanted = wanted_strengths(arguments)
    uniaxial = CASES / "uniaxial.yaml"
    cases = {case for case, _, _ in wanted} | ({uniaxial} if arguments.modulus else set())
    numbers = numbers_of(arguments, wanted[0][0])
    ends = {case: numbers_of(arguments, case)[DURATION] for case in cases}
    strength = Unknown()
    for round_number in range(1, arguments.rounds + 1):
        overrides = arguments.set + [f"{key}={numbers[key] * strength.factor:.6g}" for key in STRENGTHS]
        durations = {case: end * max(1, strength.factor) for case, end in ends.items()}  # stronger rock fails later
        runs = measure(arguments, cases, overrides, durations=durations)
        scale = arguments.modulus * 1e9 / mean_of(runs, uniaxial, "modulus") if arguments.modulus else 1.0
        print(f"round {round_number}: strengths of the case x {strength.factor:.4g}, then all stresses x {scale:.4g}")
        logarithms = []
        for case, value, label in wanted:
            measured = scale * mean_of(runs, case, "strength")
            logarithms.append(math.log(measured / value))
            print(f"  {label}: {measured / 1e6:.4g} MPa, wanted {value / 1e6:.4g}", flush=True)
        ratio = math.exp(statistics.mean(logarithms))
        if abs(math.log(ratio)) < arguments.tolerance:
            print("found:")
            found = [f"{key}={value:.4g}" for key, value in settings_of(numbers, strength.factor * scale, scale).items()]
            for setting in found:
                if not setting.startswith(PLATES):
                    print(f"  --set {setting}", flush=True)
            for case, of_case in measure(arguments, sorted(cases), arguments.set + found, 2, durations).items():
                print_figures(case, of_case)
            return
        strength.learn(ratio)
    sys.exit(f"laboratory.py fit: not within {arguments.tolerance:.0%} after {arguments.rounds} rounds; the last "
             "round is printed above; more --rounds or --seeds may help")


def main():
    arguments = parse_arguments()
    if arguments.command == "fit":
        fit(arguments)
        return
    for case, runs in measure(arguments, arguments.cases, arguments.set).items():
        print_figures(case, runs)


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of gyrosim, LAMMPS and LIGGGHTS on one core."""
import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path

from states import State

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from errors import fail  # noqa: E402: beside this folder


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown processor"


def processor_time():
    """Of all programs that have ended [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def call(arguments, command):
    """Output of a program on one core, and the share of the time in which it had the core."""
    core = arguments.core if arguments.core is not None else max(os.sched_getaffinity(0))
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    begin, before = time.monotonic(), processor_time()
    try:
        done = subprocess.run(["taskset", "-c", str(core), *command], capture_output=True, text=True, env=environment)
    except FileNotFoundError as missing:
        fail(f"{missing.filename} is not there; install util-linux")
    if done.returncode:
        fail(f"{' '.join(command)} failed ({done.returncode}):\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout, min(1.0, (processor_time() - before) / (time.monotonic() - begin))


def of_gyrosim(arguments, scene, *more):
    command = [arguments.gyrosim, "bench", "speed", "--scene", scene, "--states", arguments.states]
    if arguments.seed is not None:
        command += ["--seed", str(arguments.seed)]
    if arguments.particles is not None:
        command += ["--particles", str(arguments.particles)]
    return call(arguments, [*command, *more])[0]


def state_of(arguments, scene):
    """The start state of a scene, made if it is not there yet."""
    return State(of_gyrosim(arguments, scene, "--states-only").strip())


def run_gyrosim(arguments, scene, precision):
    """A measurement as `bench speed --json` gives it."""
    return json.loads(of_gyrosim(arguments, scene, "--threads", "1", "--precision", precision, "--json"))["scenes"][0]


def numbers(line):
    try:
        return [float(word) for word in line.split()]
    except ValueError:
        return []


def run_peer(arguments, program, script, variables):
    """Processor time of the last run of an input file [s], and the kinetic energy at its end [J]."""
    command = [program, "-log", "none", "-in", str(script)]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    text, share = call(arguments, command)
    lines = text.splitlines()
    last = max((n for n, line in enumerate(lines) if line.startswith("Loop time of")), default=None)
    rows = [numbers(line) for line in lines[:last] if len(numbers(line)) >= 3] if last else []
    if not rows:
        fail(f"{program} ran {script} without a table of energies:\n{text[-2000:]}")
    return float(lines[last].split()[3]) * share, rows[-1][1]

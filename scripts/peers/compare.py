#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of gyrosim beside LAMMPS and LIGGGHTS on the same start states, one core, and whether both compute the same.

Usage: compare.py [--scene S]... [--rounds N] [--seed N] [--particles N] [--states DIR] [--core N] [--gyrosim PROGRAM]
                  [--lmp PROGRAM] [--liggghts PROGRAM] [--json]

scripts/compare_peers.sh installs the peers and calls this. In each round the peer and gyrosim in double and in mixed
precision run one after the other, so that what disturbs the machine disturbs all. Times are processor times of the timed
steps. A ratio is gyrosim's speed over the peer's in the same round; the table has the median and the smallest and largest.

Both programs must end with the same kinetic energy of translation, within the tolerance of the pair; the difference is taken
over the larger of the energies at the start and at the end (tests/bench/README.md). Exit code 1 when one does not, 2 for arguments that cannot be used.
"""
import argparse
import json
import statistics
import sys
import tempfile
from pathlib import Path

import programs
import scenes

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from errors import fail  # noqa: E402: beside this folder

PRECISIONS = ("double", "mixed")


def spread(values):
    return f"{statistics.median(values):.2f} [{min(values):.2f} .. {max(values):.2f}]"


def rounds_of(pair, state, arguments, folder):
    """Rates in steps of one particle per second by program, and energies, of all rounds of a pair."""
    rates, energies = {name: [] for name in ("peer", *PRECISIONS)}, {}
    for _ in range(1 if pair.once else arguments.rounds):
        seconds, energies["peer"] = pair.run(state, arguments, folder)
        steps = len(state.particles) * state.scene["timed"]
        rates["peer"].append(steps / seconds)
        for precision in PRECISIONS:
            measured = programs.run_gyrosim(arguments, pair.scene, precision)
            rates[precision].append(measured["particle_steps_per_second"])
            energies[precision] = measured["kinetic_energy"]
    return rates, energies


def result_of(pair, state, rates, energies):
    scale = max(state.kinetic_energy(), energies["peer"])
    off = {p: (energies[p] - energies["peer"]) / scale for p in PRECISIONS}
    return {
        "scene": pair.scene,
        "peer": pair.peer,
        "peer_rates": rates["peer"],
        "rates": {p: rates[p] for p in PRECISIONS},
        "ratios": {p: [ours / theirs for ours, theirs in zip(rates[p], rates["peer"])] for p in PRECISIONS},
        "energy": energies["peer"],
        "energy_off_by": off,
        "tolerance": pair.tolerance,
        "same": max(abs(x) for x in off.values()) <= pair.tolerance,
    }


def show(result):
    """Two lines of the table."""
    peer = spread([rate / 1e6 for rate in result["peer_rates"]])
    for precision in PRECISIONS:
        ours = spread([rate / 1e6 for rate in result["rates"][precision]])
        off = result["energy_off_by"][precision]
        same = "same" if abs(off) <= result["tolerance"] else f"NOT THE SAME, at most {result['tolerance']:.0e}"
        print(f"{result['scene']:4} {result['peer']:32} {peer:22} {precision:7} {ours:22} {spread(result['ratios'][precision]):22}"
              f" {off:+9.1e}  {same}", flush=True)


def show_head():
    print(f"{'':4} {'peer':32} {'M steps/s':22} {'gyrosim':7} {'M steps/s':22} {'ratio':22} energy off by")


def asked():
    ask = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    ask.add_argument("--scene", action="append", choices=sorted({p.scene for p in scenes.PAIRS}), help="default all")
    ask.add_argument("--rounds", type=int, default=3)
    ask.add_argument("--seed", type=int, help="of the start states")
    ask.add_argument("--particles", type=int, help="about; 20,000 by default")
    ask.add_argument("--states", help="folder that keeps the start states")
    ask.add_argument("--core", type=int, help="that all programs run on; default the last one")
    ask.add_argument("--gyrosim", default=str(Path(__file__).resolve().parents[2] / "build/release/gyrosim"))
    ask.add_argument("--lmp", default="lmp")
    ask.add_argument("--liggghts", default="liggghts")
    ask.add_argument("--json", action="store_true", help="one JSON document instead of the table")
    arguments = ask.parse_args()
    if arguments.rounds < 1:
        fail("--rounds must be at least 1")
    return arguments


def main():
    arguments = asked()
    results = []
    with tempfile.TemporaryDirectory() as folder:
        arguments.states = arguments.states or folder
        if not arguments.json:
            print(f"{programs.processor()}; M particle-steps/s of processor time, one core, rounds: {arguments.rounds}")
            show_head()
        for pair in scenes.PAIRS:
            if arguments.scene and pair.scene not in arguments.scene:
                continue
            state = programs.state_of(arguments, pair.scene)
            results.append(result_of(pair, state, *rounds_of(pair, state, arguments, Path(folder))))
            if not arguments.json:
                show(results[-1])
    if arguments.json:
        print(json.dumps({"machine": programs.processor(), "pairs": results}, indent=1))
    return 0 if all(result["same"] for result in results) else 1


if __name__ == "__main__":
    sys.exit(main())

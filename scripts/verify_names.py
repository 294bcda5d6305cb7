#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rewrites app/verify/names.txt, the list of the names of all checks of `gyrosim verify`.

Runs the verifications and takes the names of their checks. With --filter only the verifications that the filter fits run
and only their names are replaced; a new group is added so. Build the program again afterwards.

Usage: verify_names.py [--program build/release/gyrosim] [--filter REGEX]
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAMES = ROOT / "app/verify/names.txt"


def verification_of(name):
    """group/case of a check group/case/quantity."""
    return name.rpartition("/")[0]


def names_of_run(program, pattern):
    """The names of the checks that ran, in order and once each."""
    command = [program, "verify", "--nightly", "--json"] + (["--filter", pattern] if pattern else [])
    run = subprocess.run(command, capture_output=True, text=True)
    if not run.stdout.startswith("{"):
        sys.exit(f"{program} printed no checks: {run.stderr.strip()}")
    return list(dict.fromkeys(check["name"] for check in json.loads(run.stdout)["checks"]))


def merged(old, new):
    """The old names, with those of the verifications that ran replaced; new verifications stand at the end."""
    by_verification = {}
    for name in old:
        by_verification.setdefault(verification_of(name), []).append(name)
    for verification in {verification_of(name) for name in new}:
        by_verification[verification] = []
    for name in new:
        by_verification[verification_of(name)].append(name)
    return [name for names in by_verification.values() for name in names]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/gyrosim"), help="default: %(default)s")
    parser.add_argument("--filter", default="", help="as in `gyrosim verify`, searched in group/case: ^GROUP/")
    options = parser.parse_args()
    new = names_of_run(options.program, options.filter)
    names = merged(NAMES.read_text().split(), new) if options.filter else new
    NAMES.write_text("".join(f"{name}\n" for name in names))
    print(f"{NAMES}: {len(names)} names")


if __name__ == "__main__":
    main()

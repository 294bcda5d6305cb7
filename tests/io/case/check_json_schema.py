#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that every shipped case satisfies the JSON Schema, and that the schema refuses some broken cases."""
import copy
import json
import pathlib
import subprocess
import sys

import jsonschema
import yaml

schema = json.loads(subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
failed = False
cases = [p for p in sorted(pathlib.Path(sys.argv[2]).rglob("*.yaml")) if "sweeps" not in p.parts]
for path in cases:
    for error in validator.iter_errors(yaml.safe_load(path.read_text())):
        print(f"{path}: {'.'.join(map(str, error.path))}: {error.message[:200]}")
        failed = True

good = yaml.safe_load((pathlib.Path(sys.argv[2]) / "quickstart.yaml").read_text())
broken = {
    "unknown key": lambda c: c["time"].update(duratoin=1),
    "wrong unit": lambda c: c["time"].update(duration="1 kg"),
    "out of range": lambda c: c["materials"]["rock"].update(poisson_ratio=0.5),
    "two radii": lambda c: c["bonds"]["radius"].update(absolute=0.01),
    "key of another motor": lambda c: c["drivetrain"]["motor"].update(rated_slip=0.01),
    "missing key of the motor": lambda c: c["drivetrain"]["motor"].pop("stall_torque"),
    "an FMU beside a motor": lambda c: c["drivetrain"].update(fmu="drive.fmu"),
    "no motor and no FMU": lambda c: c["drivetrain"].pop("motor"),
    "a map without an FMU": lambda c: c["drivetrain"].update(map={"mantle_torque": "T"}),
    "no time": lambda c: c.pop("time"),
}
for name, spoil in broken.items():
    case = copy.deepcopy(good)
    spoil(case)
    if validator.is_valid(case):
        print(f"the schema accepts a broken case: {name}")
        failed = True
foreign = copy.deepcopy(good)
foreign["drivetrain"] = {"fmu": "drive.fmu", "map": {"mantle_torque": "-T"}, "parameters": {"a.b[1]": 2.5, "c": True}}
for error in validator.iter_errors(foreign):
    print(f"a drivetrain FMU: {error.message[:200]}")
    failed = True
print(f"{len(cases)} cases checked")
sys.exit(failed or not cases)

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the tables of speed_tables.py on made-up measurements."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent / "speed_tables.py"


def scene(name, threads, rate, phases):
    return {"scene": name, "precision": "mixed", "threads": threads, "particle_steps_per_second": rate,
            "bond_steps_per_second": 0 if name == "S1" else 2e7, "contact_evaluations_per_second": 1e6,
            "simulated_seconds_per_hour": rate / 1e6, "rebuilds": 3, "setup_seconds": 0.06, "bytes_per_particle": 1150.4,
            "phases": phases}


def tables(*documents):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for k, scenes in enumerate(documents):
            files.append(Path(folder) / f"{k}.json")
            files[-1].write_text(json.dumps({"scenes": scenes}))
        return subprocess.run([sys.executable, SCRIPT, *files], capture_output=True, text=True, check=True).stdout


class SpeedTables(unittest.TestCase):
    def test_rates_and_speed_up(self):
        text = tables([scene("S1", 1, 8e6, {"other": 1}), scene("S1", 2, 12e6, {"other": 1})])
        self.assertIn("| S1 | mixed | 8 | 12, 1.50 times |  | 1.00 | 8, 12 | 3 | 0.06 | 1150 |", text)

    def test_shares_are_summed_by_group(self):
        phases = {"advance rocks": 0.5, "bonds of large rocks": 0.3, "find pairs": 0.04, "wide bounds": 0.02,
                  "sum bonds": 0.004, "other": 0.136}
        text = tables([scene("S2", 1, 5e6, phases)], [scene("F", 1, 5e6, {"other": 1})])
        self.assertIn("| rocks advanced: sums, moves, bonds | 80 |  |", text)
        self.assertIn("| neighbour lists | 6 |  |", text)
        self.assertIn("| sums for the ledger |  |  |", text)
        self.assertIn("| other | 14 | 100 |", text)

    def test_bad_input_is_named(self):
        done = subprocess.run([sys.executable, SCRIPT, "/nowhere.json"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("/nowhere.json", done.stderr)


if __name__ == "__main__":
    unittest.main()

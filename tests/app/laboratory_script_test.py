#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the arguments and the progress of scripts/laboratory.py. Usage: laboratory_script_test.py GYROSIM"""
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PLATEN = str(ROOT / "cases" / "laboratory" / "platen.yaml")
PROGRAM = sys.argv.pop()


def call(*arguments, program=PROGRAM):
    command = [sys.executable, str(ROOT / "scripts" / "laboratory.py"), "--gyrosim", program, *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=100)


class LaboratoryScriptTest(unittest.TestCase):
    def refused(self, reason, *arguments, **options):
        done = call(*arguments, **options)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(reason, done.stderr)
        self.assertEqual(done.stdout, "")

    def test_arguments_that_cannot_be_used_are_refused_before_a_run(self):
        self.refused("there is no case file 'none.yaml'", "measure", "none.yaml")
        self.refused("no strength is given", "fit", "--modulus", "5")
        self.refused("'-5' is not a number above 0", "fit", "--ucs", "-5")
        self.refused("'nan' is not a number above 0", "fit", "--ucs", "nan")
        self.refused("'0' is not a whole number", "measure", PLATEN, "--seeds", "0")
        self.refused("'1.5' is not a whole number", "fit", "--ucs", "5", "--rounds", "1.5")
        self.refused("'x' is not an override", "measure", PLATEN, "--set", "x")
        self.refused("there is no program", "fit", "--ucs", "5", program="/no/such/gyrosim")

    def test_standard_error_says_how_many_runs_are_done(self):
        done = call("measure", PLATEN, "--seeds", "3", "--set", "time.duration=1 ms")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual([line.split(" runs,")[0] for line in lines], ["1 of 3", "2 of 3", "3 of 3"])
        self.assertIn("platen, 3 seeds", done.stdout)


if __name__ == "__main__":
    unittest.main()

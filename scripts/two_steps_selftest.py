#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the comparison of runs, and which runs two_steps.sh makes."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent

# A program that writes the summary of a run and its arguments.
PROGRAM = """#!/usr/bin/python3
import json, os, pathlib, sys
arguments = sys.argv[1:]
out = pathlib.Path(arguments[arguments.index("--out") + 1])
out.mkdir(exist_ok=True)
value = 100 + 10 * (out.name == os.environ.get("ODD"))
(out / "summary.json").write_text(json.dumps({"simulated_seconds": 9, "wall_seconds": 5, "holdup_mass": 50, "steady": {
    "from": 2, "gyrations": 20, "throughput_tph": value, "throughput_tph_error": 1}}))
with open(os.environ["CALLS"], "a") as file:
    file.write(json.dumps(arguments) + "\\n")
sys.exit(75 if out.name == os.environ.get("INTERRUPTED") else 0)
"""


class TwoSteps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        program = self.folder / "gyrosim"
        program.write_text(PROGRAM)
        program.chmod(0o755)

    def call(self, *arguments, **environment):
        calls = self.folder / "calls"
        calls.unlink(missing_ok=True)
        done = subprocess.run([SCRIPTS / "two_steps.sh", *arguments], cwd=self.folder, text=True, capture_output=True, timeout=60,
                              env={**os.environ, "GYROSIM": str(self.folder / "gyrosim"), "CALLS": str(calls), **environment})
        return done, [json.loads(line) for line in calls.read_text().splitlines()] if calls.exists() else []

    def test_fine_starts_from_coarse(self):
        done, calls = self.call("a.yaml", "b.yaml", "--error", "2%", "--out", "o p")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(calls), 2)
        out = str(self.folder.resolve() / "o p")
        self.assertEqual(calls[0], ["run", "a.yaml", "--until", "steady=2%", "--out", out + "/coarse", "--resume"])
        self.assertEqual(calls[1][:2], ["run", "b.yaml"])
        self.assertIn("feed.initial_from=" + out + "/coarse", calls[1])

    def test_compare_runs_three_starts(self):
        done, calls = self.call("a.yaml", "b.yaml", "--compare", "--threads", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(calls), 4)
        self.assertIn("feed.initial=80.0", calls[3])
        self.assertTrue(all("--threads" in call for call in calls))
        self.assertIn("| throughput [t/h] | 100 +- 1 | 100 +- 1 | 100 +- 1 | 0.0 |", done.stdout)

    def test_runs_that_differ_are_an_error(self):
        done, _ = self.call("a.yaml", "b.yaml", "--compare", ODD="full")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the runs differ: 7.1 standard errors", done.stdout)

    def test_an_interrupted_run_ends_the_script(self):
        done, calls = self.call("a.yaml", "b.yaml", INTERRUPTED="coarse")
        self.assertEqual(done.returncode, 75)
        self.assertEqual(len(calls), 1)

    def test_bad_calls_are_refused(self):
        for arguments in (["a.yaml"], ["a.yaml", "b.yaml", "c.yaml"], ["a.yaml", "b.yaml", "--none"], ["a.yaml", "b.yaml", "--out"]):
            done, calls = self.call(*arguments)
            self.assertEqual((done.returncode, calls), (2, []), done.stderr)

    def test_runs_that_cannot_be_compared(self):
        (self.folder / "r").mkdir()
        (self.folder / "r" / "summary.json").write_text('{"steady": null, "not_steady": "the chamber is still filling"}')
        for runs, text in ((["r", "r"], "not steady (the chamber is still filling)"), (["x", "r"], "has no summary"),
                           (["r"], "give at least two")):
            done = subprocess.run([SCRIPTS / "compare_runs.py", *runs], cwd=self.folder, text=True, capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 2)
            self.assertIn(text, done.stderr)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep under a real Slurm of one node: points that reach their time limit are put into the queue again and go on, a
point that is killed goes on with the next call, and the results are those of runs in one part.

Usage: sweep_test.py GYROSIM BOX.yaml        5 to 11 minutes on two cores; exit code 77 where Slurm is not installed
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from one_node import OneNode, missing_programs

GYROSIM = CASE = None

# The limit of one minute is too short for the long points. Slurm looks at limits every 30 s, so that their signal comes
# after 10 to 40 s.
SWEEP = """\
case: {case}
set: {{output.snapshots: 0 s, output.series: 20 ms, output.checkpoints: 3 s}}
seeds: [1, 2]
vary: {{time.duration: [1 s, 2 s, {long} s]}}
names: {{time.duration: t}}
slurm: {{time: "1", signal: 50, partition: test}}
"""


def figures_of(run):
    """summary.json without what a run in parts may change."""
    summary = json.loads((run / "summary.json").read_text())
    for name in ("wall_seconds", "threads"):
        summary.pop(name)
    return summary


class SlurmSweep(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="gyrosim-slurm-", ignore_cleanup_errors=True)
        self.folder = Path(self.scratch.name)
        self.folder.chmod(0o755)  # the user munge must get through
        self.slurm = OneNode(self.folder / "slurm")
        (self.folder / "slurm").mkdir()
        self.addCleanup(self.scratch.cleanup)
        self.addCleanup(self.slurm.__exit__)
        self.slurm.__enter__()
        self.sweep = self.folder / "work" / "runs" / "s"
        (self.folder / "work").mkdir()

    def gyrosim(self, *arguments):
        result = subprocess.run([GYROSIM, *arguments], cwd=self.folder / "work", env=self.slurm.environment,
                                capture_output=True, text=True, check=False)
        print(result.stderr, result.stdout, sep="", flush=True)
        return result

    def long_duration(self):
        """Simulated time of a run that takes more than a minute here, also while the other core is busy."""
        begin = time.monotonic()
        result = self.gyrosim("run", CASE, "--until", "1 s", "--out", "probe", "--quiet", "--threads", "1", "--set",
                              "time.duration=1 s", "--set", "output.snapshots=0 s")
        self.assertEqual(result.returncode, 0)
        return max(3, round(75 / (time.monotonic() - begin)))

    def states(self):
        states = {}
        for run in sorted(self.sweep.glob("t-*")):
            file = run / "summary.json"
            states[run.name] = json.loads(file.read_text())["status"] if file.exists() else "-"
        return states

    def wait_for_empty_queue(self, seconds):
        def is_empty():
            return not self.slurm.output("squeue", "--noheader").strip()
        self.slurm.wait(is_empty, f"the queue does not become empty: {self.states()}", seconds)

    def kill_one_long_run(self, long_name):
        """Kills the run of a point once it has a checkpoint, as the kernel does when memory runs out."""
        run = self.sweep / long_name
        self.slurm.wait(lambda: (run / "checkpoint.h5").exists() and (run / "run.lock").exists(),
                        f"{long_name} does not begin", 300)
        lock = dict(line.split(" ", 1) for line in (run / "run.lock").read_text().splitlines())
        os.kill(int(lock["pid"]), signal.SIGKILL)
        print(f"killed process {lock['pid']} of {long_name}", flush=True)

    def test_points_are_requeued_and_go_on(self):
        long = self.long_duration()
        (self.folder / "work" / "s.yaml").write_text(SWEEP.format(case=CASE, long=long))
        names = [f"t-{t}s_seed-{seed}" for t in (1, 2, long) for seed in (1, 2)]
        begin = time.monotonic()

        self.assertEqual(self.gyrosim("sweep", "s.yaml", "--engine", "slurm").returncode, 0)
        again = self.gyrosim("sweep", "s.yaml", "--engine", "slurm")
        self.assertIn("points are in the queue already", again.stderr)
        self.assertIn("no points to submit", again.stderr)

        killed = names[-1]
        self.kill_one_long_run(killed)
        self.wait_for_empty_queue(600)
        print(f"after {time.monotonic() - begin:.0f} s: {self.states()}", flush=True)
        states = self.states()
        self.assertEqual({states[name] for name in names if name != killed}, {"done"})
        self.assertNotEqual(states.get(killed), "done")
        logs = "".join(log.read_text() for log in (self.sweep / "logs").glob("slurm-*.txt"))
        print(logs, flush=True)
        self.assertIn(f"{killed}: exit code 137", logs)
        self.assertIn(f"{names[-2]}: exit code 75", logs)
        self.assertRegex(logs, names[-2] + ": exit code 0, restarts so far: [1-9]")

        second = self.gyrosim("sweep", "s.yaml", "--engine", "slurm")
        self.assertIn("has 1 points", second.stderr)
        self.wait_for_empty_queue(600)
        self.assertEqual(set(self.states().values()), {"done"})
        self.assertEqual(self.gyrosim("sweep", "s.yaml", "--collect").returncode, 0)
        self.assertEqual((self.sweep / "results.csv").read_text().count(",done,"), len(names))
        print(f"all points are done after {time.monotonic() - begin:.0f} s", flush=True)

        self.assertEqual(self.gyrosim("sweep", "s.yaml", "--out", "whole", "--quiet").returncode, 0)
        for name in names:
            self.assertEqual(figures_of(self.sweep / name), figures_of(self.folder / "work" / "whole" / name), name)


def main():
    global GYROSIM, CASE
    if missing := missing_programs():
        print(f"skipped: not installed: {', '.join(missing)}; Debian has them in slurmctld slurmd slurm-client munge")
        return 77
    GYROSIM, CASE = (str(Path(path).resolve()) for path in sys.argv[1:3])
    return 0 if unittest.main(argv=sys.argv[:1], exit=False).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())

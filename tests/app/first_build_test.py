#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""gyrosim in a build folder that has only what scripts/run.sh builds: it builds other parts when they are needed.

A copy of the program in a folder of its own, with a cmake that writes down its calls and makes a small script.
Usage: first_build_test.py GYROSIM
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

GYROSIM = Path(sys.argv[1])

CMAKE = """#!/bin/sh
echo "$@" >>"$FOLDER/calls"
[ "$FAIL" ] && { echo no compiler; exit 1; }
cat >"$FOLDER/gyrosim-complete" <<'END'
#!/bin/sh
echo complete "$@"
exit 3
END
chmod +x "$FOLDER/gyrosim-complete"
"""


class FirstBuild(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = Path(folder.name, "it's a build")  # a quote in the path must work
        self.build.mkdir()
        (self.build / "CMakeCache.txt").touch()
        shutil.copy(GYROSIM, self.build / "gyrosim")
        self.age(self.build / "gyrosim", 100)
        self.bin = Path(folder.name, "bin")
        self.bin.mkdir()
        (self.bin / "cmake").write_text(CMAKE)
        (self.bin / "cmake").chmod(0o755)

    @staticmethod
    def age(file, seconds):
        now = file.stat().st_mtime
        os.utime(file, (now - seconds, now - seconds))

    def call(self, *arguments, **environment):
        return subprocess.run([self.build / "gyrosim", *arguments], capture_output=True, text=True, timeout=60,
                              env={"PATH": f"{self.bin}:/usr/bin:/bin", "FOLDER": str(self.build), **environment})

    def calls(self):
        file = self.build / "calls"
        return file.read_text().splitlines() if file.exists() else []

    def test_builds_what_is_missing_and_hands_the_command_line_on(self):
        for command in (["verify", "--filter", "a b", "--json"], ["bench", "accuracy", "--quick"]):
            done = self.call(*command)
            self.assertEqual((done.returncode, done.stdout), (3, " ".join(["complete", *command]) + "\n"), done.stderr)
        self.assertEqual(self.calls(), [f"--build {self.build} --target gyrosim-complete"])  # once

    def test_builds_again_what_is_older_than_the_program(self):
        self.call("verify")
        self.age(self.build / "gyrosim-complete", 1000)
        done = self.call("verify")
        self.assertEqual((done.returncode, done.stderr), (3, ""))
        self.assertEqual(len(self.calls()), 2)

    def test_a_bad_command_line_builds_nothing(self):
        self.assertEqual(self.call("verify", "--bogus").returncode, 2)
        self.assertEqual(self.call("verify", "--help").returncode, 0)
        self.assertEqual(self.calls(), [])

    def test_says_why_when_it_cannot_build(self):
        done = self.call("verify", FAIL="yes")
        self.assertEqual(done.returncode, 5)
        log = self.build / "gyrosim-complete.log"
        self.assertIn(str(log), done.stderr)
        self.assertEqual(log.read_text(), "no compiler\n")

    def test_outside_a_build_folder_names_what_is_missing(self):
        (self.build / "CMakeCache.txt").unlink()
        done = self.call("verify")
        self.assertEqual((done.returncode, self.calls()), (5, []))
        self.assertIn("gyrosim-complete: is missing", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs gyrosim, moves the installed tree, and uses it: program, manual page, completions, package.

Usage: install_test.py SOURCE BUILD CMAKE; everything in BUILD must have been built.
"""
import csv
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE, BUILD, CMAKE = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, **options)
    if done.returncode != 0:
        raise AssertionError(f"{words} returned {done.returncode}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


class Installed(unittest.TestCase):
    folder = Path(tempfile.mkdtemp(prefix="gyrosim-install-"))
    prefix = folder / "final place"
    gyrosim = prefix / "bin/gyrosim"


def setUpModule():
    unittest.addModuleCleanup(shutil.rmtree, Installed.folder)
    first = Installed.folder / "first place"
    run(CMAKE, "--install", BUILD, "--prefix", first)
    first.rename(Installed.prefix)


class Program(Installed):
    def test_finds_its_files(self):
        for name, file in (("quickstart", "quickstart.yaml"), ("primary", "mkii-62-75/case.yaml"),
                           ("compression", "laboratory/platen.yaml")):
            self.assertEqual(run(self.gyrosim, "init", "--template", name), (SOURCE / "cases" / file).read_text())
        cases = self.prefix / "share/gyrosim/cases"
        self.assertTrue((cases / "bench/accuracy/reference.json").exists())
        run(self.gyrosim, "run", cases / "box.yaml", "--until", "1 ms", "--quiet", "--out", self.folder / "run")
        self.assertTrue((self.folder / "run/summary.json").exists())
        run(self.gyrosim, "export", "fmu", cases / "quickstart.yaml", "--out", self.folder / "drive.fmu")
        self.assertTrue((self.folder / "drive.fmu").exists())

    def test_is_complete(self):
        self.assertIn("restitution/", run(self.gyrosim, "verify", "--filter", "^restitution/"))

    def test_scripts(self):
        for script in ("laboratory.py", "plot.py", "render.py"):
            run("/usr/bin/python3", self.prefix / "share/gyrosim/scripts" / script, "--help")


class Pages(Installed):
    """Manual page and completions name every command and option that the program's own help names."""

    def commands(self, *words):
        """The words of each command without commands below it, and its options, as --help lists them."""
        text = run(self.gyrosim, *words, "--help")
        options = re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.MULTILINE)
        below = text.partition("Subcommands:\n")[2]
        names = re.findall(r"^  (\w+) ", below, re.MULTILINE)
        found = [] if names else [(words, options)]
        for name in names:
            found += self.commands(*words, name)
        return found

    def setUp(self):
        self.all = self.commands()
        self.assertGreaterEqual(len(self.all), 11)
        self.assertIn("--resume", dict(self.all)[("run",)])

    def test_manual_page(self):
        page = (self.prefix / "share/man/man1/gyrosim.1").read_text().replace("\\-", "-")
        for words, options in self.all:
            with self.subTest(command=words):
                section = re.search(r'^\.SS "gyrosim ' + " ".join(words) + r"[ \"](.*?)(?=^\.S[HS])", page, re.M | re.S)
                self.assertIsNotNone(section)
                for option in options:
                    if option != "--help":
                        self.assertIn(f"\\fB{option}\\fR", section[1])

    def complete(self, *words):
        """What bash offers for the last word."""
        script = self.prefix / "share/bash-completion/completions/gyrosim"
        line = " ".join(f"'{word}'" for word in ("gyrosim", *words))
        return run("bash", "-c", f"source '{script}'; COMP_WORDS=({line}); COMP_CWORD={len(words)}; _gyrosim;"
                                 ' printf "%s\\n" "${COMPREPLY[@]}"').split()

    def test_bash(self):
        self.assertEqual({words[0] for words, _ in self.all}, set(self.complete("")))
        for words, options in self.all:
            with self.subTest(command=words):
                self.assertEqual(set(options), set(self.complete(*words, "--")))
        self.assertEqual(self.complete("run", "case.yaml", "--device", "cu"), ["cuda"])
        self.assertEqual(self.complete("ver"), ["verify"])

    def test_zsh(self):
        script = (self.prefix / "share/zsh/site-functions/_gyrosim").read_text()
        for words, options in self.all:
            with self.subTest(command=words):
                body = re.search(r"^_gyrosim_" + "_".join(words) + r"\(\) \{\n(.*?)^\}", script, re.M | re.S)
                self.assertIsNotNone(body)
                for option in options:
                    self.assertIn(f"{option}[", body[1])
        if shutil.which("zsh"):
            run("zsh", "-n", self.prefix / "share/zsh/site-functions/_gyrosim")


class Examples(Installed):
    @classmethod
    def setUpClass(cls):
        cls.build = cls.folder / "examples"
        environment = {name: value for name, value in os.environ.items() if name != "CMAKE_CXX_COMPILER_LAUNCHER"}
        run(CMAKE, "-S", SOURCE / "app/examples", "-B", cls.build, f"-DCMAKE_PREFIX_PATH={cls.prefix}",
            "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", env=environment)
        run(CMAKE, "--build", cls.build, "--parallel", "2")

    def rows(self, program):
        return [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(io.StringIO(run(self.build / program)))]

    def test_drop_rock(self):
        rows = self.rows("drop_rock")
        self.assertEqual(rows[0]["broken_bonds"], 0)
        self.assertGreater(rows[-1]["broken_bonds"], 10)
        self.assertLess(rows[-1]["broken_bonds"], 540)  # of the cube's 3 x 6 x 6 x 5 bonds
        self.assertGreater(rows[-1]["lost_J"], 0.1 * rows[0]["kinetic_J"])
        for row in rows:
            self.assertLess(abs(row["residual_J"]), 0.01 * rows[0]["kinetic_J"])

    def test_crush_rock(self):
        rows = self.rows("crush_rock")
        speeds = [row["eccentric_rpm"] for row in rows]
        self.assertGreater(speeds[0] - min(speeds), 0.05)  # the rock slows the motor down
        self.assertGreater(rows[-1]["broken_bonds"], 10)
        self.assertGreater(rows[-1]["crushing_work_J"], 0)
        self.assertGreater(rows[-1]["motor_work_J"], 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

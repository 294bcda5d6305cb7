#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of scripts/peers: data files of the peers, and the comparison with programs that only print what those would."""
import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

SCRIPTS = Path(__file__).resolve().parent
sys.path.insert(0, str(SCRIPTS / "peers"))
import compare  # noqa: E402: in the folder above
import scenes  # noqa: E402
from states import State  # noqa: E402

PEER = """#!/bin/bash
echo "   Step  KinEng  c_turning"
echo "    100  1.0  0.5"
echo "Loop time of 9.0 on 1 procs for 100 steps with 2 atoms"
echo "    500  4.0  0.5"
echo "Loop time of 2.0 on 1 procs for 400 steps with 2 atoms"
echo "Total # of neighbors = 5"
"""

GYROSIM = """#!/usr/bin/python3
import json, sys
words = sys.argv
if "--states-only" in words:
    print("STATE")
else:
    rate = 4000.0 if words[words.index("--precision") + 1] == "double" else 8000.0
    print(json.dumps({"scenes": [{"particle_steps_per_second": rate, "kinetic_energy": ENERGY}]}))
"""


class PeersTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.at = Path(folder.name)
        state = self.at / "S2-1-2"
        state.mkdir()
        (state / "particles.csv").write_text("id,x,y,z,r,vx,vy,vz\n0,0.5,0,0,0.01,3,0,4\n1,0.52,0,0,0.01,0,0,0\n")
        (state / "bonds.csv").write_text("i,j\n0,1\n")
        sizes = {"bottom": -0.01, "top": 0.01}
        scene = {"bonds": 1, "warm_up": 100, "timed": 400, "time_step": 5e-7, "sizes": sizes}
        (state / "scene.json").write_text(json.dumps(scene))
        self.state = State(state)

    def program(self, name, text):
        path = self.at / name
        path.write_text(text)
        path.chmod(0o755)
        return str(path)

    def compare(self, energy):
        gyrosim = GYROSIM.replace("STATE", str(self.state.folder)).replace("ENERGY", repr(energy))
        words = ["compare.py", "--scene", "S2", "--rounds", "2", "--json", "--lmp", self.program("lmp", PEER)]
        words += ["--gyrosim", self.program("gyrosim", gyrosim)]
        printed = io.StringIO()
        with mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(printed):
            code = compare.main()
        return code, json.loads(printed.getvalue())["pairs"]

    def test_data_file_has_atoms_velocities_and_bonds_counted_from_one(self):
        self.state.write(self.at / "data", molecules=True)
        lines = (self.at / "data").read_text().splitlines()
        self.assertIn("2 atoms", lines)
        self.assertIn("1 1 1 0.02 2600.0 0.5 0 0", lines)
        self.assertIn("1 3 0 4 0 0 0", lines)
        self.assertIn("1 1 1 2", lines[lines.index("Bonds"):])
        self.assertIn("0.3 0.72 xlo xhi", lines)
        self.assertAlmostEqual(self.state.kinetic_energy(), 0.5 * 4 / 3 * 3.14159265 * 1e-6 * 2600 * 25)

    def test_every_scene_of_the_comparison_has_its_input_file(self):
        self.assertEqual({pair.scene for pair in scenes.PAIRS}, {"S1", "S2", "S2r", "S3"})
        for name in ("loose.lmp", "same.lmp", "bonded.lmp", "loose.liggghts"):
            self.assertTrue((SCRIPTS / "peers" / name).exists())

    def test_rates_are_of_the_last_run_and_energies_are_compared(self):
        code, pairs = self.compare(4.02)
        self.assertEqual(code, 0)
        self.assertEqual(len(pairs), 1)
        self.assertEqual(len(pairs[0]["peer_rates"]), 2)
        for ours, ratio in zip(pairs[0]["peer_rates"], pairs[0]["ratios"]["double"]):
            self.assertGreaterEqual(ours, 2 * 400 / 2.0)  # two particles, 400 steps; at most 2 s on the core
            self.assertAlmostEqual(ratio, 4000 / ours)
        self.assertAlmostEqual(pairs[0]["energy_off_by"]["mixed"], 0.005)

    def test_another_energy_is_a_failure(self):
        code, pairs = self.compare(4.2)
        self.assertEqual(code, 1)
        self.assertFalse(pairs[0]["same"])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every sub-command of plot.py on small made-up data. Skipped without h5py or matplotlib."""
import contextlib
import importlib.util
import io
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

MEASURED = Path(__file__).resolve().parent.parent / "cases" / "bench" / "accuracy" / "measured.json"
MISSING = [name for name in ("h5py", "matplotlib", "numpy") if importlib.util.find_spec(name) is None]
UNITS = {"time": "s", "eccentric_speed": "rad/s", "eccentric_angle": "rad", "crushing_power": "W", "mantle_torque": "N m",
         "bonds_broken_tension": "1", "bonds_broken_shear": "1", "discharged_mass": "kg"}


@unittest.skipIf(MISSING, f"needs {', '.join(MISSING)}")
class Plot(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write_run(self, name, rows=40):
        import h5py
        import numpy as np
        run = self.folder / name
        run.mkdir()
        time = np.linspace(1e-3, 1e-3 * rows, rows)
        with h5py.File(run / "results.h5", "w", libver="latest") as file:
            for number, (column, units) in enumerate(UNITS.items()):
                file[f"series/{column}"] = time if column == "time" else 3e3 * np.sin((number + 1) * 100 * time)
                file[f"series/{column}"].attrs["units"] = units
            file["series/mantle_force"] = np.stack([np.cos(time), np.sin(time), time], axis=1)[:-1]  # a row is being written
            file["liners/mantle/heights"], file["liners/mantle/azimuths"] = [0.0, 0.1, 0.2], np.linspace(0, 6.28, 9)
            file["liners/mantle/time"] = [0.01, 0.02]
            file["liners/mantle/pressure"] = np.ones((2, 16))
            file["liners/mantle/work"] = np.zeros((2, 16))
        (run / "summary.json").write_text(json.dumps({"title": "Made up",
                                                      "drive_events": [{"time": 0.02, "event": "stalled"}]}))
        return run

    def plot(self, *arguments):
        """What plot.py prints. @raises SystemExit as it does"""
        import plot
        printed = io.StringIO()
        with mock.patch("sys.argv", ["plot.py", *map(str, arguments)]), contextlib.redirect_stdout(printed):
            plot.main()
        return printed.getvalue().strip()

    def assert_draws(self, *arguments):
        picture = self.folder / "picture.png"
        self.assertEqual(self.plot(*arguments, "--out", picture), str(picture))
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")

    def test_runs(self):
        run = self.write_run("a")
        self.assert_draws("series", run)
        self.assert_draws("machine", run)
        self.assert_draws("machine", run, "--from", "0.03")
        self.assert_draws("drives", run, self.write_run("b"), "--smooth", "0.01")

    def test_benchmarks(self):
        self.assert_draws("accuracy", MEASURED)
        rocks = [{"diameter": d, "particles": 50, "bonds": 100} for d in (0.05, 0.5)]
        library = self.folder / "library.json"
        library.write_text(json.dumps({"ranged": rocks, "equal": {ratio: rocks for ratio in (10, 6)}}))
        self.assert_draws("library", library)

    def test_bad_input_is_explained(self):
        run = self.write_run("short", rows=10)
        for arguments, advice in (
            (("series", "nowhere"), "give the directory of a run"),
            (("machine", run, "--from", "1"), "use an earlier --from"),
            (("drives", run, "--smooth", "1"), "use a shorter time"),
            (("accuracy", run / "summary.json"), "bench accuracy --json"),
            (("library", MEASURED), "paper_library.py --json"),
        ):
            with self.subTest(arguments=arguments):
                with self.assertRaisesRegex(SystemExit, advice):
                    self.plot(*arguments)


if __name__ == "__main__":
    unittest.main()

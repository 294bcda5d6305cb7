#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every sub-command of plot.py on small made-up data, and compares what is drawn with numbers found by hand. Skipped
without h5py, matplotlib or yaml."""
import contextlib
import importlib.util
import io
import json
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

SCRIPTS = Path(__file__).resolve().parent
MEASURED = SCRIPTS.parent / "cases" / "bench" / "accuracy" / "measured.json"
MISSING = [name for name in ("h5py", "matplotlib", "numpy", "yaml") if importlib.util.find_spec(name) is None]
UNITS = {"time": "s", "eccentric_speed": "rad/s", "eccentric_angle": "rad", "crushing_power": "W", "mantle_torque": "N m",
         "bonds_broken_tension": "1", "bonds_broken_shear": "1", "holdup_mass": "kg", "discharged_mass": "kg"}
CASE = """
contacts: {{rock/rock: {{friction: 0.5}}, steel/rock: {{friction: 0.7}}}}
walls: {{mantle: {{material: steel, motion: gyration}}}}
rocks: {{sizes: {sizes}}}
crusher: {{closed_side_setting: 0.015, eccentricity: 2.5e-03}}
output: {{liners: {{interval: 0.01{wear}}}}}
"""
PASSING = "{passing: [[0.03, 0], [0.06, 1]]}"
COEFFICIENT = 7e-13  # of wear [1/Pa]
# A run that is killed in the middle: SWMR is on, the last row is half written, nothing is closed.
KILLED = """
import os, signal, sys, h5py
file = h5py.File(sys.argv[1], "w", libver="latest")
for name, rows in (("time", 3), ("crushing_power", 3), ("eccentric_speed", 2)):
    data = file.create_dataset("series/" + name, (0,), maxshape=(None,), chunks=(8,), dtype=float)
    data.attrs["units"] = "s"
file.swmr_mode = True
for name, rows in (("time", 3), ("crushing_power", 3), ("eccentric_speed", 2)):
    data = file["series/" + name]
    data.resize((rows,))
    data[:] = range(1, rows + 1)
    data.flush()
os.kill(os.getpid(), signal.SIGKILL)
"""


@unittest.skipIf(MISSING, f"needs {', '.join(MISSING)}")
class Plot(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write_run(self, name, rows=40, sizes=PASSING, steady=None, wear=f", wear_coefficient: {COEFFICIENT}"):
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
            case = file.create_group("case").attrs
            case["title"], case["resolved_yaml"] = "Made up", CASE.format(sizes=sizes, wear=wear)
            for group, masses in (("product", [0, 1, 4]), ("holdup", [6, 5, 2])):
                file[f"{group}/time"], file[f"{group}/mass"] = [0.001, 0.02, 0.04], masses
                file[f"{group}/sizes"] = [0.004, 0.008, 0.016, 0.032, 0.064]
                file[f"{group}/passing"] = [[0, 0, 0, 0, 0], [0, 0.4, 1, 1, 1], [0, 0.1, 0.7, 0.9, 1]]
            file["liners/mantle/heights"], file["liners/mantle/azimuths"] = [0.0, 0.1, 0.2], np.linspace(0, 6.28, 9)
            file["liners/mantle/time"] = [0.01, 0.02]
            file["liners/mantle/area"] = np.append(np.full(8, 0.01), np.zeros(8))  # the upper row has no surface
            file["liners/mantle/pressure"] = np.ones((2, 16))
            file["liners/mantle/work"] = [[2.0] * 4 + [0.0] * 12, [3.0] * 4 + [0.0] * 12]
        (run / "summary.json").write_text(json.dumps({"steady": steady, "drive_events": [{"time": 0.02, "event": "stalled"}]}))
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

    def drawn(self, *arguments):
        """The axes of the figure that plot.py saves."""
        import matplotlib.pyplot as plt
        plt.close("all")
        self.assert_draws(*arguments)
        return plt.gcf().axes


class Runs(Plot):
    def test_machine_and_drives(self):
        run = self.write_run("a")
        axes = {axis.get_title(): axis for axis in self.drawn("machine", run)}
        work = axes["mantle: sliding work, at most 5"].collections[0]
        self.assertEqual(list(work.get_array()[:5]), [5, 5, 5, 5, 0])
        self.assertEqual(axes["mantle: mean pressure, at most 1"].get_ylabel(), "height [m]")
        titles = [axis.get_title() for axis in self.drawn("machine", run, "--from", "0.03")]
        self.assertIn("mantle: sliding work, at most 0", titles)
        self.assert_draws("drives", run, self.write_run("b"), "--smooth", "0.01")

    def test_series(self):
        axes = self.drawn("series", self.write_run("a", steady={"from": 0.03, "crushing_power": 1500}))
        self.assertEqual([axis.get_ylabel().replace("\n", " ") for axis in axes],
                         ["eccentric speed [rpm]", "crushing power [kW]", "broken bonds", "chamber mass [kg]",
                          "discharged mass [kg]"])
        self.assertEqual((axes[0].get_title(), axes[-1].get_xlabel()), ("Made up", "time [s]"))
        for axis in axes:
            shaded = axis.patches[0].get_xy()
            self.assertAlmostEqual(min(x for x, _ in shaded), 0.03)
            self.assertAlmostEqual(max(x for x, _ in shaded), 0.04)
        self.assertEqual(list(axes[1].lines[1].get_ydata()), [1.5, 1.5])
        self.assertFalse(self.drawn("series", self.write_run("b"))[0].patches)  # not steady

    def test_a_killed_run(self):
        run = self.folder / "killed"
        run.mkdir()
        done = subprocess.run([sys.executable, "-c", KILLED, run / "results.h5"], check=False)
        self.assertEqual(done.returncode, -signal.SIGKILL)
        axes = self.drawn("series", run)
        self.assertEqual([len(axis.lines[0].get_xdata()) for axis in axes], [2, 2])
        self.assertEqual(axes[0].get_title(), "killed")


class Curves(Plot):
    def curves(self, *arguments):
        """({name: (sizes [mm], passing [%])}, legend, lines of the settings [mm])"""
        axis, = self.drawn("curves", *arguments)
        named = {line.get_label().split(" ")[0]: line.get_data() for line in axis.lines if " (" in line.get_label()}
        settings = [line.get_xdata()[0] for line in axis.lines
                    if line.get_linestyle() == "--" and line.get_label().startswith("_")]
        return named, " ".join(text.get_text() for text in axis.get_legend().get_texts()), settings

    def test_numbers(self):
        import numpy as np
        found, legend, settings = self.curves(self.write_run("a"))
        self.assertEqual(list(found), ["feed", "chamber", "product"])
        np.testing.assert_allclose(found["product"], ([4, 8, 16, 32, 64], [0, 10, 70, 90, 100]))
        np.testing.assert_allclose(settings, [15, 20])
        # P80: half way between 16 and 32 mm on a logarithmic axis; of the feed 30 + 0.8 x 30 mm.
        for text in ("product (4 kg): P80 = 22.6 mm", "chamber (2 kg): P80 = 22.6 mm", "feed (case): P80 = 54 mm"):
            self.assertIn(text, legend)

    def test_product_of_a_part(self):
        import numpy as np
        found, legend, _ = self.curves(self.write_run("a"), "--from", "0.02")
        np.testing.assert_allclose(found["product"][1], [0, 0, 60, 260 / 3, 100], atol=1e-12)  # (4 x after - 1 x before) / 3
        self.assertIn("product (3 kg)", legend)

    def add_particles(self, run, finest, coarsest):
        import h5py
        with h5py.File(run / "results.h5", "r+") as file:
            for group in ("product", "holdup"):
                file[group].attrs["resolution"], file[group].attrs["finest_particle"] = coarsest, finest

    def shaded(self, run):
        """([(from, to) of each band in mm], text beside them)"""
        axis, = self.drawn("curves", run)
        bands = [(min(x for x, _ in patch.get_xy()), max(x for x, _ in patch.get_xy())) for patch in axis.patches]
        return bands, next((text.get_text() for text in axis.texts if "particles" in text.get_text()), None)

    def test_sizes_of_particles_are_shaded(self):
        run = self.write_run("a")
        self.assertEqual(self.shaded(run), ([], None))  # of an older version
        self.add_particles(run, 0.005, 0.005)
        (band,), text = self.shaded(run)
        self.assertAlmostEqual(band[1], 5)
        self.assertEqual(text, "particles of\n5 mm:\nfiner rock\nis unknown")
        self.add_particles(run, 0.0025, 0.01)
        (unknown, incomplete), text = self.shaded(run)
        self.assertAlmostEqual(unknown[1], 2.5)
        self.assertEqual([round(x, 9) for x in incomplete], [2.5, 10])
        self.assertIn("2.5 to 10 mm", text)

    def test_estimated_fines_are_dashed(self):
        import h5py
        import numpy as np
        run = self.write_run("a")
        self.add_particles(run, 0.008, 0.008)
        with h5py.File(run / "results.h5", "r+") as file:
            text = file["case"].attrs["resolved_yaml"].replace("output: {", "output: {fines: {breakage: {A: 0.6, b: 0.003}}, ")
            file["case"].attrs["resolved_yaml"] = text
            for group in ("product", "holdup"):
                file[f"{group}/passing_with_fines"] = [[0, 0, 0, 0, 0], [0.2, 0.5, 1, 1, 1], [0.1, 0.3, 0.7, 0.9, 1]]
        axis, = self.drawn("curves", run)
        dashed = {line.get_label(): line for line in axis.lines if "fines" in line.get_label()}
        line = dashed["product with estimated fines: P80 = 22.6 mm"]
        self.assertEqual(line.get_linestyle(), "--")
        np.testing.assert_allclose(line.get_ydata(), [10, 30, 70, 90, 100])
        self.assertEqual(len(dashed), 2)
        text = next(text.get_text() for text in axis.texts if "particles" in text.get_text())
        self.assertEqual(text, "particles of\n8 mm:\nbelow 8 mm\nestimated,\nby the energy of breakage")
        axis, = self.drawn("curves", run, "--from", "0.02")
        line = next(line for line in axis.lines if line.get_label().startswith("product with"))
        np.testing.assert_allclose(line.get_ydata(), [20 / 3, 70 / 3, 60, 260 / 3, 100])

    def test_rock_beyond_the_sieves(self):
        import h5py
        run = self.write_run("a")
        with h5py.File(run / "results.h5", "r+") as file:
            file["holdup/passing"][-1] = [0, 0, 0, 0, 0.5]
            file["product/passing"][-1] = 0
        legend = self.curves(run)[1]
        self.assertIn("chamber (2 kg): P80 beyond the sieves", legend)
        self.assertIn("product (4 kg): P80 beyond the sieves", legend)

    def test_laws_of_the_feed(self):
        sieves = self.folder / "sieves.csv"
        sieves.write_text("size_mm,passing_percent\n10,0\n20,40\n40,100\n")
        # P80 by the formulas of `gyrosim describe rocks.sizes`.
        for number, (sizes, p80) in enumerate((
            ("{rosin_rammler: {x63: 0.05, m: 1, min: 0.001, max: 10}}", "81.5"),  # 1 + 50 ln 5
            ("{gates_gaudin_schuhmann: {xmax: 0.06, m: 2, min: 0.01}}", "53.9"),  # sqrt(1 + 0.8 x 35) x 10
            ("{vendor: {feed_opening: 0.1, min: 0.005}}", "60"),
            (f"{{sieves: {sieves}}}", "33.3"),
        )):
            with self.subTest(sizes=sizes):
                self.assertIn(f"feed (case): P80 = {p80} mm", self.curves(self.write_run(f"feed{number}", sizes=sizes))[1])

    def test_tables_of_spreadsheets(self):
        for number, text in enumerate((
            "\ufeffsep=;\nsize_mm;passing_percent;\n40,0;100,0;\n\n20,0;40,0;\n10,0;0;\n;;\n",
            "# May\rsize_mm\tpassing_percent\r10\t0\r20\t40\r40\t100\r",
            '"size_mm" , "passing_percent"\r\n"+10,0","0"\r\n"20,0", "40"\r\n 40 ," 100 "\r\n',
        )):
            with self.subTest(text=text):
                sieves = self.folder / f"sieves{number}.csv"
                sieves.write_bytes(text.encode())
                run = self.write_run(f"table{number}", sizes=f"{{sieves: {sieves}}}")
                self.assertIn("feed (case): P80 = 33.3 mm", self.curves(run)[1])

    def test_lost_file_of_the_feed(self):
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            found, _, _ = self.curves(self.write_run("a", sizes="{sieves: /nowhere.csv}"))
        self.assertEqual(list(found), ["chamber", "product"])
        self.assertIn("/nowhere.csv", said.getvalue())


class Wear(Plot):
    # 5 J on 0.01 m2 in 0.02 s with a friction of 0.7: 5e-10 m in 0.02 s, that is 90 mm in 1000 h.
    def test_numbers(self):
        import numpy as np
        run = self.write_run("a")
        for options, worn in (((), 90), (("--from", "0.01"), 108), (("--coefficient", str(2 * COEFFICIENT)), 180)):
            with self.subTest(options=options):
                axes = self.drawn("wear", run, *options)
                cells = axes[0].collections[0].get_array().reshape(2, 8)
                np.testing.assert_allclose(cells[0], [worn] * 4 + [0] * 4, rtol=1e-6)
                self.assertTrue(np.ma.getmaskarray(np.ma.masked_invalid(cells[1])).all())
                self.assertEqual(axes[0].get_title(), f"mantle: wear [mm per 1000 h], at most {worn}")
                bars = axes[1].patches[0].get_data()
                np.testing.assert_allclose(bars.values, [worn / 2, 0], rtol=1e-6)  # half of the liner is worn
                self.assertEqual(axes[1].get_xlabel(), "wear [mm per 1000 h]")

    def test_end_of_the_scale(self):
        axes = self.drawn("wear", self.write_run("a"), "--max", "7")
        self.assertEqual(axes[0].collections[0].get_clim(), (0, 7))


class Other(Plot):
    def test_benchmarks(self):
        self.assert_draws("accuracy", MEASURED)
        rocks = [{"diameter": d, "particles": 50, "bonds": 100} for d in (0.05, 0.5)]
        library = self.folder / "library.json"
        library.write_text(json.dumps({"ranged": rocks, "equal": {ratio: rocks for ratio in (10, 6)}}))
        self.assert_draws("library", library)

    def write_levels(self, name):
        """Three settings and two seeds; the second costs a fifth and has 10 +- 2 % more power, the third no change."""
        figures = {"mean_crushing_power": 100, "broken": 0.2, "breakage": 50, "p80": 0.1, "cost": 10}
        results = {"": [figures, figures],
                   "numerics.levels={rigid: pieces}": [{**figures, "mean_crushing_power": 108, "cost": 1.5},
                                                       {**figures, "mean_crushing_power": 112, "cost": 2.5}],
                   "numerics.hold=off": [figures, figures]}
        file = self.folder / name
        file.write_text(json.dumps(results))
        return file

    def test_levels(self):
        one, two = self.write_levels("one.json"), self.write_levels("two.json")
        axes = self.drawn("levels", one, two)
        power = [container for container in axes[0].containers]
        self.assertEqual([c.get_label() for c in power], ["reference", "levels={rigid: pieces}", "hold=off"])
        (x,), (y,) = power[1].lines[0].get_data()
        self.assertAlmostEqual(x, 10)
        self.assertAlmostEqual(y, 0.2)
        low, high = power[1].lines[2][0].get_segments()[0][:, 0]
        self.assertAlmostEqual(low, 8)
        self.assertAlmostEqual(high, 12)
        (x,), (y,) = power[2].lines[0].get_data()
        self.assertEqual((x, y), (0, 1))

    def test_bad_input_is_explained(self):
        run, bare = self.write_run("short", rows=10), self.write_run("bare", wear="")
        for arguments, advice in (
            (("series", "nowhere"), "give the directory of a run"),
            (("curves", "nowhere"), "give the directory of a run"),
            (("curves", run, "--from", "1"), "use an earlier --from"),
            (("wear", run, "--from", "1"), "use an earlier --from"),
            (("wear", bare), "has no output.liners.wear_coefficient; give --coefficient"),
            (("machine", run, "--from", "1"), "use an earlier --from"),
            (("drives", run, "--smooth", "1"), "use a shorter time"),
            (("accuracy", run / "summary.json"), "bench accuracy --json"),
            (("library", MEASURED), "paper_library.py --json"),
            (("levels", MEASURED), "levels.py --json"),
            (("series", run, "--out", "/nowhere/picture.png"), "name another file with --out"),
        ):
            with self.subTest(arguments=arguments):
                said = io.StringIO()
                with self.assertRaises(SystemExit) as ended, contextlib.redirect_stderr(said):
                    self.plot(*arguments)
                self.assertEqual(ended.exception.code, 2)
                self.assertIn(f"plot.py: {arguments[0]}: ", said.getvalue())
                self.assertIn(advice, said.getvalue())


class Missing(unittest.TestCase):
    """Python without Debian's packages (-S), and a machine without the programs."""

    def assert_asks_for(self, packages, *words, **options):
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False, **options)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn(f"`apt-get install --no-install-recommends {packages}`", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)

    def test_packages_of_python(self):
        self.assert_asks_for("python3-numpy python3-matplotlib python3-h5py python3-yaml",
                             "/usr/bin/python3", "-S", SCRIPTS / "plot.py")

    def test_programs(self):
        with tempfile.TemporaryDirectory() as empty:
            self.assert_asks_for("nvidia-cuda-toolkit binutils", sys.executable, SCRIPTS / "kernel_report.py",
                                 env={"PATH": empty})


if __name__ == "__main__":
    unittest.main()

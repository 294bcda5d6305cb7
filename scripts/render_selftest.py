#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests render.py: what the camera frames, loads on walls as numbers, and pictures of a small made-up run. Skipped without
VTK; the pictures also without a display or xvfb."""
import argparse
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent
MISSING = [name for name in ("numpy", "vtkmodules") if importlib.util.find_spec(name) is None]
DISPLAY = os.environ.get("DISPLAY") or (shutil.which("xvfb-run") and shutil.which("xauth"))
SECTORS = 48
TIME = 0.36  # of the frame [s]

if not MISSING:
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkIOImage import vtkPNGReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    from rendering import camera, files, walls
    from rendering.colours import end_of_scale, prefix_of


def poly_data(points, cells=(), lines=(), point_fields=None, cell_fields=None):
    data, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(np.asarray(points, np.float32), deep=True))
    data.SetPoints(places)
    for given, setter in ((cells, data.SetPolys), (lines, data.SetLines)):
        array = vtkCellArray()
        for cell in given:
            array.InsertNextCell(len(cell), [int(corner) for corner in cell])
        setter(array)
    for fields, to in ((point_fields, data.GetPointData()), (cell_fields, data.GetCellData())):
        for name, values in (fields or {}).items():
            array = numpy_to_vtk(np.asarray(values), deep=True)
            array.SetName(name)
            to.AddArray(array)
    return data


def cone(low, high, height):
    """(points, triangles) of a frustum around z, with radii `low` at z = 0 and `high` at the top."""
    angle = np.linspace(0, 2 * np.pi, SECTORS, endpoint=False)
    points = np.concatenate([np.column_stack([r * np.cos(angle), r * np.sin(angle), np.full(SECTORS, z)])
                             for r, z in ((low, 0), (high, height))])
    k = np.arange(SECTORS)
    after = (k + 1) % SECTORS
    lower, upper = np.column_stack([k, after, SECTORS + after]), np.column_stack([k, SECTORS + after, SECTORS + k])
    return points, np.concatenate([lower, upper])


def liner(number, low, high, height, loads=None):
    points, triangles = cone(low, high, height)
    return poly_data(points, triangles, cell_fields={"wall": np.full(len(triangles), number, np.int32), **(loads or {})})


def plane(number):
    points = [[-0.5, -0.5, -0.2], [0.5, -0.5, -0.2], [0.5, 0.5, -0.2], [-0.5, 0.5, -0.2]]
    return poly_data(points, [[0, 1, 2], [0, 2, 3]], cell_fields={"wall": np.full(2, number, np.int32)})


@unittest.skipIf(MISSING, f"needs {', '.join(MISSING)}")
class Camera(unittest.TestCase):
    def test_holds_all_points_and_no_more(self):
        points = np.random.default_rng(1).normal(size=(200, 3)) * [3, 1, 2] + [10, -4, 7]
        frame = camera.Frame(left=0.9, right=0.6, bottom=0.8, top=0.7)
        for azimuth, elevation, aspect in ((-90, 24, 4 / 3), (30, 90, 0.5), (200, -60, 3)):
            with self.subTest(azimuth=azimuth, elevation=elevation):
                placed = camera.place(points, azimuth, elevation, aspect, frame)
                x, y = np.array([camera.on_picture(p, placed, azimuth, elevation, aspect) for p in points]).T
                gaps = [x.min() + frame.left, frame.right - x.max(), y.min() + frame.bottom, frame.top - y.max()]
                self.assertGreater(min(gaps), -1e-9)
                self.assertTrue(max(gaps[:2]) < 1e-9 or max(gaps[2:]) < 1e-9, gaps)  # it fills one direction

    def test_strays_do_not_count(self):
        rock = np.random.default_rng(2).uniform(-1, 1, size=(1000, 3))
        strays = np.concatenate([rock, [[500, 0, 0], [0, -300, 0], [0, 0, 900]]])
        radii = np.append(np.full(1000, 0.1), [7, 7, 7])
        boxes = [camera.box_of_rock(points, radii[:len(points)]) for points in (rock, strays)]
        np.testing.assert_allclose(*boxes, atol=0.02)
        np.testing.assert_allclose(boxes[0], camera.corners([-1.08] * 3, [1.08] * 3), atol=0.02)  # 0.98 and the radius
        self.assertEqual(camera.box_of_rock(strays, radii, share=1).max(), 907)


@unittest.skipIf(MISSING, f"needs {', '.join(MISSING)}")
class Loads(unittest.TestCase):
    def load(self, name, values):
        """({wall: load at each point}, title of the scale) of a cylinder of 1 m x 1 m and a plane"""
        fields = {name: np.asarray(values, np.float32)}
        data = files.split_walls(files.read_walls(self.run_with(liner(0, 1, 1, 1, fields), plane(1)), 0))
        arguments = argparse.Namespace(run="RUNDIR", walls=name, walls_range=None)
        _, title = walls.add_loads(data, arguments, TIME)
        return {number: vtk_to_numpy(wall.GetPointData().GetArray(walls.LOAD)) for number, wall in data.items()}, title

    def run_with(self, moving, fixed):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        (Path(folder.name) / "snapshots").mkdir()
        write(moving, Path(folder.name) / "snapshots/walls_000000.vtp")
        write(fixed, Path(folder.name) / "snapshots/walls_fixed.vtp")
        return Path(folder.name)

    def test_numbers(self):
        area = np.sin(np.pi / SECTORS)  # of a triangle
        for name, value, shown, title in (
            ("pressure", 3e6, 3, "pressure\n[MPa]"),
            ("sliding_work", 2e3 * area, 2, "sliding work\n[kJ/m²]"),
            ("wear", 5e-10, 5, "wear\n[mm per 1000 h]"),  # 0.5 nm in 0.36 s
        ):
            with self.subTest(name=name):
                loads, said = self.load(name, np.full(2 * SECTORS, value))
                self.assertEqual(said, title)
                np.testing.assert_allclose(loads[0], shown, rtol=1e-5)
                self.assertTrue(np.isnan(loads[1]).all())  # planes have no maps

    def test_cells_keep_the_sum(self):
        values = np.zeros(2 * SECTORS)
        values[3] = 8
        corners = walls.triangles(liner(0, 1, 1, 1))
        means = walls.over_cells(corners, values * walls.areas(corners))
        self.assertAlmostEqual(means.sum(), 8)  # the triangles have the same area

    def test_a_plate_has_its_own_values(self):
        points = [[x, y, 0] for y in (0, 0.5) for x in (1, 2, 3)]  # four triangles of 0.25 m2, to one side of the axis
        data = poly_data(points, [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]], cell_fields={
            "wall": np.zeros(4, np.int32), "sliding_work": [1.0, 2, 3, 4], "pressure": [5.0, 6, 7, 8]})
        self.assertEqual(list(walls.loads_of(data, "sliding_work", TIME)), [4, 8, 12, 16])
        self.assertEqual(list(walls.loads_of(data, "pressure", TIME)), [5, 6, 7, 8])

    def test_scales(self):
        self.assertEqual([end_of_scale(np.array([x]), 1) for x in (0.0, 1.05, 2.4, 7e5, 9.5)], [1, 1.2, 2.4, 8e5, 10])
        self.assertEqual([prefix_of(x)[0] for x in (0, 3e-5, 0.02, 5, 4e3, 2e6, 3e9)], ["", "µ", "m", "", "k", "M", "G"])


def write(data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()


@unittest.skipIf(MISSING, f"needs {', '.join(MISSING)}")
class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.run_dir = Path(folder.name)
        (self.run_dir / "snapshots").mkdir()

    def write_frame(self, stray=(), machine=True, loads=None):
        """Rock of 0.1 m around the axis 0.3 m above the discharge plane, a few strays, and liners of 1 m."""
        rng = np.random.default_rng(3)
        places = np.concatenate([rng.uniform(-0.05, 0.05, size=(400, 3)) + [0, 0.4, 0.3], np.reshape(stray, (-1, 3))])
        count = len(places)
        write(poly_data(places, point_fields={
            "radius": np.append(np.full(400, 0.01), np.full(count - 400, 0.2)),
            "fragment": np.arange(count, dtype=np.int64), "rock": np.zeros(count, np.int64),
            "velocity": np.ones((count, 3)), "force": np.ones((count, 3))}), self.run_dir / "snapshots/particles_000000.vtp")
        write(poly_data(places[[0, 1, 1, 1]], lines=[[0, 1], [2, 3]],  # one bond of no length
                        point_fields={"radius": np.full(4, 0.01)}, cell_fields={"stress_ratio": [0.5, 0.1]}),
              self.run_dir / "snapshots/bonds_000000.vtp")
        if machine:
            write(liner(1, 0.3, 0.1, 1, loads), self.run_dir / "snapshots/walls_000000.vtp")
            write(liner(0, 0.4, 0.8, 1, loads), self.run_dir / "snapshots/walls_fixed.vtp")
        else:
            write(plane(0), self.run_dir / "snapshots/walls_fixed.vtp")
        (self.run_dir / "particles.pvd").write_text(
            f'<VTKFile><Collection><DataSet timestep="{TIME}" file="snapshots/particles_000000.vtp"/></Collection></VTKFile>')

    def call(self, *options, **environment):
        return subprocess.run([sys.executable, str(SCRIPTS / "render.py"), str(self.run_dir), "--size", "240x180", *options],
                              capture_output=True, text=True, check=False, env={**os.environ, **environment})

    def picture(self, *options):
        """Pixels of the picture, (height, width, 3) from below. Nothing may be said but the file's name."""
        out = self.run_dir / "picture.png"
        done = self.call("--out", str(out), *options)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, f"{out}\n", ""))
        reader = vtkPNGReader()
        reader.SetFileName(str(out))
        reader.Update()
        image = reader.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)

    def extent(self, pixels):
        """(width, height) of what is drawn below the title, as shares of the picture."""
        drawn = (pixels[:int(0.9 * len(pixels))] < 245).any(axis=2)
        return tuple(np.ptp(np.flatnonzero(drawn.any(axis=axis))) / drawn.shape[1 - axis] for axis in (0, 1))


@unittest.skipUnless(DISPLAY, "needs a display or xvfb and xauth")
class Drawn(Pictures):
    def test_strays_do_not_shrink_the_machine(self):
        self.write_frame()
        without = self.extent(self.picture())
        self.assertGreater(max(without), 0.85)
        self.write_frame(stray=[[60, 40, 3], [0, 0, -1e5]])
        np.testing.assert_allclose(self.extent(self.picture()), without, atol=0.02)

    def test_view_all_shows_strays(self):
        self.write_frame(stray=[[9, 1, 0]])
        pixels = self.picture("--view", "all", "--elevation", "0", "--bonds")
        drawn = (pixels[:int(0.9 * len(pixels))] < 245).any(axis=2)
        self.assertLess(drawn.mean(), 0.1)                       # the machine is small
        self.assertGreater(self.extent(pixels[:, :int(0.86 * pixels.shape[1])])[0], 0.8)

    def test_rock_without_a_machine(self):
        self.write_frame(stray=[[9, 0, 0]], machine=False)
        pixels = self.picture("--color", "velocity")
        dense = (np.ptp(pixels, axis=2) > 60)                    # coloured, while the plane is grey
        self.assertGreater(dense[:, :int(0.8 * pixels.shape[1])].mean(), 0.2)

    def test_loads_colour_the_walls(self):
        for worn in (0, 1e-9):
            self.write_frame(loads={"wear": np.full(2 * SECTORS, worn)})
            pixels = self.picture("--walls", "wear", "--walls-range", "0", "20")
            middle = pixels[60:80, 80:90].mean(axis=(0, 1))      # on the mantle, in front
            self.assertEqual(middle[0] - middle[2] > 40, worn > 0, middle)  # reddish, or steel


class Refused(Pictures):
    def assert_refused(self, advice, *options, **environment):
        done = self.call(*options, **environment)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(advice, done.stderr)

    def test_bad_input_is_explained(self):
        self.assert_refused("give the directory of a run with snapshots")
        self.write_frame()
        self.assert_refused("use 0 to 0", "--frame", "7")
        self.assert_refused("run the case with output.liners.wear_coefficient", "--walls", "wear")
        self.assert_refused("the directory must exist", "--out", "/nowhere/picture.png")
        self.assert_refused("1600x1200 is an example", "--size", "large")
        whole = self.run_dir / "snapshots/particles_000000.vtp"
        whole.write_bytes(whole.read_bytes()[:-200])
        self.assert_refused("is not whole; choose another --frame")

    def test_no_display(self):
        self.write_frame()
        for display in ("", ":987"):  # none, and one that does not answer
            self.assert_refused("run `apt-get install --no-install-recommends xvfb xauth` as root", PATH="/nowhere",
                                DISPLAY=display)


class Missing(unittest.TestCase):
    def test_packages_of_python(self):
        done = subprocess.run(["/usr/bin/python3", "-S", str(SCRIPTS / "render.py"), "nowhere"], capture_output=True,
                              text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("run `apt-get install --no-install-recommends python3-numpy python3-vtk9` as root", done.stderr)


if __name__ == "__main__":
    unittest.main()

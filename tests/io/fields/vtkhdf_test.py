#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares fields.h5 of a run, as VTK's reader of VTKHDF gives it, with the run's .vtp files, number by number.

  vtkhdf_test.py PROGRAM CASE      runs the case; or: vtkhdf_test.py RUNDIR

Needs VTK 9.3 or newer with its Python package (PyPI: vtk), else it is skipped (exit code 77).
"""
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    import numpy
    import vtkmodules.all as vtk
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError:
    sys.exit(77)

NAMES_IN_PVD = {"particles": ("particles", "particles_"), "bonds": ("bonds", "bonds_"),
                "fragments": ("fragments", "fragments_"), "liners": ("walls", "walls_0"),
                "liners_fixed": ("walls", "walls_fixed")}


def frames_of(run, kind):
    """Times and .vtp files of a kind."""
    index, prefix = NAMES_IN_PVD[kind]
    entries = ElementTree.parse(run / f"{index}.pvd").getroot().iter("DataSet")
    return [(float(e.get("timestep")), run / e.get("file")) for e in entries
            if pathlib.Path(e.get("file")).name.startswith(prefix)]


def arrays_of(data):
    """All numbers of PolyData by name."""
    arrays = {"points": vtk_to_numpy(data.GetPoints().GetData())} if data.GetNumberOfPoints() else {}
    for name, cells in (("verts", data.GetVerts()), ("lines", data.GetLines()), ("polys", data.GetPolys())):
        arrays[name] = vtk_to_numpy(cells.GetConnectivityArray())
        arrays[name + " ends"] = vtk_to_numpy(cells.GetOffsetsArray())
    for kind, fields in (("point", data.GetPointData()), ("cell", data.GetCellData())):
        for k in range(fields.GetNumberOfArrays()):
            arrays[f"{kind} {fields.GetArrayName(k)}"] = vtk_to_numpy(fields.GetArray(k))
    return arrays


def vtp(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def compare(path, frames):
    reader = vtk.vtkHDFReader()
    if not reader.CanReadFile(str(path)):
        raise SystemExit(f"{path}: VTK cannot read it")
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    assert reader.GetNumberOfSteps() == len(frames), (path, reader.GetNumberOfSteps(), len(frames))
    numbers = 0
    for step, (time, file) in enumerate(frames):
        reader.SetStep(step)
        reader.Update()
        assert abs(reader.GetTimeValue() - time) <= 1e-11 * max(time, 1), (path, reader.GetTimeValue(), time)
        ours, theirs = arrays_of(reader.GetOutputDataObject(0)), arrays_of(vtp(file))
        assert ours.keys() == theirs.keys(), (path, ours.keys() ^ theirs.keys())
        for name, values in ours.items():
            assert numpy.array_equal(values, theirs[name], equal_nan=values.dtype.kind == "f"), (path, step, name)
            numbers += values.size
    return numbers


def main():
    if vtk.vtkVersion().GetVTKMajorVersion() * 100 + vtk.vtkVersion().GetVTKMinorVersion() < 903:
        return 77
    with tempfile.TemporaryDirectory() as folder:
        run = pathlib.Path(sys.argv[1])
        if len(sys.argv) > 2:
            run = pathlib.Path(folder) / "run"
            subprocess.run([sys.argv[1], "run", sys.argv[2], "--out", str(run), "--quiet", "--threads", "1", "--until", "40 ms",
                            "--set", "output.formats=[vtp, hdf5]", "--set", "output.snapshots=10 ms", *sys.argv[3:]],
                           check=True)
        for kind in NAMES_IN_PVD:
            if (run / "fields" / f"{kind}.vtkhdf").exists():
                frames = frames_of(run, kind)
                print(f"{kind}: {compare(run / 'fields' / f'{kind}.vtkhdf', frames)} numbers in {len(frames)} frames")
        compare(run / "fields.h5", frames_of(run, "particles"))
    return 0


if __name__ == "__main__":
    sys.exit(main())

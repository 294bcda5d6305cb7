# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a snapshot of a run directory."""
import xml.etree.ElementTree as ElementTree

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from errors import fail


def find_frame(run, number):
    """(number, time) of a frame, from the index of the particles or else of the walls."""
    for kind in ("particles", "walls"):
        index = run / f"{kind}.pvd"
        if index.exists():
            frames = times_in(index)
            if not -len(frames) <= number < len(frames):
                fail(f"{run} has no frame {number}; use 0 to {len(frames) - 1}" if frames else
                     f"{run} has no frame yet; wait for the first one (output.snapshots)")
            return range(len(frames))[number], float(frames[number])
    fail(f"{run} has no particles.pvd; give the directory of a run with snapshots")


def times_in(index):
    try:
        sets = ElementTree.parse(index).getroot().findall(".//DataSet")
    except ElementTree.ParseError as error:
        fail(f"{index} cannot be read ({error}); give the directory of a run with snapshots")
    return list(dict.fromkeys(item.get("timestep") for item in sets))  # a frame may have several files


def read_file(path):
    """A file of snapshots/, or None when there is none."""
    if not path.exists():
        return None
    with open(path, "rb") as file:
        file.seek(max(0, path.stat().st_size - 64))
        if b"</VTKFile>" not in file.read():
            fail(f"{path} is not whole; choose another --frame")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read(run, kind, frame):
    return read_file(run / "snapshots" / f"{kind}_{frame:06d}.vtp")


def names_of_cells(data):
    fields = data.GetCellData()
    return [fields.GetArrayName(k) for k in range(fields.GetNumberOfArrays())]


def add_cell_field(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetCellData().AddArray(array)


def read_walls(run, frame):
    """The walls of a frame, with those that are the same in all frames; None without any."""
    found = [data for data in (read(run, "walls", frame), read_file(run / "snapshots" / "walls_fixed.vtp")) if data]
    if not found:
        return None
    kinds = {name: cell_field(data, name).dtype for data in found for name in names_of_cells(data)}
    together = vtkAppendPolyData()
    for data in found:
        for name in kinds.keys() - names_of_cells(data):  # or the field would be lost to all
            add_cell_field(data, name, np.full(data.GetNumberOfCells(), np.nan, kinds[name]))
        together.AddInputData(data)
    together.Update()
    return together.GetOutput()


def cells_where(data, name, value):
    """The cells whose field has this value."""
    threshold = vtkThreshold()
    threshold.SetInputData(data)
    threshold.SetInputArrayToProcess(0, 0, 0, 1, name)
    threshold.SetLowerThreshold(value - 0.5)
    threshold.SetUpperThreshold(value + 0.5)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(threshold.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def split_walls(data):
    """The walls of a snapshot by their numbers."""
    if data is None or data.GetNumberOfCells() == 0:
        return {}
    numbers = np.unique(cell_field(data, "wall"))
    return {int(number): cells_where(data, "wall", number) for number in numbers}


def positions(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def field(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def cell_field(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))

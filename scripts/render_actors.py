# SPDX-License-Identifier: GPL-3.0-or-later
"""What render.py draws: particles, bonds and walls of a snapshot as VTK actors."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import (vtkAppendPolyData, vtkClipPolyData, vtkCutter, vtkPolyDataNormals, vtkStripper, vtkThreshold,
                                       vtkTubeFilter)
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

# Stone, ochre, rust, slate and moss: neighbours differ, nothing shouts.
PALETTE = ["#c9a26b", "#8c5a3c", "#5b7a8c", "#d9c08a", "#a3453a", "#6f8f6a", "#3f5d73", "#b98b5e", "#7d6a8a",
           "#c77b4a", "#93a7b0", "#54745a", "#e0b15a", "#7a4b4b", "#4f8a8b", "#a89a7d", "#b5654d", "#66708c"]
FINES = "#b9b2a4"  # fragments of one particle, in scenes that have larger ones
VIRIDIS = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"]


def rgb(text):
    return tuple(int(text[k:k + 2], 16) / 255 for k in (1, 3, 5))


def read_file(path):
    """A file of snapshots/, or None when there is none."""
    if not path.exists():
        return None
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read(run, kind, frame):
    return read_file(run / "snapshots" / f"{kind}_{frame:06d}.vtp")


def read_walls(run, frame):
    """The walls of a frame, with those that are the same in all frames."""
    found = [data for data in (read(run, "walls", frame), read_file(run / "snapshots" / "walls_fixed.vtp")) if data]
    if not found:
        return None
    together = vtkAppendPolyData()
    for data in found:
        together.AddInputData(data)
    together.Update()
    return together.GetOutput()


def field(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def category_colours(names, fines):
    """Fixed pseudo-random palette entries, so that a fragment keeps its colour over frames."""
    hashed = (names.astype(np.uint64) * np.uint64(2654435761)) & np.uint64(0xFFFFFFFF)
    palette = np.array([rgb(colour) for colour in PALETTE])
    colours = palette[(hashed >> np.uint64(16)) % np.uint64(len(palette))]
    colours *= (0.9 + 0.2 * ((hashed & np.uint64(255)) / 255.0))[:, None]
    if fines:
        _, place, count = np.unique(names, return_inverse=True, return_counts=True)
        if count.size and count.max() > 1:
            colours[count[place] == 1] = rgb(FINES)
    return np.clip(255 * colours, 0, 255).astype(np.uint8)


def scale_of(low, high):
    """Viridis between two values."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    stops = np.array([rgb(colour) for colour in VIRIDIS])
    for k in range(256):
        at = k / 255 * (len(stops) - 1)
        table.SetTableValue(k, *(np.interp(at, range(len(stops)), stops[:, c]) for c in range(3)), 1)
    table.SetTableRange(low, high if high > low else low + 1)
    return table


def in_front(points, arguments):
    """Which points lie on the camera's side of the axis."""
    azimuth = np.radians(arguments.azimuth)
    return points[:, 0] * np.cos(azimuth) + points[:, 1] * np.sin(azimuth) > 0


def points_only(positions):
    """PolyData of points, each in a cell of its own: the mapper of spheres draws vertices."""
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(positions, deep=True))
    count = len(positions)
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(count + 1, dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.arange(count, dtype=np.int64), deep=True))
    data.SetPoints(points)
    data.SetVerts(cells)
    return data


def particle_actor(particles, arguments):
    """(actor, colour scale or None)."""
    positions = vtk_to_numpy(particles.GetPoints().GetData())
    keep = np.ones(len(positions), bool)
    if arguments.cut == "half":
        keep = ~in_front(positions, arguments)
    shown, table = points_only(positions[keep]), None
    radius = numpy_to_vtk((0.45 if arguments.bonds else 1) * field(particles, "radius")[keep], deep=True)
    radius.SetName("radius")
    shown.GetPointData().AddArray(radius)
    if arguments.color in ("fragment", "rock"):
        values = category_colours(field(particles, arguments.color), arguments.color == "fragment")[keep]
    else:
        values = np.linalg.norm(field(particles, arguments.color), axis=1)[keep]
        # The top per mille is left out of the scale: one impact would make all others look still.
        high = float(np.quantile(values, 0.999)) if values.size else 1
        table = scale_of(*(arguments.range or (0, high)))
    colours = numpy_to_vtk(values, deep=True)
    colours.SetName("colour")
    shown.GetPointData().SetScalars(colours)
    mapper = vtkOpenGLSphereMapper()
    mapper.SetInputData(shown)
    mapper.SetScaleArray("radius")
    if table:
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    set_finish(actor, ambient=0.22, diffuse=0.85, specular=0.08, power=12)
    return actor, table


def set_finish(actor, ambient, diffuse, specular, power):
    finish = actor.GetProperty()
    finish.SetAmbient(ambient)
    finish.SetDiffuse(diffuse)
    finish.SetSpecular(specular)
    finish.SetSpecularPower(power)


def bond_actor(bonds, arguments):
    """Tubes, coloured by how near the bond is to failure."""
    ends = vtk_to_numpy(bonds.GetPoints().GetData())
    if arguments.cut == "half":
        hidden = in_front(ends, arguments).reshape(-1, 2).any(axis=1)
        shown = numpy_to_vtk((~hidden).astype(np.uint8), deep=True)
        shown.SetName("shown")
        bonds.GetCellData().AddArray(shown)
        bonds = cells_where(bonds, "shown", 1)
    thin = numpy_to_vtk(0.45 * field(bonds, "radius"), deep=True)
    thin.SetName("thin")
    bonds.GetPointData().SetScalars(thin)
    tubes = vtkTubeFilter()
    tubes.SetInputData(bonds)
    tubes.SetNumberOfSides(8)
    tubes.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("stress_ratio")
    table = scale_of(0, 1)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor, table


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


def innermost(walls):
    """The wall inside others that stand around the same axis: the mantle; None where there is none."""
    radii = {}
    for number, wall in walls.items():
        points = vtk_to_numpy(wall.GetPoints().GetData())
        around = np.unique(np.arctan2(points[:, 1], points[:, 0]) % (2 * np.pi) // (np.pi / 4) % 8)
        if around.size == 8:
            radii[number] = np.hypot(points[:, 0], points[:, 1]).mean()
    return min(radii, key=radii.get) if len(radii) > 1 else None


def split_walls(data):
    """The walls of a snapshot by their numbers."""
    if data is None or data.GetNumberOfCells() == 0:
        return {}
    numbers = np.unique(vtk_to_numpy(data.GetCellData().GetArray("wall")))
    return {int(number): cells_where(data, "wall", number) for number in numbers}


def wall_actors(walls, arguments):
    """Outer liners see-through and cut open with the section drawn; the mantle solid."""
    mantle = innermost(walls)
    azimuth = np.radians(arguments.azimuth)
    plane = vtkPlane()
    plane.SetNormal(-np.cos(azimuth), -np.sin(azimuth), 0)
    actors = []
    for number, wall in walls.items():
        normals = vtkPolyDataNormals()
        normals.SetInputData(wall)
        normals.SetFeatureAngle(35)
        surface = normals
        if number != mantle and arguments.cut != "none":
            surface = vtkClipPolyData()
            surface.SetInputConnection(normals.GetOutputPort())
            surface.SetClipFunction(plane)
            actors.append(section_actor(wall, plane))
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(surface.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        steel = actor.GetProperty()
        if number == mantle:
            steel.SetColor(0.74, 0.77, 0.81)
            set_finish(actor, ambient=0.18, diffuse=0.8, specular=0.3, power=25)
        else:
            steel.SetColor(0.55, 0.62, 0.70)
            steel.SetOpacity(0.35)
            set_finish(actor, ambient=0.35, diffuse=0.6, specular=0.2, power=20)
        actors.append(actor)
    return actors


def section_actor(wall, plane):
    """The line in which a wall is cut."""
    cutter = vtkCutter()
    cutter.SetInputData(wall)
    cutter.SetCutFunction(plane)
    lines = vtkStripper()
    lines.SetInputConnection(cutter.GetOutputPort())
    tube = vtkTubeFilter()
    tube.SetInputConnection(lines.GetOutputPort())
    tube.SetRadius(0.003 * wall.GetLength())
    tube.SetNumberOfSides(12)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.25, 0.29, 0.34)
    return actor

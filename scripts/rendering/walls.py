# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls of a snapshot as VTK actors: steel, or coloured by what the rock does to them."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import (vtkCleanPolyData, vtkClipPolyData, vtkCutter, vtkFeatureEdges, vtkPolyDataNormals,
                                       vtkStripper, vtkTubeFilter)
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from errors import fail
from rendering.colours import STEEL, end_of_scale, prefix_of, scale_of
from rendering.files import cell_field, names_of_cells, positions
from rendering.rocks import in_front, set_finish

MM_PER_1000_H = 1e3 * 1000 * 3600  # of 1 m/s
UNITS = {"pressure": "Pa", "sliding_work": "J/m²", "wear": "mm per 1000 h"}  # without prefix
SHOWN = 0.98                # share of the loaded surface that the scale tells apart
ROWS, SECTORS = 48, 72      # of the cells over which loads are averaged
PLANES = 1.1                # how much wider than what is framed planes are drawn
LOAD = "load"


def is_plane(wall):
    """Planes have no end; a snapshot has a square of each, which says nothing about the size of the scene."""
    return wall.GetNumberOfCells() <= 2


def azimuths(points):
    """In turns, 0 to 1."""
    return np.arctan2(points[:, 1], points[:, 0]) / (2 * np.pi) % 1


def is_liner(wall):
    """Whether a wall stands all around the axis."""
    return not is_plane(wall) and np.unique((8 * azimuths(positions(wall))).astype(int) % 8).size == 8


def innermost(walls):
    """The wall inside others that stand around the same axis: the mantle; None where there is none."""
    radii = {number: np.hypot(*positions(wall)[:, :2].T).mean() for number, wall in walls.items() if is_liner(wall)}
    return min(radii, key=radii.get) if len(radii) > 1 else None


def machine_points(walls, arguments):
    """Points of all walls that are no planes, as they are drawn: without what is cut away. Empty without such walls."""
    mantle, found = innermost(walls), [np.empty((0, 3))]
    for number, wall in walls.items():
        if not is_plane(wall):
            points = positions(wall)
            cut = number != mantle and arguments.cut != "none"
            found.append(points[~in_front(points, arguments.azimuth)] if cut else points)
    return np.concatenate(found)


def fit_planes(walls, points):
    """Draws each plane as a rectangle beside `points`, a little wider than these."""
    low, high = points.min(axis=0), points.max(axis=0)
    for wall in walls.values():
        square = positions(wall)
        if not is_plane(wall) or len(square) != 4:
            continue
        a, b = (side / np.linalg.norm(side) for side in (square[1] - square[0], square[3] - square[0]))
        away = (low + high) / 2 - square[0]
        centre = square[0] + (away @ a) * a + (away @ b) * b
        reach = PLANES / 2 * (high - low)
        wide, tall = (np.abs(side) @ reach * side for side in (a, b))
        places = vtkPoints()
        places.SetData(numpy_to_vtk(np.array([centre - wide - tall, centre + wide - tall, centre + wide + tall,
                                              centre - wide + tall]), deep=True))
        wall.SetPoints(places)


def triangles(wall):
    """Corners of the triangles. (n, 3, 3) [m]"""
    return positions(wall)[vtk_to_numpy(wall.GetPolys().GetConnectivityArray()).reshape(-1, 3)].astype(float)


def areas(corners):
    """Of triangles [m2]."""
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


def over_cells(corners, amounts):
    """Amounts of the triangles of a liner by area, as means over cells of its unrolled surface.

    The triangles are much smaller than rocks: each has been hit a few times or never, and their own values are specks.
    """
    area = areas(corners)
    middle = corners.mean(axis=1)
    low, high = middle[:, 2].min(), middle[:, 2].max()
    row = np.minimum((ROWS * (middle[:, 2] - low) / ((high - low) or 1)).astype(int), ROWS - 1)
    cell = row * SECTORS + (SECTORS * azimuths(middle)).astype(int) % SECTORS
    loads, surface = (np.bincount(cell, numbers, ROWS * SECTORS) for numbers in (amounts, area))
    return (loads / np.where(surface > 0, surface, np.nan))[cell]


def at_points(wall, values):
    """Values of the triangles as means at their corners, so that colours run smoothly."""
    corner = vtk_to_numpy(wall.GetPolys().GetConnectivityArray())
    count = wall.GetNumberOfPoints()
    return np.bincount(corner, np.repeat(values, 3), count) / np.maximum(np.bincount(corner, minlength=count), 1)


def loads_of(wall, name, time):
    """Pressure [Pa], sliding work by area [J/m2] or wear [mm per 1000 h] at each triangle; NaN of planes."""
    values, corners = cell_field(wall, name).astype(float), triangles(wall)
    area = areas(corners)
    amounts = values if name == "sliding_work" else values * area
    means = over_cells(corners, amounts) if is_liner(wall) else amounts / np.where(area > 0, area, np.nan)
    return means * (MM_PER_1000_H / time if time > 0 else 0) if name == "wear" else means


def add_loads(walls, arguments, time):
    """Puts what --walls names on the triangles of all walls. (scale, its title); None without --walls"""
    name = arguments.walls
    if not name:
        return None
    if not walls or not all(name in names_of_cells(wall) for wall in walls.values()):
        key = "output.liners.wear_coefficient" if name == "wear" else "output.liners.interval"
        fail(f"the walls of {arguments.run} have no {name}; run the case with {key}")
    loads = {number: loads_of(wall, name, time) for number, wall in walls.items()}
    every = np.concatenate(list(loads.values()))
    low, high = arguments.walls_range or (0, end_of_scale(every[every > 0], SHOWN))
    prefix, factor = ("", 1) if name == "wear" else prefix_of(high)
    for number, values in loads.items():
        array = numpy_to_vtk(factor * at_points(walls[number], values), deep=True)
        array.SetName(LOAD)
        walls[number].GetPointData().AddArray(array)
    return scale_of(factor * low, factor * high, STEEL), f"{name.replace('_', ' ')}\n[{prefix}{UNITS[name]}]"


def wall_actors(walls, arguments, table):
    """Outer liners cut open with the section drawn; the mantle solid. Without a colour scale the outer ones are see-through."""
    mantle, actors = innermost(walls), []
    azimuth = np.radians(arguments.azimuth)
    cut = vtkPlane()
    cut.SetNormal(-np.cos(azimuth), -np.sin(azimuth), 0)
    for number, wall in walls.items():
        if is_plane(wall):
            actors += plane_actors(wall)
            continue
        normals = vtkPolyDataNormals()
        normals.SetInputData(wall)
        normals.SetFeatureAngle(35)
        surface = normals
        if number != mantle and arguments.cut != "none":
            surface = vtkClipPolyData()
            surface.SetInputConnection(normals.GetOutputPort())
            surface.SetClipFunction(cut)
            actors.append(section_actor(wall, cut))
        actor = actor_of(surface)
        if table:
            colour_by_load(actor, table)
        else:
            make_steel(actor, number == mantle)
        actors.append(actor)
    return [actor for actor in actors if actor]


def actor_of(source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def plane_actors(wall):
    """The edge of a plane, and its surface where the camera sees the side of the rock: no plane hides what is behind it."""
    whole = vtkTrivialProducer()
    whole.SetOutput(wall)
    surface = actor_of(whole)
    make_steel(surface, solid=False)
    surface.GetProperty().BackfaceCullingOn()
    edges = vtkFeatureEdges()
    edges.SetInputData(wall)
    edges.ColoringOff()
    edge = actor_of(edges)
    edge.GetProperty().SetColor(0.45, 0.5, 0.56)
    edge.GetProperty().SetLineWidth(3)
    return [surface, edge]


def colour_by_load(actor, table):
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SelectColorArray(LOAD)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    set_finish(actor, ambient=0.45, diffuse=0.6, specular=0.05, power=20)


def make_steel(actor, solid):
    steel = actor.GetProperty()
    if solid:
        steel.SetColor(0.74, 0.77, 0.81)
        set_finish(actor, ambient=0.18, diffuse=0.8, specular=0.3, power=25)
    else:
        steel.SetColor(0.55, 0.62, 0.70)
        steel.SetOpacity(0.35)
        set_finish(actor, ambient=0.35, diffuse=0.6, specular=0.2, power=20)


def section_actor(wall, plane):
    """The line in which a wall is cut; None where it is not."""
    cutter = vtkCutter()
    cutter.SetInputData(wall)
    cutter.SetCutFunction(plane)
    once = vtkCleanPolyData()  # points on top of each other have no direction
    once.SetInputConnection(cutter.GetOutputPort())
    once.ConvertLinesToPointsOff()
    lines = vtkStripper()
    lines.SetInputConnection(once.GetOutputPort())
    lines.Update()
    if lines.GetOutput().GetNumberOfLines() == 0:
        return None
    tube = vtkTubeFilter()
    tube.SetInputConnection(lines.GetOutputPort())
    tube.SetRadius(0.003 * wall.GetLength())
    tube.SetNumberOfSides(12)
    actor = actor_of(tube)
    actor.GetProperty().SetColor(0.25, 0.29, 0.34)
    return actor

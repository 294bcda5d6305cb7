# SPDX-License-Identifier: GPL-3.0-or-later
"""Particles and bonds of a snapshot as VTK actors."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

from rendering.colours import category_colours, end_of_scale, prefix_of, scale_of
from rendering.files import add_cell_field, cells_where, field, positions

THIN = 0.45  # of its radius is drawn of a particle or bond in a picture of bonds
QUANTITIES = {"velocity": ("speed", "m/s"), "force": ("force", "N")}
# The top per mille is left out of the scale: one impact would make all others look still.
SHOWN = 0.999


def in_front(points, azimuth):
    """Which points lie on the camera's side of the axis."""
    azimuth = np.radians(azimuth)
    return points[:, 0] * np.cos(azimuth) + points[:, 1] * np.sin(azimuth) > 0


def points_only(places):
    """PolyData of points, each in a cell of its own: the mapper of spheres draws vertices."""
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(places, deep=True))
    count = len(places)
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(count + 1, dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.arange(count, dtype=np.int64), deep=True))
    data.SetPoints(points)
    data.SetVerts(cells)
    return data


def shown_particles(particles, arguments, near):
    """Which particles are drawn: those behind the cut, and of strays those that the picture may show.

    @param near  (centre, distance): what lies farther away is left out
    """
    places = positions(particles)
    keep = np.linalg.norm(places - near[0], axis=1) < near[1]
    return keep & ~in_front(places, arguments.azimuth) if arguments.cut == "half" else keep


def colours_of(particles, keep, arguments):
    """(colour or number of each particle, scale or None, title of the scale)"""
    if arguments.color not in QUANTITIES:
        return category_colours(field(particles, arguments.color), arguments.color == "fragment")[keep], None, ""
    values = np.linalg.norm(field(particles, arguments.color), axis=1).astype(float)[keep]
    low, high = arguments.range or (0, end_of_scale(values, SHOWN))
    name, units = QUANTITIES[arguments.color]
    prefix, factor = prefix_of(high)
    return factor * values, scale_of(factor * low, factor * high), f"{name} [{prefix}{units}]"


def particle_actor(particles, arguments, near):
    """(actor, colour scale or None, title of the scale); None where no particle is shown."""
    keep = shown_particles(particles, arguments, near)
    if not keep.any():
        return None
    shown = points_only(positions(particles)[keep])
    radius = (THIN if arguments.bonds else 1) * field(particles, "radius")[keep]
    radius = numpy_to_vtk(radius.astype(np.float32), deep=True)  # the mapper reads nothing else
    radius.SetName("radius")
    shown.GetPointData().AddArray(radius)
    values, table, title = colours_of(particles, keep, arguments)
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
    return actor, table, title


def set_finish(actor, ambient, diffuse, specular, power):
    finish = actor.GetProperty()
    finish.SetAmbient(ambient)
    finish.SetDiffuse(diffuse)
    finish.SetSpecular(specular)
    finish.SetSpecularPower(power)


def bond_actor(bonds, arguments, near):
    """(tubes, coloured by how near the bond is to failure, their scale, its title); None where no bond is shown."""
    ends = positions(bonds) if bonds.GetNumberOfCells() else np.empty((0, 3))
    hidden = np.linalg.norm(ends - near[0], axis=1) > near[1]
    if arguments.cut == "half":
        hidden |= in_front(ends, arguments.azimuth)
    hidden |= np.linalg.norm(ends - np.roll(ends.reshape(-1, 2, 3), 1, axis=1).reshape(-1, 3), axis=1) == 0  # no direction
    hidden = hidden.reshape(-1, 2).any(axis=1)
    if hidden.all():
        return None
    add_cell_field(bonds, "shown", (~hidden).astype(np.uint8))
    bonds = cells_where(bonds, "shown", 1)
    thin = numpy_to_vtk(THIN * field(bonds, "radius"), deep=True)
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
    return actor, table, "stress / strength"

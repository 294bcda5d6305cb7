#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws one snapshot of a run directory as a PNG: rocks as spheres of true radius, liners cut open.

Usage: render.py RUNDIR [--frame N] [--out FILE.png] [--color fragment|rock|velocity|force]
                 [--cut none|liners|half] [--bonds] [--size WIDTHxHEIGHT] ...

Needs python3-vtk9; without a display it starts itself again under xvfb-run.
"""
import argparse
import json
import os
import shutil
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the text)
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

from render_actors import bond_actor, innermost, particle_actor, read, read_walls, split_walls, wall_actors


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws one snapshot of a run directory as a PNG.")
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--frame", type=int, default=-1, help="number of the snapshot; negative counts from the last")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/frame_NNNNNN.png")
    parser.add_argument("--color", choices=["fragment", "rock", "velocity", "force"], default="fragment")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="of velocity or force")
    parser.add_argument("--cut", choices=["none", "liners", "half"],
                        help="what is cut away in front: nothing, the outer liners, or rocks too; "
                             "default: half of a crusher, nothing of other scenes")
    parser.add_argument("--bonds", action="store_true", help="also draw bonds as thin tubes; particles and bonds at 0.45 of their radius")
    parser.add_argument("--size", default="1600x1200", help="pixels, WIDTHxHEIGHT")
    parser.add_argument("--azimuth", type=float, default=-90, help="of the camera [degrees]")
    parser.add_argument("--elevation", type=float, default=24, help="of the camera [degrees]")
    parser.add_argument("--zoom", type=float, default=1)
    parser.add_argument("--title", help="default: the title in summary.json")
    arguments = parser.parse_args()
    try:
        arguments.width, arguments.height = (int(part) for part in arguments.size.split("x"))
    except ValueError:
        parser.error(f"--size {arguments.size} is not WIDTHxHEIGHT; 1600x1200 is an example")
    return arguments


def ensure_display():
    """Debian's VTK opens an X window even off screen."""
    if os.environ.get("DISPLAY"):
        return
    if not shutil.which("xvfb-run"):
        sys.exit("render.py: there is no display; set DISPLAY or install xvfb")
    os.execvp("xvfb-run", ["xvfb-run", "-a", "/usr/bin/python3", *sys.argv])


def find_frame(run, number):
    """(number, time) of a frame, from the index of the particles or else of the walls."""
    for kind in ("particles", "walls"):
        index = run / f"{kind}.pvd"
        if index.exists():
            sets = ElementTree.parse(index).getroot().findall(".//DataSet")
            frames = list(dict.fromkeys(item.get("timestep") for item in sets))  # a frame may have several files
            if not -len(frames) <= number < len(frames):
                sys.exit(f"render.py: {run} has no frame {number}; use 0 to {len(frames) - 1}")
            return range(len(frames))[number], float(frames[number])
    sys.exit(f"render.py: {run} has no particles.pvd; give the directory of a run with snapshots")


def text_actor(text, size, x, y):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    style = actor.GetTextProperty()
    style.SetColor(0.2, 0.23, 0.27)
    style.SetFontSize(size)
    style.SetVerticalJustificationToTop()
    style.SetLineSpacing(1.25)
    return actor


def legend(table, title, height):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(title)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.9, 0.2)
    bar.SetWidth(0.07)
    bar.SetHeight(0.45)
    bar.SetBarRatio(0.25)
    bar.SetTextPad(height // 250)
    bar.UnconstrainedFontSizeOn()
    for style, size in ((bar.GetTitleTextProperty(), height // 50), (bar.GetLabelTextProperty(), height // 58)):
        style.SetColor(0.2, 0.23, 0.27)
        style.SetFontSize(size)
        style.ItalicOff()
        style.BoldOff()
        style.ShadowOff()
    return bar


def light(renderer, azimuth, elevation, strength, colour=(1, 1, 1)):
    """A far light that stays where it is relative to the camera."""
    a, e = np.radians(azimuth), np.radians(elevation)
    lamp = vtkLight()
    lamp.SetLightTypeToCameraLight()
    lamp.SetPosition(np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e))
    lamp.SetFocalPoint(0, 0, 0)
    lamp.SetIntensity(strength)
    lamp.SetColor(*colour)
    renderer.AddLight(lamp)


def place_camera(renderer, arguments):
    a, e = np.radians(arguments.azimuth), np.radians(arguments.elevation)
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(24)
    centre = renderer.ComputeVisiblePropBounds()
    focus = np.array([(centre[2 * k] + centre[2 * k + 1]) / 2 for k in range(3)])
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(focus + [np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)]))
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Dolly(1.3 * arguments.zoom)  # ResetCamera leaves room for a whole sphere around the scene
    renderer.ResetCameraClippingRange()


def add_shading(renderer, length):
    """Ambient occlusion: creases between rocks are dark, as under an overcast sky."""
    occlusion = vtkSSAOPass()
    occlusion.SetRadius(0.035 * length)
    occlusion.SetBias(0.0007 * length)
    occlusion.SetKernelSize(96)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtkRenderStepsPass())
    renderer.SetPass(occlusion)


def write_image(window, path):
    """Draws at twice the size and averages, which also smooths the edges of spheres."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferTypeToRGB()
    grab.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetShrinkFactors(2, 2, 1)
    shrink.MeanOn()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(shrink.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode():
        sys.exit(f"render.py: {path} cannot be written")


def title_of(arguments):
    if arguments.title is not None:
        return arguments.title
    try:
        return json.loads((arguments.run / "summary.json").read_text()).get("title") or ""
    except (OSError, ValueError):
        return ""


def main():
    arguments = parse_arguments()
    ensure_display()
    frame, time = find_frame(arguments.run, arguments.frame)
    out = arguments.out or arguments.run / f"frame_{frame:06d}.png"
    if not os.access(out.parent, os.W_OK):
        sys.exit(f"render.py: {out} cannot be written; the directory must exist and be writable")
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    height = 2 * arguments.height
    particles, walls = read(arguments.run, "particles", frame), split_walls(read_walls(arguments.run, frame))
    if arguments.cut is None:
        arguments.cut = "none" if innermost(walls) is None else "half"
    bonds = read(arguments.run, "bonds", frame) if arguments.bonds else None
    table = None
    if particles:
        actor, table = particle_actor(particles, arguments)
        renderer.AddActor(actor)
        if table:
            title = "speed [m/s]\n" if arguments.color == "velocity" else "force [N]\n"
            renderer.AddActor2D(legend(table, title, height))
    if bonds:
        actor, bond_table = bond_actor(bonds, arguments)
        renderer.AddActor(actor)
        if not table:
            renderer.AddActor2D(legend(bond_table, "stress ratio\n", height))
    for actor in wall_actors(walls, arguments):
        renderer.AddActor(actor)
    title = title_of(arguments)
    label = f"t = {time:.3f} s"
    renderer.AddActor2D(text_actor(f"{title}\n{label}" if title else label, height // 42, 0.025, 0.975))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(2 * arguments.width, height)
    window.AddRenderer(renderer)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(6)
    window.SetAlphaBitPlanes(1)
    renderer.RemoveAllLights()
    light(renderer, -40, 20, 0.75, (1, 0.98, 0.94))
    light(renderer, 10, -10, 0.4, (0.94, 0.97, 1))
    light(renderer, 20, 70, 0.35)
    place_camera(renderer, arguments)
    bounds = np.array(renderer.ComputeVisiblePropBounds())
    add_shading(renderer, float(np.linalg.norm(bounds[1::2] - bounds[::2])))
    window.Render()
    write_image(window, out)
    print(out)


if __name__ == "__main__":
    main()

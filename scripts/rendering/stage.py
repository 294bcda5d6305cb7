# SPDX-License-Identifier: GPL-3.0-or-later
"""Window, lights, shading and text of a picture, and its file."""
import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the text)
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

from errors import fail
from rendering.camera import VIEW_ANGLE
from rendering.colours import TEXT

OVERSAMPLING = 2  # drawn so many times as large and averaged, which also smooths the edges of spheres
FAR = 3           # times the size of what is framed: farther away nothing is drawn


def title_actor(text, width, height):
    """Text in the upper left corner, small enough for its longest line. @param width, height  of the window [pixels]"""
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.025, 0.98)
    style = actor.GetTextProperty()
    style.SetColor(*TEXT)
    style.SetFontSize(min(height // 42, int(1.7 * width / max(map(len, text.split("\n"))))))
    style.SetVerticalJustificationToTop()
    style.SetLineSpacing(1.25)
    return actor


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


def set_camera(renderer, placed, length):
    """@param placed  what camera.place() returns; length  of the diagonal of what is framed [m]"""
    position, focus, up, distance = placed
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(VIEW_ANGLE)
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focus)
    camera.SetViewUp(*up)
    camera.SetClippingRange(max(distance - FAR * length, 0.01 * distance), distance + FAR * length)


def add_shading(renderer, length):
    """Ambient occlusion: creases between rocks are dark, as under an overcast sky."""
    occlusion = vtkSSAOPass()
    occlusion.SetRadius(0.035 * length)
    occlusion.SetBias(0.002 * length)
    occlusion.SetKernelSize(96)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtkRenderStepsPass())
    renderer.SetPass(occlusion)


def draw(actors, annotations, width, height, placed, length):
    """The window with the picture drawn. @param width, height  of the window [pixels]"""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    for actor in annotations:
        renderer.AddActor2D(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(6)
    window.SetAlphaBitPlanes(1)
    renderer.RemoveAllLights()
    light(renderer, -40, 20, 0.75, (1, 0.98, 0.94))
    light(renderer, 10, -10, 0.4, (0.94, 0.97, 1))
    light(renderer, 20, 70, 0.35)
    set_camera(renderer, placed, length)
    add_shading(renderer, length)
    window.Render()
    return window


def write_image(window, path):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferTypeToRGB()
    grab.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetShrinkFactors(OVERSAMPLING, OVERSAMPLING, 1)
    shrink.MeanOn()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(shrink.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode():
        fail(f"{path} cannot be written; name another file with --out")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows a run in ParaView: particles as spheres, bonds as tubes, liners cut open.

As a macro: Macros > Import new macro, choose this file. Then open a file of a run (particles.pvd, or fields/particles.xdmf or
.vtkhdf) and click on the macro. Without a window: xvfb-run -a pvbatch paraview_run.py RUNDIR [PICTURE.png [TIME]].

Colours: particles by fragment, bonds by the share of their strength that is used, liners by the pressure of the rock where
the run has output.liners. Needs ParaView 5.11 (Debian 12) or newer.
"""
import pathlib
import sys

import paraview.simple as pv

KINDS = {"particles": ("particles.pvd", "fields/particles"), "bonds": ("bonds.pvd", "fields/bonds"),
         "liners": ("walls.pvd", "fields/liners"), "liners_fixed": (None, "fields/liners_fixed")}


def directory_of_run(file):
    """The directory of the run that a file belongs to."""
    path = pathlib.Path(file).resolve()
    for folder in (path, *path.parents):
        if (folder / "results.h5").exists():
            return folder
    raise RuntimeError(f"{file}: belongs to no run of gyrosim (there is no results.h5 beside it)")


def opened_file():
    """File of the source that is selected in the window."""
    source = pv.GetActiveSource()
    name = getattr(source, "FileName", None) if source else None
    if not name:
        raise RuntimeError("open a file of a run first, such as particles.pvd")
    return name if isinstance(name, str) else name[0]


def open_kind(run, kind, suffix):
    """Source of a kind of data, or None. suffix: of the files of fields.h5 to open, or .pvd."""
    pvd, fields = KINDS[kind]
    path = run / pvd if suffix == ".pvd" and pvd else run / (fields + suffix)
    if not path.exists():
        return None
    source = pv.OpenDataFile(str(path))  # an absolute path: ParaView 5.11 ends on a relative one to XDMF
    source.UpdatePipelineInformation()
    pv.RenameSource(kind, source)
    return source


def suffix_for(run, file):
    """The kind of files to open: that of the file that is open, else what this ParaView reads."""
    if pathlib.Path(file).suffix in (".pvd", ".xdmf", ".vtkhdf"):
        return pathlib.Path(file).suffix
    version = pv.GetParaViewVersion()
    if (run / "fields.h5").exists() and not (run / "particles.pvd").exists():
        return ".vtkhdf" if (version.major, version.minor) >= (5, 12) else ".xdmf"
    return ".pvd"


def has(source, association, name):
    return name in [array.Name for array in (source.PointData if association == "POINTS" else source.CellData)]


def show_bar(display, view, name):
    """The scale of colours, small."""
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(pv.GetColorTransferFunction(name), view)
    bar.ScalarBarLength, bar.ScalarBarThickness, bar.TitleFontSize, bar.LabelFontSize = 0.25, 12, 12, 10


def show_particles(source, view):
    display = pv.Show(source, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    display.GaussianRadius = 1.0
    display.ScaleByArray = 1
    display.SetScaleArray = ["POINTS", "radius"]
    display.UseScaleFunction = 0
    pv.ColorBy(display, ("POINTS", "fragment"))
    display.SetScalarBarVisibility(view, False)


def show_bonds(source, view):
    tubes = pv.Tube(Input=pv.ExtractSurface(Input=source), Scalars=["POINTS", "radius"], NumberofSides=8)
    tubes.VaryRadius = "By Absolute Scalar"
    display = pv.Show(tubes, view)
    pv.ColorBy(display, ("CELLS", "stress_ratio"))
    display.RescaleTransferFunctionToDataRange(False, True)
    show_bar(display, view, "stress_ratio")
    pv.RenameSource("bonds as tubes", tubes)


def show_liners(source, view):
    """The half behind the axis."""
    half = pv.Clip(Input=source, ClipType="Plane")
    half.ClipType.Origin = [0.0, 0.0, 0.0]
    half.ClipType.Normal = [0.0, 1.0, 0.0]
    half.Invert = 0
    display = pv.Show(half, view)
    if has(source, "CELLS", "pressure"):
        pv.ColorBy(display, ("CELLS", "pressure"))
        show_bar(display, view, "pressure")
    else:
        display.ColorArrayName = [None, ""]
        display.DiffuseColor = [0.65, 0.65, 0.68]
    pv.RenameSource("liners, cut", half)


def show_run(file, time=None):
    """Adds the run that a file belongs to. Returns the view."""
    run, view = directory_of_run(file), pv.GetActiveViewOrCreate("RenderView")
    suffix = suffix_for(run, file)
    for source in pv.GetSources().values():
        pv.Hide(source, view)
    shown = {kind: open_kind(run, kind, suffix) for kind in KINDS}
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    times = shown["particles"].TimestepValues if shown["particles"] else [0.0]
    view.ViewTime = float(times[-1] if time is None else time)
    for source in filter(None, shown.values()):
        source.UpdatePipeline(view.ViewTime)
    for kind, show in (("particles", show_particles), ("bonds", show_bonds), ("liners", show_liners),
                       ("liners_fixed", show_liners)):
        if shown[kind]:
            show(shown[kind], view)
    pv.LoadPalette("WhiteBackground")
    view.CameraViewUp, view.CameraPosition, view.CameraFocalPoint = [0, 0, 1], [0, -1, 0.4], [0, 0, 0]
    pv.ResetCamera(view)
    pv.Render(view)
    return view


if __name__ == "__main__" and len(sys.argv) > 1:
    made = show_run(sys.argv[1], float(sys.argv[3]) if len(sys.argv) > 3 else None)
    if len(sys.argv) > 2:
        pv.SaveScreenshot(sys.argv[2], made, ImageResolution=[1200, 1000])
elif __name__ in ("__main__", "__builtin__", "builtins"):
    show_run(opened_file())

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws one snapshot of a run directory as a PNG: rocks as spheres of true radius, liners cut open.

Usage: render.py RUNDIR [--frame N] [--out FILE.png] [--color fragment|rock|velocity|force|none]
                 [--walls pressure|sliding_work|wear] [--view machine|rock|all] [--cut none|liners|half] [--bonds] ...

Needs python3-vtk9 and python3-numpy; without a display it starts itself again under xvfb-run (xvfb, xauth).
"""
import argparse
import ctypes
import os
import sys
from pathlib import Path

from errors import fail, need, need_programs


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws one snapshot of a run directory as a PNG.")
    parser.add_argument("run", type=Path, metavar="RUNDIR")
    parser.add_argument("--frame", type=int, default=-1, help="number of the snapshot; negative counts from the last")
    parser.add_argument("--out", type=Path, help="default: RUNDIR/frame_NNNNNN.png")
    parser.add_argument("--color", choices=["fragment", "rock", "velocity", "force", "none"],
                        help="of the particles; none leaves them out; default: fragment, with --walls none")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="of velocity [m/s] or force [N]")
    parser.add_argument("--walls", choices=["pressure", "sliding_work", "wear"],
                        help="colours the walls by their loads since the start; needs a run with output.liners")
    parser.add_argument("--walls-range", type=float, nargs=2, metavar=("LOW", "HIGH"),
                        help="of pressure [Pa], sliding work by area [J/m2] or wear [mm per 1000 h]")
    parser.add_argument("--view", choices=["machine", "rock", "all"],
                        help="what fills the picture: the walls other than planes; 98 %% of the particles along each axis; or "
                             "all particles and walls; default: machine, or rock where there are only planes")
    parser.add_argument("--cut", choices=["none", "liners", "half"],
                        help="what is cut away in front: nothing, the outer liners, or rocks too; "
                             "default: half of a crusher, nothing of other scenes")
    parser.add_argument("--bonds", action="store_true",
                        help="also draw bonds as thin tubes; particles and bonds at 0.45 of their radius")
    parser.add_argument("--size", default="1600x1200", help="pixels, WIDTHxHEIGHT")
    parser.add_argument("--azimuth", type=float, default=-90, help="of the camera [degrees]")
    parser.add_argument("--elevation", type=float, default=24, help="of the camera [degrees]")
    parser.add_argument("--zoom", type=float, default=1)
    parser.add_argument("--title", help="default: the title of the case")
    arguments = parser.parse_args()
    try:
        arguments.width, arguments.height = (int(part) for part in arguments.size.split("x"))
    except ValueError:
        parser.error(f"--size {arguments.size} is not WIDTHxHEIGHT; 1600x1200 is an example")
    if min(arguments.width, arguments.height) < 1 or arguments.zoom <= 0:
        parser.error("--size and --zoom must be above 0")
    arguments.color = arguments.color or ("none" if arguments.walls else "fragment")
    return arguments


def display_answers():
    """Whether there is an X server: VTK aborts the program without one."""
    if not os.environ.get("DISPLAY"):
        return False
    open_display = ctypes.CDLL("libX11.so.6").XOpenDisplay
    open_display.restype = ctypes.c_void_p
    return bool(open_display(None))


def ensure_display():
    """Debian's VTK opens an X window even off screen: starts the script again under xvfb-run where there is no display."""
    if display_answers():
        return
    if "xvfb-run" in os.environ.get("XAUTHORITY", ""):
        fail("the display of xvfb-run does not answer; set DISPLAY to one that does")
    need_programs("xvfb-run", "xauth", otherwise=", or set DISPLAY")
    os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, *sys.argv])


def main():
    arguments = parse_arguments()
    need("numpy", "vtkmodules")
    from rendering.files import find_frame
    from rendering.picture import Picture
    frame, time = find_frame(arguments.run, arguments.frame)
    out = arguments.out or arguments.run / f"frame_{frame:06d}.png"
    if not os.access(out.parent, os.W_OK):
        fail(f"{out} cannot be written; the directory must exist and be writable")
    picture = Picture(arguments, frame, time)
    ensure_display()
    picture.write(out)
    print(out)


if __name__ == "__main__":
    main()

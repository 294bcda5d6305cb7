#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the start states of the accuracy scenes: ./make_starts.py [--gyrosim FILE] [SCENE ...]

Runs each scene without motion, with unbreakable and softer bonds and much rolling friction, until the rocks that it drops
lie at rest, and writes SCENE-particles.csv and SCENE-bonds.csv from the last snapshot. Of the crusher a sector is kept.
Needs python3-vtk9.
"""
import argparse
import math
import subprocess
import tempfile
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

HERE = Path(__file__).resolve().parent
COMMON = ["particles=null", "bonds.tensile_strength=1e15", "bonds.shear_strength=1e15", "bonds.normal_stiffness=50e9",
          "bonds.shear_stiffness=20e9", "contacts.rock/rock={friction: 0.5, restitution: 0.5, rolling_friction: 0.2}",
          "contacts.rock/steel={friction: 0.7, restitution: 0.5, rolling_friction: 0.2}", "coupling.interval=0.5 ms",
          "output.snapshots=50 ms"]

# What is dropped, for how long it settles [s], which sector is kept [degrees], and the factor on radii that takes the load
# from the contacts, so that a start state throws nothing apart.
SCENES = {
    "platen": {
        "settle": 1.5,
        "set": ["rocks={shapes: {procedural: 1}, sizes: {passing: [[59 mm, 0], [61 mm, 1]]}, samples: 1, "
                "fill: {ratio: 6}, density: material}",
                "feed={rocks: 1, at: [0, 0, 45 mm]}", "walls.upper.motion=fixed", "walls.upper.plane.point=[0, 0, 1]"],
    },
    "wedge": {
        "settle": 1.2,
        "shrink": 0.992,
        "set": ["rocks={shapes: {procedural: 6}, sizes: {passing: [[35 mm, 0], [45 mm, 1]]}, samples: 6, "
                "fill: {ratio: 3.2}, density: material}",
                "feed={rocks: 30, at: [50 mm, 0, 0.25]}", "walls.jaw.motion=fixed"],
    },
    "crusher": {
        "settle": 0.4,
        "sector": (84, 164),
        "shrink": 0.996,
        "set": ["rocks={shapes: {procedural: 6}, sizes: {passing: [[25 mm, 0], [40 mm, 1]]}, samples: 8, "
                "fill: {ratio: 4}, density: material}",
                "feed={initial: 1.8 kg, initial_top: 150 mm, above: concave}",
                "drivetrain.motor={model: constant_speed, speed: 1e-9}"],
    },
}


def last_snapshot(folder, kind):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(sorted(folder.glob(f"{kind}*.vtp"))[-1]))
    reader.Update()
    return reader.GetOutput()


def settle(gyrosim, scene, out):
    recipe = SCENES[scene]
    overrides = COMMON + recipe["set"] + [f"time.duration={recipe['settle']}"]
    command = [gyrosim, "run", str(HERE / f"{scene}.yaml"), "--out", str(out), "--threads", "1", "--quiet"]
    subprocess.run(command + [word for key in overrides for word in ("--set", key)], check=True)


def kept(rock, points, recipe):
    """Rocks whose mean azimuth lies in the sector."""
    if "sector" not in recipe:
        return set(rock)
    low, high = recipe["sector"]
    inside = set()
    for one in set(rock):
        own = points[rock == one].mean(axis=0)
        if low <= math.degrees(math.atan2(own[1], own[0])) % 360 <= high:
            inside.add(one)
    return inside


def write(scene, folder):
    particles, bonds = last_snapshot(folder, "particles"), last_snapshot(folder, "bonds")
    points = vtk_to_numpy(particles.GetPoints().GetData())
    column = {name: vtk_to_numpy(particles.GetPointData().GetArray(name)) for name in ("id", "rock", "radius")}
    speed = vtk_to_numpy(particles.GetPointData().GetArray("velocity"))
    rocks = kept(column["rock"], points, SCENES[scene])
    number = {rock: k for k, rock in enumerate(sorted(rocks))}
    rows = [k for k in range(len(points)) if column["rock"][k] in rocks]
    shrink = SCENES[scene].get("shrink", 1)
    new_id = {tuple(points[k]): place for place, k in enumerate(rows)}
    with open(HERE / f"{scene}-particles.csv", "w", encoding="utf-8") as file:
        file.write("# made by make_starts.py\nid,x,y,z,r,rock\n")
        for place, k in enumerate(rows):
            x, y, z = points[k]
            file.write(f"{place},{x:.9g},{y:.9g},{z:.9g},{shrink * column['radius'][k]:.9g},{number[column['rock'][k]]}\n")
    ends = vtk_to_numpy(bonds.GetPoints().GetData())
    pairs = [(new_id.get(tuple(ends[2 * b])), new_id.get(tuple(ends[2 * b + 1]))) for b in range(len(ends) // 2)]
    pairs = sorted(tuple(sorted(pair)) for pair in pairs if None not in pair)
    with open(HERE / f"{scene}-bonds.csv", "w", encoding="utf-8") as file:
        file.write("# made by make_starts.py\ni,j\n")
        file.writelines(f"{i},{j}\n" for i, j in pairs)
    top = max(points[k][2] + column["radius"][k] for k in rows)
    print(f"{scene}: {len(rocks)} rocks, {len(rows)} particles, {len(pairs)} bonds, top at {top * 1e3:.3f} mm, "
          f"fastest {max(math.hypot(*speed[k]) for k in rows) * 1e3:.2f} mm/s")


def main():
    parser = argparse.ArgumentParser(description="Makes the start states of the accuracy scenes.")
    parser.add_argument("--gyrosim", default=str(HERE.parents[2] / "build" / "release" / "gyrosim"))
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=f"{', '.join(SCENES)}; default all")
    arguments = parser.parse_args()
    for scene in arguments.scenes or SCENES:
        with tempfile.TemporaryDirectory() as folder:
            settle(arguments.gyrosim, scene, Path(folder) / "run")
            write(scene, Path(folder) / "run" / "snapshots")


if __name__ == "__main__":
    main()

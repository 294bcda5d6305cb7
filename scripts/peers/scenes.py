# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of `gyrosim bench speed` in the words of LAMMPS and LIGGGHTS. The numbers are those of cases/bench/*.yaml."""
import math
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from programs import run_peer

HERE = Path(__file__).resolve().parent
SHEAR, POISSON = 557e6, 0.35
YOUNGS = 2 * SHEAR * (1 + POISSON)
FRICTION, ROLLING = 0.5, 0.001
REBOUND = 0.2  # of a contact that may pull, as the peers ask for it: 0.325 here (cases/verification/pressed_block)
# gamma of gran/hertz/history [1/(m s)], whose damping goes with the square root of the overlap and not with its fourth root:
# chosen so that S1 keeps as much energy as with a restitution of 0.2 (1e5 keeps 27 % more).
DAMPING = 8e6
KN, KS = 1.67e12, 6.67e11  # stiffness of a bond per area [Pa/m]
TENSILE, SHEAR_STRENGTH = 1e9, 1e9  # [Pa]
BOND_RADIUS = 0.005  # [m]
PLATE_SPEED = 1.0  # [m/s]
SKIN = 0.004  # of neighbour lists [m]


def steps(state):
    scene = state.scene
    return {"warm": scene["warm_up"], "timed": scene["timed"], "dt": scene["time_step"], "skin": SKIN}


def contact():
    # Damping goes with the root of the stiffness: St/Sn = 8 G*/(2 E*).
    return {"youngs": YOUNGS, "poisson": POISSON, "friction": FRICTION, "rebound": REBOUND,
            "shear_damping": math.sqrt(2 * (1 - POISSON) / (2 - POISSON))}


def run_loose(script, more):
    def run(state, arguments, folder):
        state.write(folder / "state.data")
        given = {**steps(state), **more, "state": folder / "state.data", "width": state.size("width")}
        return run_peer(arguments, arguments.lmp, HERE / script, given)

    return run


def run_bonded(state, arguments, folder):
    state.write(folder / "state.data", molecules=True)
    area = math.pi * BOND_RADIUS**2
    bending = area * BOND_RADIUS**2 / 4  # second moment of area [m4]
    given = {**steps(state), **contact(), "state": folder / "state.data", "speed": PLATE_SPEED}
    given |= {"bottom": state.size("bottom"), "top": state.size("top")}
    given |= {"kr": KN * area, "ks": KS * area, "kb": KN * bending, "kt": 2 * KS * bending}
    given |= {"fcr": TENSILE * area, "fcs": SHEAR_STRENGTH * area}
    given |= {"tcb": TENSILE * bending / BOND_RADIUS, "tct": SHEAR_STRENGTH * 2 * bending / BOND_RADIUS}
    return run_peer(arguments, arguments.lmp, HERE / "bonded.lmp", given)


LAW = "wall/gran model hertz tangential history rolling_friction cdt"


def planes_of_box(state, folder):
    sides = [("x", 0.0), ("x", state.size("width")), ("y", 0.0), ("y", state.size("width")), ("z", 0.0)]
    return [f"fix side{n} all {LAW} primitive type 1 {axis}plane {at!r}" for n, (axis, at) in enumerate(sides)]


def cones(state, folder):
    """The inner one moves on the circle (e sin wt, e (1 - cos wt)), which is made of two oscillations."""
    lines = []
    for name in ("outer", "inner"):
        shutil.copy(state.folder / f"{name}.stl", folder)  # LIGGGHTS reads no path with blanks
        lines.append(f"fix {name} all mesh/surface file {folder}/{name}.stl type 1 curvature 1e-6")
    return lines + [
        f"fix cones all {LAW} mesh n_meshes 2 meshes outer inner",
        f"fix floor all {LAW} primitive type 1 zplane 0.0",
        "fix along all move/mesh mesh inner wiggle amplitude 0.01 0. 0. period 0.05",
        f"fix across all move/mesh mesh inner viblin axis 0 1 0 order 1 amplitude 0.01 phase {math.pi!r} period 0.05",
    ]


def run_liggghts(walls):
    def run(state, arguments, folder):
        state.write(folder / "state.data")
        script = folder / "in.liggghts"
        script.write_text((HERE / "loose.liggghts").read_text().replace("\nWALLS\n", "\n" + "\n".join(walls(state, folder)) + "\n"))
        given = {**steps(state), **contact(), "rolling": ROLLING, "state": folder / "state.data"}
        return run_peer(arguments, arguments.liggghts, script, given)

    return run


@dataclass
class Pair:
    """A scene in gyrosim and in a peer."""
    scene: str
    peer: str
    run: Callable  # (state, arguments, folder) -> seconds, energy
    tolerance: float  # of the kinetic energy at the end, over the larger of those at start and end [-]
    once: bool = False  # in the first round only


HISTORY = {"youngs": YOUNGS, "shear": SHEAR, "poisson": POISSON, "friction": FRICTION, "damping": DAMPING}

PAIRS = (
    Pair("S1", "LAMMPS gran/hertz/history", run_loose("loose.lmp", HISTORY), 0.02),
    Pair("S1", "LAMMPS granular, law of gyrosim", run_loose("same.lmp", contact()), 0.005, once=True),
    Pair("S1", "LIGGGHTS hertz, rolling", run_liggghts(planes_of_box), 0.02),
    Pair("S2", "LAMMPS bpm/rotational", run_bonded, 0.01),
    Pair("S2r", "LAMMPS bpm/rotational", run_bonded, 0.01),
    Pair("S3", "LIGGGHTS hertz, rolling", run_liggghts(cones), 0.02),
)

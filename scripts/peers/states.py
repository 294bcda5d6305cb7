# SPDX-License-Identifier: GPL-3.0-or-later
"""Start states of `gyrosim bench speed --states` as the data files of LAMMPS and LIGGGHTS."""
import csv
import json
import math
from pathlib import Path

DENSITY = 2600.0  # of the rock in cases/bench [kg/m3]
ROOM = 0.2  # around all in the box of a peer [m]


class State:
    """The folder of a scene: its particles, bonds and sizes."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.scene = json.loads((self.folder / "scene.json").read_text())
        with open(self.folder / "particles.csv", newline="") as file:
            self.particles = list(csv.DictReader(file))
        self.bonds = []
        if self.scene["bonds"]:
            with open(self.folder / "bonds.csv", newline="") as file:
                self.bonds = list(csv.DictReader(file))

    def size(self, name):
        return self.scene["sizes"][name]

    def kinetic_energy(self):
        """Of translation [J]."""
        return sum(2 / 3 * math.pi * DENSITY * float(p["r"])**3 * sum(float(p[v])**2 for v in ("vx", "vy", "vz"))
                   for p in self.particles)

    def box(self):
        """Lines of a data file: a box around all particles, and around the meshes of scenes that have some."""
        lines = []
        for axis in "xyz":
            values = [float(p[axis]) for p in self.particles]
            low, high = min(values), max(values)
            if "outer_radius" in self.scene["sizes"]:
                wide, tall = self.size("outer_radius"), self.size("height")
                low, high = (0.0, tall) if axis == "z" else (-wide, wide)
            lines.append(f"{low - ROOM!r} {high + ROOM!r} {axis}lo {axis}hi")
        return lines

    def write(self, path, molecules=False):
        """Writes a data file. molecules: for atom_style bpm/sphere, with the bonds; otherwise for spheres."""
        lines = ["start state of gyrosim", "", f"{len(self.particles)} atoms", "1 atom types"]
        if molecules:
            lines += [f"{len(self.bonds)} bonds", "1 bond types", "40 extra bond per atom", "60 extra special per atom"]
        lines += self.box() + ["", "Atoms", ""]
        for p in self.particles:
            number = int(p["id"]) + 1
            first = f"{number} 1 1" if molecules else f"{number} 1"
            lines.append(f"{first} {2 * float(p['r'])!r} {DENSITY} {p['x']} {p['y']} {p['z']}")
        lines += ["", "Velocities", ""]
        lines += [f"{int(p['id']) + 1} {p['vx']} {p['vy']} {p['vz']} 0 0 0" for p in self.particles]
        if molecules:
            lines += ["", "Bonds", ""]
            lines += [f"{n} 1 {int(b['i']) + 1} {int(b['j']) + 1}" for n, b in enumerate(self.bonds, 1)]
        Path(path).write_text("\n".join(lines) + "\n")

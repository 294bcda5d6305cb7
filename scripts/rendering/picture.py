# SPDX-License-Identifier: GPL-3.0-or-later
"""One picture: reads a snapshot, chooses what it frames, and draws it."""
import json
import re

import numpy as np

from errors import fail
from rendering import stage
from rendering.camera import Frame, box_of_rock, place
from rendering.colours import legend
from rendering.files import field, positions, read, read_walls, split_walls
from rendering.rocks import bond_actor, particle_actor
from rendering.walls import add_loads, fit_planes, innermost, machine_points, wall_actors

TITLE_EDGE, LEGEND_EDGE = 0.87, 0.72  # of the frame, where a title or legend is, as shares of half the picture


def title_of(arguments):
    """Title of the resolved case, which a run has from its start."""
    if arguments.title is not None:
        return arguments.title
    try:
        case = (arguments.run / "case.yaml").read_text(encoding="utf-8")
        found = re.search(r'^  title: ("(?:[^"\\]|\\.)*")$', case, re.MULTILINE)
        return json.loads(found[1]) if found else ""
    except (OSError, ValueError):
        return ""


class Scene:
    """What a frame holds: particles, bonds and walls, each None or empty where there are none."""

    def __init__(self, arguments, frame):
        self.particles = read(arguments.run, "particles", frame)
        if self.particles and self.particles.GetNumberOfPoints() == 0:
            self.particles = None
        self.bonds = read(arguments.run, "bonds", frame) if arguments.bonds else None
        self.walls = split_walls(read_walls(arguments.run, frame))
        if arguments.cut is None:
            arguments.cut = "none" if innermost(self.walls) is None else "half"
        self.points = self.framed(arguments)
        self.length = float(np.linalg.norm(np.ptp(self.points, axis=0))) or 1.0
        fit_planes(self.walls, self.points)

    def framed(self, arguments):
        """Points that the picture must hold. (n, 3) [m]"""
        machine = machine_points(self.walls, arguments)
        view = arguments.view or ("machine" if len(machine) else "rock")
        if view == "machine" and not len(machine):
            fail(f"{arguments.run} has no walls but planes; use --view rock")
        if len(machine) and (view == "machine" or not self.particles or (view, arguments.color) == ("all", "none")):
            return machine
        if not self.particles:
            fail(f"{arguments.run} has neither particles nor walls but planes in this frame; choose another --frame")
        rock = box_of_rock(positions(self.particles), field(self.particles, "radius"), *([1] if view == "all" else []))
        return np.concatenate([machine, rock]) if view == "all" else rock

    def near(self):
        """(centre, distance) beyond which nothing is drawn."""
        return self.points.mean(axis=0), stage.FAR * self.length


def actors_of(scene, arguments, time):
    """(actors, [(colour scale, its title)])"""
    found = []
    if scene.particles and arguments.color != "none":
        found.append(particle_actor(scene.particles, arguments, scene.near()))
    if scene.bonds:
        found.append(bond_actor(scene.bonds, arguments, scene.near()))
    found = [part for part in found if part]
    loads = add_loads(scene.walls, arguments, time)
    scales = [(table, title) for _, table, title in found if table] + ([loads] if loads else [])
    return [part[0] for part in found] + wall_actors(scene.walls, arguments, loads and loads[0]), scales


class Picture:
    """A snapshot made ready; what is wrong with it ends the script here. `write` opens a window, which needs a display."""

    def __init__(self, arguments, frame, time):
        self.arguments, self.scene = arguments, Scene(arguments, frame)
        self.actors, self.scales = actors_of(self.scene, arguments, time)
        label = f"t = {time:.3f} s"
        title = title_of(arguments)
        self.title = f"{title}\n{label}" if title else label

    def write(self, path):
        given, scene = self.arguments, self.scene
        width, height = stage.OVERSAMPLING * given.width, stage.OVERSAMPLING * given.height
        annotations = [stage.title_actor(self.title, width, height)]
        annotations += [legend(*scale, min(height, 3 * width // 4), number, len(self.scales)) for number, scale in enumerate(self.scales)]
        frame = Frame(top=TITLE_EDGE, right=LEGEND_EDGE if self.scales else 0.95)
        placed = place(scene.points, given.azimuth, given.elevation, width / height, frame, given.zoom)
        stage.write_image(stage.draw(self.actors, annotations, width, height, placed, scene.length), path)

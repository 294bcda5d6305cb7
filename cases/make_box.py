#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the spheres of box.yaml: ./make_box.py > box-particles.csv

Three hundred spheres of 8 to 12 mm radius on a loose lattice in a box of 0.2 m x 0.2 m, shifted at random
by so little that none touch.
"""
import random

random.seed(1)
PITCH, SIDE, LAYERS = 0.030, 6, 9  # [m], spheres along an edge, layers
COUNT = 300

print("# made by make_box.py")
print("id,x,y,z,r,vx,vy,vz")
for k in range(COUNT):
    i, j, layer = k % SIDE, k // SIDE % SIDE, k // SIDE**2
    radius = random.uniform(0.008, 0.012)
    shift = [random.uniform(-0.0025, 0.0025) for _ in range(3)]
    x = (i - (SIDE - 1) / 2) * PITCH + shift[0]
    y = (j - (SIDE - 1) / 2) * PITCH + shift[1]
    z = (layer + 0.7) * PITCH + shift[2]
    print(f"{k + 1},{x:.6f},{y:.6f},{z:.6f},{radius:.6f},0,0,-0.5")

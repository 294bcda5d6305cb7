# SPDX-License-Identifier: GPL-3.0-or-later
"""What a picture frames, and the camera that sees just that."""
import numpy as np

VIEW_ANGLE = 24  # vertical [degrees]
SHARE = 0.98     # of the particles, along each axis, that the box of the rock holds


class Frame:
    """Edges of what is framed, as shares of half the picture: 1 is the picture's edge."""

    def __init__(self, left=0.95, right=0.95, bottom=0.95, top=0.95):
        self.left, self.right, self.bottom, self.top = left, right, bottom, top


def box_of_rock(positions, radius, share=SHARE):
    """Corners of the box that holds this share of the particles along each axis: strays do not count. (8, 3) [m]"""
    low, high = (np.quantile(positions, q, axis=0, method=method)
                 for q, method in (((1 - share) / 2, "lower"), ((1 + share) / 2, "higher")))
    inside = ((positions >= low) & (positions <= high)).all(axis=1)
    reach = np.max(np.asarray(radius)[inside], initial=0)
    return corners(low - reach, high + reach)


def corners(low, high):
    return np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]]
                     for i in (0, 1) for j in (0, 1) for k in (0, 1)])


def axes(azimuth, elevation):
    """Unit vectors to the right, up and towards the camera. @param azimuth, elevation  of the camera [degrees]"""
    a, e = np.radians(azimuth), np.radians(elevation)
    back = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0])
    return right, np.cross(back, right), back


def span(across, depth, less, more):
    """(smallest distance from which a perspective view holds all points across one axis, camera's place on the axis).

    The camera at (c, d) sees a point (x, z) if -less (d - z) <= x - c <= more (d - z).
    """
    high, low = np.max(across + more * depth), np.min(across - less * depth)
    return (high - low) / (less + more), lambda d: (high - more * d + low + less * d) / 2


def place(points, azimuth, elevation, aspect, frame, zoom=1):
    """(position, point looked at, up, distance) of the nearest camera that sees all points inside the frame.

    @param aspect  width / height of the picture
    @param zoom    above 1 the points reach beyond the frame
    """
    right, up, back = axes(azimuth, elevation)
    x, y, z = points @ right, points @ up, points @ back
    half = np.tan(np.radians(VIEW_ANGLE / 2)) * zoom
    wide, x_at = span(x, z, half * aspect * frame.left, half * aspect * frame.right)
    tall, y_at = span(y, z, half * frame.bottom, half * frame.top)
    size = np.ptp(points, axis=0).max() or 1
    distance = max(wide, tall, z.max() + 0.01 * size)
    position = x_at(distance) * right + y_at(distance) * up + distance * back
    centre = (z.min() + z.max()) / 2
    return position, position + (centre - distance) * back, up, distance - centre


def on_picture(point, placed, azimuth, elevation, aspect):
    """Where a point is seen, as shares of half the picture: (-1, -1) is the lower left corner."""
    right, up, back = axes(azimuth, elevation)
    away = np.asarray(point) - placed[0]
    half = np.tan(np.radians(VIEW_ANGLE / 2)) * -(away @ back)
    return away @ right / half / aspect, away @ up / half

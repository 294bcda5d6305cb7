# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of scripts/render.py: files of a snapshot, rocks, walls, camera, and what stands around them."""

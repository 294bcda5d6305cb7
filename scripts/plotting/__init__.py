# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of scripts/plot.py: one module for each sub-command, with `add_arguments` and `draw`."""

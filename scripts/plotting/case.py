# SPDX-License-Identifier: GPL-3.0-or-later
"""What pictures need of a run's case: size distribution of the feed, settings of the crusher, friction of the liners."""
import csv
import re
import sys

import numpy as np
import yaml

from plotting.style import PlotError


def read_case(file):
    """The resolved case in results.h5 as a dictionary; all numbers are SI. @raises PlotError without one"""
    try:
        return yaml.safe_load(file["case"].attrs["resolved_yaml"])
    except (KeyError, yaml.YAMLError) as error:
        raise PlotError(f"{file.filename} has no readable case ({error}); give the directory of a run") from error


def settings(case):
    """{"closed side setting": m, "open side setting": m}; the open one is larger by twice the eccentricity."""
    crusher = case.get("crusher")
    if not crusher:
        return {}
    closed = float(crusher["closed_side_setting"])
    return {"closed side setting": closed, "open side setting": closed + 2 * float(crusher["eccentricity"])}


def friction(case, wall):
    """Friction of rock on a wall."""
    pair = {"rock", str(case["walls"][wall]["material"])}
    for names, contact in case["contacts"].items():
        if set(names.split("/")) == pair:
            return float(contact["friction"])
    raise PlotError(f"the case has no contact {'/'.join(sorted(pair))}; give a run of gyrosim")


def feed_curve(case):
    """(sizes [m], shares that pass) of the feed as the case states it, by equal-volume diameter; None without rocks."""
    law = (case.get("rocks") or {}).get("sizes")
    if not law:
        return None
    (name, given), = law.items()
    if name in LAWS:
        return LAWS[name](**{key: float(value) for key, value in given.items()})
    return between(given if name == "passing" else read_sieves(given))


def read_sieves(path):
    """Points of a CSV with size_mm and passing_percent, in the forms that io/case/csv.hpp describes. None if the file is
    gone, which is said on stderr."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            lines = [line for line in file
                     if line.strip(' \t,;"\n') and not re.match("#|sep=.$", line)]
        separator = next((sign for sign in ";\t" if sign in lines[0]), ",")
        rows = [[cell.strip() for cell in row] for row in csv.reader(lines, delimiter=separator, skipinitialspace=True)]
        size, passing = rows[0].index("size_mm"), rows[0].index("passing_percent")
        return [(number(row[size]) * 1e-3, number(row[passing]) * 1e-2) for row in rows[1:]]
    except (OSError, ValueError, IndexError) as error:
        print(f"note: the feed has no curve, because {path} of rocks.sizes.sieves cannot be read ({error}); "
              "put the file back", file=sys.stderr)
        return None


def number(cell):
    return float(cell.replace(",", "."))


def between(points):
    """A curve through points in any order, linear in the size; with points enough that it looks so on a logarithmic axis."""
    if points is None:
        return None
    sizes, passing = np.array(sorted(points), float).T
    fine = np.union1d(sizes, np.geomspace(sizes[0], sizes[-1], 200))
    return fine, np.interp(fine, sizes, passing)


def vendor(feed_opening, min):
    return between([(min, 0), (0.1 * feed_opening, 0.5), (0.6 * feed_opening, 0.8), (0.8 * feed_opening, 1)])


def cut_off(uncut, low, high):
    """A law that is cut off at two sizes: scaled to run from 0 to 1 between them."""
    sizes = np.geomspace(low, high, 400)
    return sizes, (uncut(sizes) - uncut(low)) / (uncut(high) - uncut(low))


def rosin_rammler(x63, m, min, max):
    return cut_off(lambda x: -np.expm1(-(x / x63) ** m), min, max)


def gates_gaudin_schuhmann(xmax, m, min):
    return cut_off(lambda x: (x / xmax) ** m, min, xmax)


LAWS = {"vendor": vendor, "rosin_rammler": rosin_rammler, "gates_gaudin_schuhmann": gates_gaudin_schuhmann}

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `gyrosim report --out` as a browser gets it: well-formed, complete, without references to other files, and
with the numbers of summary.json.

Usage: page_test.py GYROSIM SOURCE_FOLDER"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as tree
from html.parser import HTMLParser
from pathlib import Path

GYROSIM, SOURCE = Path(sys.argv.pop(1)).resolve(), Path(sys.argv.pop(1)).resolve()
CRUSH = SOURCE / "tests/app/cases/crush.yaml"
XHTML = "{http://www.w3.org/1999/xhtml}"
VOID = {"meta", "link", "br", "input"}


class Nesting(HTMLParser):
    """Fails where an element is not closed, as a browser reads it."""

    def __init__(self):
        super().__init__()
        self.open = []

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in VOID:
            assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-3:]}"
            self.open.pop()


def three(value):
    """A number as the page has it, without a power of ten."""
    exponent = int(f"{value:.2e}".split("e")[1])
    return f"{float(f'{value:.2e}'):.{max(0, 2 - exponent)}f}"


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = Path(tempfile.mkdtemp())
        cls.environment = dict(os.environ, XDG_CACHE_HOME=str(cls.place / "cache"), GYROSIM_THREADS="1")
        run = ["run", CRUSH, "--quiet", "--set", "output.snapshots=4 ms", "--set",
               "output.liners={interval: 2 ms, rows: 8, sectors: 12, wear_coefficient: 1e-12}"]
        cls.call(*run, "--until", "60 ms", "--out", "crush", "--set", "case.title='<b>&\"1\" rock'")
        cls.call(*run, "--until", "30 ms", "--out", "other", "--set", "case.seed=5")
        cls.call("run", SOURCE / "cases/box.yaml", "--quiet", "--until", "10 ms", "--out", "box", "--set", "output.snapshots=0")
        cls.call("run", SOURCE / "cases/mkii-62-75/no-load.yaml", "--quiet", "--until", "0.5 s", "--out", "empty")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.place)

    @classmethod
    def call(cls, *words, code=0):
        done = subprocess.run([GYROSIM, *words], cwd=cls.place, env=cls.environment, capture_output=True, text=True)
        assert done.returncode == code, f"{words}: {done.returncode}\n{done.stdout}{done.stderr}"
        return done

    def page(self, *runs):
        """(text, root) of the page, after the checks that hold for every page."""
        self.call("report", *runs, "--out", "page.html")
        text = (self.place / "page.html").read_text(encoding="utf-8")
        root = tree.fromstring(text)
        parser = Nesting()
        parser.feed(text)
        self.assertEqual(parser.open, [])
        self.assert_self_contained(text, root)
        self.assertFalse(re.search(r"[ \"(,](nan|inf|-nan)[ \",)]", text))
        self.assertFalse(list(self.place.glob("*.tmp")))
        return text, root

    def assert_self_contained(self, text, root):
        self.assertFalse(re.findall(r"https?://", re.sub(r'xmlns="[^"]*"', "", text)))
        self.assertFalse(re.findall(r"@import|url\(", text))
        for element in root.iter():
            for name in ("src", "href"):
                self.assertIn(element.get(name), (None, "data:,"))
        ids = [element.get("id") for element in root.iter() if element.get("id")]
        self.assertEqual(len(ids), len(set(ids)))

    def sections(self, root):
        return [section.get("id") for section in root.iter(XHTML + "section")]

    def titles(self, root):
        return ["".join(caption.itertext()) for caption in root.iter(XHTML + "figcaption")]

    def tiles(self, root):
        found = {}
        for tile in root.iter(XHTML + "div"):
            if tile.get("class") == "tile":
                self.assertTrue(tile.get("title"))
                what, big = ["".join(p.itertext()) for p in tile.iter(XHTML + "p")][:2]
                found[what] = big.split()
        return found

    def test_a_run_has_all_sections_in_order(self):
        text, root = self.page("crush")
        self.assertEqual(self.sections(root), ["verdict", "sizes", "time", "loads", "energy", "breakage", "performance",
                                               "provenance", "view"])
        self.assertIn("start-up", text)
        for title in ("Size curves of feed, rock in the chamber and product", "Speed of the eccentric",
                      "Torque of the motor at its shaft", "Horizontal force of the rock on the mantle, by direction",
                      "Mean pressure of the rock on the mantle", "Wear of the concave",
                      "Where the energy of walls and gravity went", "Where bonds broke, by height"):
            self.assertIn(title, self.titles(root))
        frames = [s for s in root.iter(XHTML + "script") if s.get("class") == "frame"]
        self.assertEqual(len(frames), 8)
        self.assertEqual(frames[-1].get("data-time"), "0.06")

    def test_every_plot_has_a_unit_on_each_axis(self):
        _, root = self.page("crush")
        svg = "{http://www.w3.org/2000/svg}"
        plots = [p for p in root.iter(svg + "svg") if p.get("role") == "img" and p.find(svg + "line") is not None]
        self.assertGreater(len(plots), 10)
        for plot in plots:
            labels = [t.text for t in plot.iter(svg + "text") if t.get("class") == "label"]
            self.assertGreaterEqual(len(labels), 1, plot.get("aria-label"))
            for label in labels:
                self.assertRegex(label, r"\[.+\]|broken bonds|share")

    def test_figures_are_those_of_the_summary(self):
        _, root = self.page("crush")
        summary = json.loads((self.place / "crush/summary.json").read_text(encoding="utf-8"))
        tiles = self.tiles(root)
        power = summary["mean_crushing_power"]
        self.assertEqual(tiles["Crushing power"], [three(power), "W"] if power < 1000 else [three(power / 1e3), "kW"])
        self.assertEqual(tiles["Energy residual"][1], "%")
        self.assertEqual(tiles["Energy residual"][0], three(100 * summary["energy_residual_fraction"]))

    def test_titles_and_case_are_escaped(self):
        text, root = self.page("crush")
        self.assertEqual(root.find(f".//{XHTML}h1").text, '<b>&"1" rock')
        self.assertNotIn("<b>&", text)
        yaml = "".join(root.find(f".//{XHTML}pre").itertext())
        self.assertEqual(yaml, (self.place / "crush/case.yaml").read_text(encoding="utf-8"))

    def test_parts_that_a_run_lacks_are_left_out(self):
        text, root = self.page("box")
        self.assertEqual(self.sections(root), ["verdict", "time", "energy", "performance", "provenance", "view"])
        self.assertIn("This run has no snapshots", text)
        _, root = self.page("empty")
        self.assertNotIn("sizes", self.sections(root))
        self.assertNotIn("breakage", self.sections(root))
        self.assertIn("Speed of the eccentric", self.titles(root))

    def test_runs_are_compared_with_the_first(self):
        text, root = self.page("crush", "other", "box")
        table = root.find(f".//{XHTML}table")
        rows = {"".join(row[0].itertext()): ["".join(cell.itertext()) for cell in row[1:]] for row in table.iter(XHTML + "tr")}
        self.assertEqual(rows["Figure"], ["crush", "other", "box"])
        self.assertRegex(rows["Crushing power"][1], r"W[+−][\d.]+ %$")
        self.assertEqual(rows["Crushing power"][2], "–")
        first, other = (json.loads((self.place / run / "summary.json").read_text(encoding="utf-8")) for run in ("crush", "other"))
        change = 100 * (other["mean_crushing_power"] / first["mean_crushing_power"] - 1)
        shown = re.search(r"W([+−])([\d.]+) %$", rows["Crushing power"][1])
        self.assertAlmostEqual(float(shown[2]), abs(change), delta=0.06 * abs(change))
        self.assertEqual(shown[1] == "+", change > 0)
        self.assertRegex(rows["Broken bonds"][1], r"%[+−][\d.]+ points$")
        self.assertEqual(self.titles(root).count("Crushing power"), 1)
        self.assertIn("<summary>other</summary>", text)

    def test_without_out_the_summaries_are_printed_in_order(self):
        both = self.call("report", "crush", "box").stdout
        self.assertEqual(both, self.call("report", "crush").stdout + self.call("report", "box").stdout)

    def test_bad_runs_are_refused_with_their_path(self):
        for name, damage in {
            "no summary": lambda run: (run / "summary.json").unlink(),
            "half a summary": lambda run: os.truncate(run / "summary.json", 100),
            "no results": lambda run: (run / "results.h5").unlink(),
            "half of the results": lambda run: os.truncate(run / "results.h5", (run / "results.h5").stat().st_size // 2),
            "no HDF5": lambda run: (run / "results.h5").write_text("hello"),
            "half a snapshot": lambda run: os.truncate(run / "snapshots/particles_000000.vtp", 400),
            "half a wall": lambda run: os.truncate(run / "snapshots/walls_000000.vtp", 4000),
        }.items():
            with self.subTest(name):
                run = self.place / "damaged"
                shutil.copytree(self.place / "crush", run)
                damage(run)
                (self.place / "kept.html").write_text("before")
                done = self.call("report", "crush", run, "--out", "kept.html", code=2)
                self.assertIn(str(run), done.stderr)
                self.assertEqual((self.place / "kept.html").read_text(), "before")
                shutil.rmtree(run)
        self.assertIn("nowhere", self.call("report", "nowhere", "--out", "page.html", code=2).stderr)

    def test_a_page_replaces_no_file_of_a_run(self):
        before = (self.place / "crush/results.h5").read_bytes()
        self.assertIn(".html", self.call("report", "crush", "--out", "crush/results.h5", code=2).stderr)
        self.assertEqual((self.place / "crush/results.h5").read_bytes(), before)
        (self.place / "folder.html").mkdir()
        self.call("report", "crush", "--out", "folder.html", code=2)
        self.call("report", "crush", "--out", "missing/page.html", code=5)
        self.call("report", "--out", "page.html", code=2)

    def test_the_page_is_the_same_each_time(self):
        self.assertEqual(self.page("crush")[0], self.page("crush")[0])


if __name__ == "__main__":
    unittest.main()

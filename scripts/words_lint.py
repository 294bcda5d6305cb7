#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on words that the project has replaced by standard terms, in code, comments, cases and pages.

Each entry names the old word and what to use instead. Add one when a name is changed, so that it does not come back. The
changelog is history and is not read.

Usage: words_lint.py [ROOT]
"""
import re
import sys
from pathlib import Path

FOLDERS = ("core", "mbd", "io", "app", "gpu", "tests", "scripts", "cases")
PAGES = ("README.md", "CONTRIBUTING.md")
SUFFIXES = (".hpp", ".cpp", ".cuh", ".cu", ".py", ".sh", ".cmake", ".yaml", ".md")
EXEMPT = ("scripts/words_lint.py", "scripts/lint_selftest.py")

# Old word as a regular expression, and what to use. `<` and `>` are the edges of a word in snake_case or CamelCase.
B, E = r"(?<![A-Za-z])", r"(?![a-z])"
WORDS = [(re.compile(pattern.replace("<", B).replace(">", E)), use) for pattern, use in (
    # Bonds: intact, broken and still pressed, broken.
    (r"<[Uu]nglued>", "`pressed`, in prose `broken and still pressed`"),
    (r"<[Gg]lued>|[a-z]Glued>", "`intact`"),
    (r"\bbond_gone\b", "`bond_broken`"),
    # Walls.
    (r"<[Ss]heets?>", "`thin wall`"),
    # Limits.
    (r"\bmost_\w+|\bMOST_\w+", "`max_...`"),
    (r"\bleast_\w+|\bLEAST_\w+", "`min_...`"),
    # Kinematics.
    (r"\b(turn_[ij]|mean_turn)\b", "`orientation`"),
    (r"\bspin_[ij]\b", "`angular_velocity`"),
    (r"\bmoment_(i|j|on)\b", "`torque`"),
    (r"\bNotePlaces\b|\blisted_(at|position)\b", "`bounds`"),
    # Contacts and neighbour lists.
    (r"\b(Contact(Past|Memory)|Carry(Wall)?Memory|WallMemory)\b", "`...History`"),
    (r"\b(neighbour|list)_margin\b|\bmargins? of (the )?(neighbour )?lists?\b", "`skin`"),
    (r"\blists_stale\b", "`neighbours_stale`"),
    # Choices and numbers of a run.
    (r"\breal64\b", "`double`"),
    (r"\bheld_time\b", "`hold_time`"),
    (r"\bleft_over\b", "`carry_over_fraction`"),
    (r"\bexit_resume_me\b", "`exit_interrupted`"),
    # Plain English.
    (r"\b[Aa]new\b", "`again`, or `new`"),
)]


def problems_of(text):
    """Problems of one file: (line, what)."""
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, use in WORDS:
            for match in pattern.finditer(line):
                yield number, f"`{match[0]}` is an old word; use {use}"


def problems(root):
    """All problems below `root`, as FILE:LINE: texts."""
    files = [root / page for page in PAGES if (root / page).exists()]
    files += [file for folder in FOLDERS for file in sorted((root / folder).rglob("*")) if file.suffix in SUFFIXES]
    found = []
    for file in files:
        path = file.relative_to(root).as_posix()
        text = file.read_text(encoding="utf-8", errors="replace")  # the tests have cases with broken bytes
        if path not in EXEMPT:
            found += [f"{path}:{line}: {what}" for line, what in problems_of(text)]
    return found


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    found = problems(root)
    print("\n".join(found) or "words: no problem")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

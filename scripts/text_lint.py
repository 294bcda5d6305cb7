#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on a source file without a licence line, too long, unfinished, or with stray blanks.

Usage: text_lint.py [ROOT]
"""
import re
import sys
from pathlib import Path

FOLDERS = ("core", "mbd", "io", "app", "gpu", "tests", "scripts")
SUFFIXES = (".hpp", ".cpp", ".cuh", ".cu", ".py", ".sh", ".cmake")
LONGEST = 400  # lines: one idea a file, about 300 as a rule
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")

# ctest passes these names on in a list and on a command line: such a test would pass without being run.
LOST_TEST = re.compile(r'TEST_CASE\("(-|[^"]*;)')


def problems_of(path, text):
    """Problems of one file: (line, what)."""
    lines = text.splitlines()
    if not any("SPDX-License-Identifier: GPL-3.0-or-later" in line for line in lines[:2]):
        yield 1, "has no line `SPDX-License-Identifier: GPL-3.0-or-later` on top"
    elif path.endswith((".hpp", ".cuh")) and "#pragma once" not in lines:
        yield 1, "is a header without `#pragma once`"
    if len(lines) > LONGEST:
        yield len(lines), f"is longer than {LONGEST} lines; divide it by concept"
    for number, line in enumerate(lines, 1):
        if UNFINISHED.search(line):
            yield number, "is marked unfinished; finish it, or say in plain words what is limited"
        if LOST_TEST.search(line):
            yield number, "is a test that ctest cannot name; take out the semicolon or the leading dash"
        if line != line.rstrip():
            yield number, "ends in blanks"
        if line.startswith("\t"):
            yield number, "is indented by a tab"


def problems(root):
    """All problems below `root`, as FILE:LINE: texts."""
    files = [file for folder in FOLDERS for file in sorted((root / folder).rglob("*")) if file.suffix in SUFFIXES]
    found = []
    for file in files:
        path = file.relative_to(root).as_posix()
        found += [f"{path}:{line}: {what}" for line, what in problems_of(path, file.read_text(encoding="utf-8"))]
    return found


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    found = problems(root)
    print("\n".join(found) or "text: no problem")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

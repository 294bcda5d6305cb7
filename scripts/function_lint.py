#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on a function of more than 60 lines in C++, CUDA or Python; prints how long the functions are.

A function counts from the first line of its head to its closing brace. Lambdas and local classes belong to the function
around them. C++ is read by counting braces, which needs no compiler: a brace at namespace or class level opens a function
if the parenthesis of a parameter list comes before it.

Usage: function_lint.py [ROOT] [--list N]
  --list N   also print the N longest functions
"""
import argparse
import ast
import re
import sys
from pathlib import Path

FOLDERS = ("core", "mbd", "io", "app", "gpu", "tests", "scripts", "cases")
CODE = (".hpp", ".cpp", ".cuh", ".cu")
LONGEST = 60  # lines; about 40 as a rule
TABLE = re.compile(r"\b\w+_(table|figures)\(\)")  # a function that only holds a table of columns may be longer

BLANKED = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
# A definition, an `extern "C"` block or a list of values, which are not functions whatever parentheses they have.
NOT_A_FUNCTION = re.compile(r"(^|[\s>;])(namespace|class|struct|union|enum|extern)\b[^()]*$|=\s*$")
# What may stand between the parameters and the body: qualifiers, a return type, the last of the initialisers.
AFTER_PARAMETERS = re.compile(r"\)\s*(const|noexcept|override|final|mutable|&|\s)*(->[^;{}]*)?$")


def blank(text):
    """The text with comments, literals and preprocessor lines replaced by spaces; lines stay where they are."""
    def hide(match):
        return re.sub(r"[^\n]", " ", match[0])
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", hide, BLANKED.sub(hide, text), flags=re.MULTILINE)


def opens_function(head):
    return bool(AFTER_PARAMETERS.search(head)) and not NOT_A_FUNCTION.search(head)


def cpp_functions(text):
    """(first line, last line, head) of each function that is not inside another one."""
    code = blank(text)
    found, open_braces, begin = [], [], 0  # begin: where the head of what comes next begins
    inside = None                          # (depth, begin and end of the head) of the function that we are in
    for at, char in enumerate(code):
        if char == "{":
            head = re.sub(r"\{[^{}]*\}", "()", code[begin:at])  # initialisers with braces read like those with parentheses
            if inside is None and opens_function(head):
                inside = (len(open_braces), begin + len(code[begin:at]) - len(code[begin:at].lstrip()), at)
            # A brace inside a head, as of the initialiser `a_{a}`, does not end the head.
            ends_head = inside is not None or not re.search(r"\)\s*:[^:;]*\w\s*$|,\s*\w+\s*$", head)
            open_braces.append((ends_head, begin))
            begin = at + 1
        elif char == "}" and open_braces:
            ends_head, outer = open_braces.pop()
            if inside and inside[0] == len(open_braces):
                found.append((code.count("\n", 0, inside[1]) + 1, code.count("\n", 0, at) + 1,
                              " ".join(text[inside[1]:inside[2]].split())))
                inside = None
            begin = at + 1 if ends_head else outer
        elif char == ";" or (char == ":" and re.search(r"\b(public|private|protected)\s*$", code[begin:at])):
            begin = at + 1
    return found


def python_functions(text):
    """(first line, last line, name) of each function that is not inside another one."""
    def walk(node):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef)):
                yield child.lineno, child.end_lineno, child.name
            else:
                yield from walk(child)
    return list(walk(ast.parse(text)))


def functions(root):
    """(file, first line, last line, name) of all functions below `root`."""
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            reader = cpp_functions if file.suffix in CODE else python_functions if file.suffix == ".py" else None
            if reader:
                path = file.relative_to(root).as_posix()
                for first, last, name in reader(file.read_text(encoding="utf-8")):
                    yield path, first, last, name


def problems(root):
    """All problems below `root`, as FILE:LINE: texts."""
    return [f"{path}:{first}: `{name}` has {last - first + 1} lines; at most {LONGEST}: divide it"
            for path, first, last, name in functions(root)
            if last - first + 1 > LONGEST and not TABLE.search(name)]


def main():
    parser = argparse.ArgumentParser(description="Fails on long functions.")
    parser.add_argument("root", type=Path, nargs="?", default=Path(__file__).resolve().parent.parent)
    parser.add_argument("--list", type=int, default=0, metavar="N", help="print the N longest functions")
    arguments = parser.parse_args()
    found = problems(arguments.root)
    print("\n".join(found) or "functions: no problem")
    by_length = sorted((last - first + 1, path, first, name) for path, first, last, name in functions(arguments.root))
    lengths = [length for length, *_ in by_length]
    if lengths:
        share = {f"p{p}": lengths[min(len(lengths) - 1, len(lengths) * p // 100)] for p in (50, 90, 99)}
        print(f"functions: {len(lengths)}, lines " + ", ".join(f"{k} {v}" for k, v in share.items()) + f", most {lengths[-1]}")
    for length, path, first, name in reversed(by_length[len(by_length) - arguments.list:]):
        print(f"  {length:4d} {path}:{first} {name}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

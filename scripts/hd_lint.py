#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on code that a device cannot run, in headers of core/math, surfaces, laws and kernels.

A developer without nvcc gets most of what nvcc would say, in a second. Beyond nvcc's rules, functions marked GYRO_HD may
use only exactly rounded arithmetic (+ - * / sqrt fma), because sin, exp or pow differ in the last bit between processors. A
header for the host only says so in a line `// Host only.` before its first #include; device headers must not include it.

Usage: hd_lint.py [ROOT]
"""
import re
import sys
from pathlib import Path

FOLDERS = ("core/math", "core/surfaces", "core/laws", "core/kernels")
HOST_ONLY = re.compile(r"^// Host only\b", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

FORBIDDEN = (
    (r"\b(throw|try|catch|new|(?<!= )delete|virtual|dynamic_cast|typeid|thread_local|goto)\b", "host only"),
    (r"\bstd::(vector|string|string_view|map|set|unordered_\w+|deque|list|function|any|optional|span|"
     r"unique_ptr|shared_ptr|make_unique|make_shared|mutex|thread|atomic\w*|runtime_error|invalid_argument)\b",
     "host only"),
    (r"\bstd::(min|max|clamp|swap|sort|accumulate|array|tuple|pair|[io]?stringstream|"
     r"cout|cerr|endl|to_string|format)\b", "a host function; write it with core/math, or name it by `using`"),
    (r"\bassert\s*\(", "host only"),
    (r"^\s*#\s*include\s*<(iostream|ostream|istream|sstream|fstream|iomanip|string|string_view|vector|map|set|"
     r"unordered_map|unordered_set|deque|list|functional|memory|thread|mutex|atomic|algorithm|numeric|random|"
     r"stdexcept|exception|filesystem|format|optional|array|span|omp\.h|cassert|cstdio)>", "a host header"),
    (r"__CUDA_?ARCH__|__CUDACC__", "for core/base/hd.hpp only"),
)
INEXACT = re.compile(
    r"(?<![\w.])(?<!->)(?:std::)?(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|"
    r"cbrt|hypot|erf|erfc|tgamma|lgamma|rsqrt)f?\s*\(")


def blank(text):
    """The text with comments and literals replaced by spaces; lines stay where they are."""
    token = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<![\w])'(?:\\.|[^'\\\n])'", re.DOTALL)
    return token.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def device_bodies(code):
    """Begin and end of the body of each function marked GYRO_HD."""
    for mark in re.finditer(r"\bGYRO_HD\b", code):
        begin = re.compile(r"[{;]").search(code, mark.end())
        if not begin or begin[0] == ";":  # declaration only
            continue
        depth = 0
        for at in range(begin.start(), len(code)):
            depth += (code[at] == "{") - (code[at] == "}")
            if depth == 0:
                yield begin.start(), at
                break


def problems_of(text, host_only_headers):
    """Problems of one device header: (line, what)."""
    code = blank(text)
    found = []
    for pattern, why in FORBIDDEN:
        for match in re.finditer(pattern, code, re.MULTILINE):
            found.append((code.count("\n", 0, match.end()) + 1, f"`{match[0].strip()}` is {why}"))
    for begin, end in device_bodies(code):
        for match in INEXACT.finditer(code, begin, end):
            line = code.count("\n", 0, match.end()) + 1
            found.append((line, f"`{match[1]}` is not exactly rounded, so the CPU and the GPU would differ"))
    for match in INCLUDE.finditer(text):
        if match[1] in host_only_headers:
            found.append((text.count("\n", 0, match.end()) + 1, f"{match[1]} is for the host only"))
    return sorted(set(found))


def is_host_only(text):
    mark, include = HOST_ONLY.search(text), INCLUDE.search(text)
    return bool(mark) and (not include or mark.start() < include.start())


def problems(root):
    """All problems below `root`, as FILE:LINE: texts."""
    texts = {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8")
             for folder in FOLDERS for file in sorted((root / folder).rglob("*.hpp"))}
    host_only = {path for path, text in texts.items() if is_host_only(text)}
    return [f"{path}:{line}: {what}"
            for path, text in texts.items() if path not in host_only
            for line, what in problems_of(text, host_only)]


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    found = problems(root)
    print("\n".join(found) or "device code: no problem")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on an #include against the direction of dependence.

    base <- math <- scene <- surfaces <- laws <- state <- kernels <- dem <- gpu
    base <- math <- exec <- dem                        (the executor knows a machine only)
    base .. laws <- geometry rocks fragments walls feed  (preparation; the engine uses nothing of it)
    base .. scene <- mbd;   scene, preparation, mbd <- io;   everything <- app

Usage: include_lint.py [ROOT]
"""
import re
import sys
from pathlib import Path

FOLDERS = ("core", "mbd", "io", "app", "gpu")
SUFFIXES = (".hpp", ".cpp", ".cuh", ".cu", ".h")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')

# The folders of core in order of dependence: each may include itself and those before it.
ENGINE = ("base", "math", "scene", "surfaces", "laws", "state", "kernels", "exec", "dem")
# Preparation stands beside the engine: it may use these, and the folders named behind each.
SHARED = ("base", "math", "scene", "surfaces", "laws")
PREPARATION = {
    "geometry": (),
    "rocks": ("geometry",),
    "fragments": ("geometry",),
    "walls": (),
    "feed": ("rocks", "walls"),
}


def core_rules():
    """What each folder of core may include, as path prefixes."""
    rules = {}
    for number, folder in enumerate(ENGINE):
        rules[f"core/{folder}"] = tuple(f"core/{name}/" for name in ENGINE[:number + 1])
    for folder, others in PREPARATION.items():
        rules[f"core/{folder}"] = tuple(f"core/{name}/" for name in (*SHARED, *others, folder))
    # The executor knows a machine and nothing of what it computes.
    rules["core/exec"] = ("core/base/", "core/math/", "core/exec/")
    return rules


# The longest folder that fits a file decides; it may include files whose path starts so.
ALLOWED = {
    **core_rules(),
    "mbd": ("core/base/", "core/math/", "core/scene/", "mbd/"),
    "io": (*(f"core/{name}/" for name in ("base", "math", "scene", *PREPARATION)), "mbd/", "io/"),
    "gpu": (*(f"core/{name}/" for name in ENGINE), "gpu/"),
    "app": ("core/", "mbd/", "io/", "gpu/", "app/"),
}

# Libraries by the headers they are known by, and the folders that may name them.
LIBRARIES = (
    ("yaml-cpp", r"yaml-cpp/", ("io",)),
    ("HDF5", r"(hdf5|H5\w*)\.h$|hdf5/", ("io", "app")),
    ("VTK", r"vtk\w+\.h(xx)?$", ("io", "app")),
    ("SUNDIALS", r"(cvode|nvector|sunmatrix|sunlinsol|sunnonlinsol|sundials|arkode|kinsol|ida)/", ("mbd", "app")),
    ("CUDA", r"(cuda|curand|cublas|nvtx|nvrtc|nvml)[\w/]*|(cub|thrust|nv|nvtx3)/|cooperative_groups|vector_types\.h",
     ("gpu",)),
    ("CGAL", r"CGAL/", ("core/geometry",)),
    ("spdlog or fmt", r"(spdlog|fmt)/", ("mbd", "io", "app")),
    ("CLI11", r"CLI/", ("app",)),
    ("nlohmann-json", r"nlohmann/", ("io", "app")),
    ("libzip or pugixml", r"(zip\.h|pugixml\.hpp)$", ("io/fmu",)),
)


def inside(path, folder):
    return path.startswith(folder + "/")


def problem_with(path, quote, header, root):
    """Why the file at `path` (relative to the root) may not include `header`, or None."""
    if quote == '"' and header.split("/")[0] not in FOLDERS:
        if header.startswith(".") or (root / path).parent.joinpath(header).exists():
            return "is relative to the file; includes are relative to the project root"
    if header.split("/")[0] in FOLDERS + ("tests",):
        rule = max((folder for folder in ALLOWED if inside(path, folder)), key=len)
        if not header.startswith(ALLOWED[rule]):
            return f"is against the arrows; {rule} may include {', '.join(ALLOWED[rule])}"
        if inside(path, "io") and header.startswith("mbd/cvode"):
            return "is the drivetrain's solver; io may include its parameters only"
    for library, pattern, folders in LIBRARIES:
        if re.match(pattern, header) and not any(inside(path, folder) for folder in folders):
            return f"belongs to {library}, which only {', '.join(folders)} may include"
    return None


def problems(root):
    """All problems below `root`, as FILE:LINE: texts."""
    found = []
    files = [file for folder in FOLDERS for file in sorted((root / folder).rglob("*")) if file.suffix in SUFFIXES]
    for file in files:
        path = file.relative_to(root).as_posix()
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            why = match and problem_with(path, match[1], match[2], root)
            if why:
                found.append(f"{path}:{number}: {match[2]} {why}")
    return found


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    found = problems(root)
    print("\n".join(found) or "includes: no problem")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

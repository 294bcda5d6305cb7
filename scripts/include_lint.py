#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on an #include against the direction of dependence, or on a library outside the folders that may name it.

    base <- math <- scene <- surfaces <- laws <- state <- kernels <- dem <- gpu    the engine
    base <- math <- exec <- dem                              the executor knows a machine and nothing of what it computes
    base .. laws <- geometry rocks fragments walls feed      preparation; the engine uses nothing of it
    base .. scene <- mbd                                     the drivetrain knows windows, not the particle engine
    base .. surfaces, preparation, mbd <- io                 files; in it hdf5 <- run, yaml <- schema <- case; mesh stands alone
    everything <- app                                        in it simulation <- verify, bench, sweep <- commands; report

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


SCENE = ("core/base/", "core/math/", "core/scene/")
DATA = (*SCENE, "core/surfaces/", *(f"core/{name}/" for name in PREPARATION))
PROGRAM = ("core/", "mbd/", "io/", "gpu/", "app/version.hpp")

# The longest folder that fits a file decides; it may include files whose path starts so.
ALLOWED = {
    **core_rules(),
    "gpu": (*(f"core/{name}/" for name in ENGINE), "gpu/"),
    "mbd": (*SCENE, "mbd/"),
    "io": (*DATA, "mbd/", "io/"),
    "io/files": ("core/base/", "io/files/"),
    "io/yaml": ("core/base/", "io/yaml/"),
    "io/schema": (*DATA, "mbd/", "io/yaml/", "io/schema/"),
    "io/hdf5": ("core/base/", "io/hdf5/"),
    "io/mesh": (*DATA, "io/files/", "io/mesh/"),
    "io/run": (*DATA, "mbd/", "io/files/", "io/hdf5/", "io/run/"),
    "io/fields": (*DATA, "io/hdf5/", "io/run/", "io/fields/"),
    "io/rocks": (*DATA, "io/files/", "io/mesh/", "io/hdf5/", "io/run/", "io/rocks/"),
    "app": (*PROGRAM, "app/"),
    "app/simulation": ("core/", "mbd/", "gpu/", "app/simulation/"),  # a library: no case files, no output files
    "app/assembly": (*PROGRAM, "app/simulation/", "app/assembly/"),
    "app/output": (*PROGRAM, "app/simulation/", "app/assembly/", "app/output/"),
    "app/run": (*PROGRAM, "app/simulation/", "app/assembly/", "app/output/", "app/run/"),
    "app/sweep": (*PROGRAM, "app/simulation/", "app/assembly/", "app/output/", "app/run/", "app/sweep/"),
    "app/report": (*DATA, "mbd/", "io/", "app/report/"),  # reads what runs have written
    "app/verify": (*PROGRAM, "app/simulation/", "app/verify/"),
    "app/bench": (*PROGRAM, "app/simulation/", "app/assembly/", "app/output/", "app/run/", "app/bench/"),
    "app/examples": ("core/", "gpu/", "mbd/", "app/simulation/", "app/examples/"),  # what a user of the installed library sees
}

# Headers that a folder may not include although their folder is allowed: path prefixes, and what they are.
EXCEPTIONS = {
    "mbd": (("core/scene/dem.hpp", "the particle engine's interface; mbd may use the window and the walls' motion"),),
    "io": (("mbd/cvode_session", "the drivetrain's solver; io may use its parameters"),
           ("mbd/shaft", "the drivetrain's solver; io may use its parameters")),
}

# Libraries by the headers they are known by, and the folders or files that may name them.
LIBRARIES = (
    ("yaml-cpp", r"yaml-cpp/", ("io/yaml",)),
    ("HDF5", r"(hdf5|H5\w*)\.h$|hdf5/", ("io/hdf5",)),
    ("VTK", r"vtk\w+\.h(xx)?$", ("io/run",)),
    ("SUNDIALS", r"(cvode|nvector|sunmatrix|sunlinsol|sunnonlinsol|sundials|arkode|kinsol|ida)/", ("mbd",)),
    ("CUDA", r"(cuda|curand|cublas|nvtx|nvrtc|nvml)[\w/]*|(cub|thrust|nv|nvtx3)/|cooperative_groups|vector_types\.h",
     ("gpu",)),
    ("CGAL", r"CGAL/", ("core/geometry",)),
    ("Eigen", r"Eigen/", ("core/geometry", "core/rocks", "app/verify")),
    ("OpenMP", r"omp\.h$", ()),  # threads are those of core/base/thread_team.hpp
    ("spdlog or fmt", r"(spdlog|fmt)/", ("io/run",)),
    ("nlohmann-json", r"nlohmann/", ("io/schema", "io/run", "app")),
    ("libzip or pugixml", r"(zip\.h|pugixml\.hpp)$", ("io/fmu",)),
    ("CLI11", r"CLI/", ("app/command_line",)),
)


def inside(path, place):
    """Whether the file at `path` is `place` or lies in it."""
    return path == place or path.startswith(place + "/")


def problem_with(path, quote, header, root):
    """Why the file at `path` (relative to the root) may not include `header`, or None."""
    if quote == '"' and header.split("/")[0] not in FOLDERS:
        if header.startswith(".") or (root / path).parent.joinpath(header).exists():
            return "is relative to the file; includes are relative to the project root"
    if header.split("/")[0] in FOLDERS + ("tests",):
        rule = max((folder for folder in ALLOWED if inside(path, folder)), key=len, default=None)
        if rule is None:
            return "is included from a folder that has no place in the order; give it one in include_lint.py"
        if not header.startswith(ALLOWED[rule]):
            return f"is against the arrows; {rule} may include {', '.join(ALLOWED[rule])}"
        for folder, headers in EXCEPTIONS.items():
            for prefix, what in headers:
                if inside(path, folder) and header.startswith(prefix):
                    return f"is {what}"
    for library, pattern, places in LIBRARIES:
        if re.match(pattern, header) and not any(inside(path, place) for place in places):
            return f"belongs to {library}, which {('only ' + ', '.join(places)) if places else 'no folder'} may include"
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

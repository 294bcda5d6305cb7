# SPDX-License-Identifier: GPL-3.0-or-later
"""How the scripts end on bad input and where a Debian package is missing: a message on stderr, and exit code 2."""
import importlib.util
import shutil
import sys
from pathlib import Path

MODULES = {"h5py": "python3-h5py", "matplotlib": "python3-matplotlib", "numpy": "python3-numpy",
           "vtkmodules": "python3-vtk9", "yaml": "python3-yaml"}
PROGRAMS = {"xvfb-run": "xvfb", "xauth": "xauth", "nvcc": "nvidia-cuda-toolkit", "c++filt": "binutils"}


def fail(message):
    """Ends the script. The message says what is wrong and what to do."""
    print(f"{Path(sys.argv[0]).name}: {message}", file=sys.stderr)
    sys.exit(2)


def need(*modules):
    """Ends the script with the packages to install, if Python lacks one of `modules`."""
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if missing:
        fail(f"Python ({sys.executable}) has no {', '.join(missing)}; {installation(MODULES[name] for name in missing)}"
             " and call the script by /usr/bin/python3")


def need_programs(*programs, otherwise=""):
    """Ends the script with the packages to install, if one of `programs` is not in PATH.

    otherwise  what else the user can do, as `, or give --option`
    """
    missing = [name for name in programs if not shutil.which(name)]
    if missing:
        fail(f"there is no {' and no '.join(missing)}; {installation(PROGRAMS[name] for name in missing)}{otherwise}")


def installation(packages):
    return f"run `apt-get install --no-install-recommends {' '.join(packages)}` as root"

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the registers, stack frame and spilled bytes of every CUDA kernel.

Needs nvcc, no GPU. Fails (exit 1) when a kernel is above its limit: no stack and no spills, unless LIMITS names the
kernel and the reason; few enough registers for two blocks of 128 threads.

Usage: kernel_report.py [--arch 80,90] [--nvcc PATH] [--all]
  --all   also list the kernels that only copy or clear memory
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from errors import fail, need_programs

ROOT = Path(__file__).resolve().parent.parent
FLAGS = ["-std=c++20", "-O3", "-DNDEBUG", "--fmad=false", "-Xcompiler=-ffp-contract=off"]

# Largest stack frame and spilled bytes of kernels that may have any. The first two compare the contact points of a wall
# with each other, in arrays of up to six points; the third has an array of the radii of levels. Arrays that are indexed
# at run time lie on the stack.
LIMITS = {"WallForces": (1536, 0), "ContactSums": (1024, 0), "LevelRadii": (128, 0)}
MAX_REGISTERS = 255
PLAIN = re.compile(r"Keep<|ClearWallSums|CellBegins")

ENTRY = re.compile(
    r"Compiling entry function '(?P<name>\S+)'.*?(?P<stack>\d+) bytes stack frame, (?P<stores>\d+) bytes spill stores, "
    r"(?P<loads>\d+) bytes spill loads.*?Used (?P<registers>\d+) registers", re.DOTALL)


def compiled(nvcc, arch):
    """What ptxas says of the kernels of gpu/dem_cuda.cu: (name, registers, stack, stores, loads)."""
    with tempfile.TemporaryDirectory() as folder:
        command = [nvcc, *FLAGS, f"-I{ROOT}", f"-gencode=arch=compute_{arch},code=sm_{arch}", "-Xptxas=-v", "-cubin",
                   str(ROOT / "gpu/dem_cuda.cu"), "-o", f"{folder}/dem_cuda.cubin"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    rows = [match.group("name", "registers", "stack", "stores", "loads") for match in ENTRY.finditer(done.stderr)]
    names = subprocess.run(["c++filt"], input="\n".join(row[0] for row in rows), capture_output=True, text=True,
                           check=True).stdout.splitlines()
    return sorted((short(name), *map(int, row[1:])) for name, row in zip(names, rows))


def short(name):
    """void gyro::run_each<gyro::Move>(int, gyro::Move) -> run_each Move"""
    inside = re.match(r"void (\w+)<(.*)>\(", name.replace("gyro::", ""))
    return f"{inside[1]} {inside[2].replace(' >', '>')}" if inside else name


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--arch", default="80,90")
    arguments.add_argument("--nvcc", default="nvcc")
    arguments.add_argument("--all", action="store_true")
    options = arguments.parse_args()
    if options.nvcc != "nvcc" and not shutil.which(options.nvcc):
        fail(f"--nvcc {options.nvcc} is no program; name CUDA's compiler, often /usr/local/cuda/bin/nvcc")
    need_programs(*(["nvcc"] if options.nvcc == "nvcc" else []), "c++filt", otherwise=", or give --nvcc PATH")
    archs = options.arch.split(",")
    with ThreadPoolExecutor(2) as pool:
        reports = list(pool.map(lambda arch: compiled(options.nvcc, arch), archs))
    failed = 0
    for arch, rows in zip(archs, reports):
        print(f"sm_{arch}: {len(rows)} kernels\n  registers  stack  spilled  kernel")
        failed += not rows
        for name, registers, stack, stores, loads in rows:
            allowed = next((limit for key, limit in LIMITS.items() if key in name), (0, 0))
            above = registers > MAX_REGISTERS or stack > allowed[0] or max(stores, loads) > allowed[1]
            failed += above
            if above or options.all or not PLAIN.search(name):
                print(f"  {registers:9d}  {stack:5d}  {stores:7d}  {name}{'  ABOVE ITS LIMIT' if above else ''}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts that run LAMMPS beside gyrosim share: random numbers of the same seeds, and the call."""
import subprocess

WORD = 0xFFFFFFFF


def uniform(seed, stream, thing, draw):
    """Philox4x32-10 (Salmon et al. 2011) as core/math/random.hpp uses it: a number in (0, 1)."""
    key, c = [seed & WORD, seed >> 32], [thing & WORD, thing >> 32, draw, stream]
    for _ in range(10):
        a, b = 0xD2511F53 * c[0], 0xCD9E8D57 * c[2]
        c = [(b >> 32) ^ c[1] ^ key[0], b & WORD, (a >> 32) ^ c[3] ^ key[1], a & WORD]
        key = [(key[0] + 0x9E3779B9) & WORD, (key[1] + 0xBB67AE85) & WORD]
    return (((c[0] << 20) | (c[1] >> 12)) + 0.5) / 2.0**52


def run_lammps(program, script, variables):
    """Runs an input file with variables by name; ends this program with LAMMPS' messages when that fails."""
    command = [program, "-log", "none", "-in", str(script)]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{script}: {program} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")

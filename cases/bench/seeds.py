# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of a case with several settings and the same seeds, and their differences seed by seed."""
import math
import os
import pathlib
import statistics
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

STOPPED = 4  # exit code of a run that the guard stopped


def run_case(program, case, settings, out, options=()):
    """Runs a case on one thread. @returns its user seconds, or None if the guard stopped it"""
    command = [program, "run", str(case), "--threads", "1", "--quiet", "--out", str(out), *options]
    for setting in (*settings, "output.snapshots=0"):
        command += ["--set", setting]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    problem = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    code = os.waitstatus_to_exitcode(status)
    if code == STOPPED:
        return None
    if code:
        raise SystemExit(f"{' '.join(command)}\n{problem}")
    return usage.ru_utime


def over_seeds(variants, seeds, jobs, one_run):
    """one_run(variant, seed, directory) for all of them. @returns lists by variant, of the seeds that no variant lacks"""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        waiting = {(k, seed): pool.submit(one_run, variant, seed, pathlib.Path(folder) / f"{k}-{seed}")
                   for k, variant in enumerate(variants) for seed in range(1, seeds + 1)}
        runs = [[waiting[k, seed].result() for seed in range(1, seeds + 1)] for k in range(len(variants))]
    for variant, results in zip(variants, runs):
        if None in results:
            print(f"`{variant}`: {results.count(None)} runs stopped by the guard; their seeds are left out of all rows")
    whole = [n for n in range(seeds) if all(results[n] for results in runs)]
    return {variant: [results[n] for n in whole] for variant, results in zip(variants, runs)}


def difference(values, reference, relative=True):
    """Mean and standard error of the differences seed by seed; relative: in percent of the mean of the reference."""
    scale = statistics.mean(reference) / 100 if relative else 1
    if scale == 0 or math.isnan(sum(values) + sum(reference)):
        return math.nan, math.nan
    pairs = [(a - b) / scale for a, b in zip(values, reference)]
    error = statistics.stdev(pairs) / math.sqrt(len(pairs)) if len(pairs) > 1 else math.nan
    return statistics.mean(pairs), error

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What to do first on a machine with an NVIDIA GPU: is the CUDA engine right, and how fast is it?
#   scripts/gpu_day.sh [BUILD [OUT]]
# BUILD has gyrosim and the test programs (default build/cuda, which is configured and built if it is missing);
# the logs go to OUT (default gpu-day). Ends with a table; the exit code is 1 if any step failed.
#   GPU_DAY_STEPS="device bits"   only these of: device bits sanitize compare ahead speed size
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build/cuda}
out=${2:-gpu-day}
steps=${GPU_DAY_STEPS:-device bits sanitize compare ahead speed size}
mkdir -p "$out"
worst=0

say() { echo "gpu day: $*" | tee -a "$out/summary.txt"; }

# step NAME SECONDS COMMAND...: runs it with a limit, its output to OUT/NAME.log.
step() {
  local name=$1 limit=$2 begin=$SECONDS code
  shift 2
  timeout "$limit" bash -c '"$@"' _ "$@" >"$out/$name.log" 2>&1
  code=$?
  if [ $code -eq 0 ]; then say "ok    $name ($((SECONDS - begin)) s)"; else
    say "FAIL  $name (exit $code, $((SECONDS - begin)) s): $(tail -n 1 "$out/$name.log")"
    worst=1
  fi
  return $code
}

asked() { [[ " $steps " == *" $1 "* ]]; }

gyrosim=$build/gyrosim
if [ ! -x "$gyrosim" ]; then
  (cd "$root" && cmake --preset cuda && cmake --build --preset cuda --target gyrosim test_cuda) || exit 1
fi
test_cuda=$(find "$build" -name test_cuda -type f -perm -u+x | head -n 1)

# Particle-steps a second of a run, from its summary; and how its time was spent, from its log.
speed_of() {
  python3 - "$1" <<'PY'
import json, sys
s = json.load(open(sys.argv[1] + "/summary.json"))
w = s["wall_seconds"]
print(f'{s["particles"]} particles, {s["particle_steps"] / w:.3g} particle-steps/s, {s["bond_steps"] / w:.3g} bond-steps/s, '
      f'{w:.2f} s for {s["simulated_seconds"]:.4g} s at {s["time_step"] * 1e6:.3g} us, {s["status"]}')
PY
}

# Launches, reads and bytes a step of a run on a device, from its log.
traffic_of() {
  python3 - "$1" <<'PY'
import json, re, sys
s = json.load(open(sys.argv[1] + "/summary.json"))
steps = s["simulated_seconds"] / s["hold"]
counts = re.findall(r"device (\w+): (\d+)", open(sys.argv[1] + "/log.txt").read())
print(f"{steps:.0f} steps; a step:", ", ".join(f"{int(n) / steps:.3g} {name}" for name, n in counts))
PY
}

# Compares all series of two runs bit by bit, except the wall clock.
same_series() {
  python3 - "$1" "$2" <<'PY'
import sys, h5py, numpy
a, b = (h5py.File(run + "/results.h5") for run in sys.argv[1:3])
bad = [g + "/" + n for g in ("series", "ledger") for n in a[g] if n != "wall_seconds"
       and a[g][n][()].tobytes() != b[g][n][()].tobytes()]
for name in bad:
    x, y = a[name][()], b[name][()]
    where = numpy.argwhere(x.reshape(len(x), -1) != y.reshape(len(y), -1))
    print(name, "first differs in row", where[0][0], x[where[0][0]], y[where[0][0]])
print("rows", len(a["series/time"]), "differing datasets", len(bad))
sys.exit(1 if bad else 0)
PY
}

run_case() { # NAME CASE OPTIONS...
  local name=$1 case=$2
  shift 2
  "$gyrosim" run "$root/cases/$case" --quiet --overwrite --out "$out/runs/$name" "$@"
}

# How far the device may run ahead of the host, and graphs: NAME GYRO_CUDA_AHEAD GYRO_CUDA_GRAPHS. Same bits, other times.
run_ahead() { # NAME AHEAD GRAPHS
  GYRO_CUDA_AHEAD=$2 GYRO_CUDA_GRAPHS=$3 run_case "$1" quickstart.yaml --until "20 ms" --device cuda
}
bits_of() { # AHEAD GRAPHS
  GYRO_CUDA_AHEAD=$1 GYRO_CUDA_GRAPHS=$2 "$test_cuda"
}

export -f run_case run_ahead bits_of same_series
export gyrosim root out test_cuda

if asked device; then
  step device 60 nvidia-smi
  step info 60 "$gyrosim" info
  say "$(grep -i cuda "$out/info.log" | head -n 1)"
fi
if asked bits; then
  step bits 200 "$test_cuda"
  step bits-without-graphs 200 bits_of 1000000 0
  step bits-step-by-step 200 bits_of 1 0
fi
if asked sanitize; then
  sanitizer=$(command -v compute-sanitizer || true)
  if [ -z "$sanitizer" ]; then
    say "skip  sanitize: no compute-sanitizer"
  else
    for tool in memcheck racecheck initcheck; do
      step "$tool" 120 "$sanitizer" --tool $tool --error-exitcode 9 "$test_cuda" "A device gives the bits of the CPU"
    done
  fi
fi
if asked compare; then
  for device in cuda cpu; do
    step "quickstart-$device" 150 run_case "quickstart-$device" quickstart.yaml --until "20 ms" --device $device &&
      say "      $(speed_of "$out/runs/quickstart-$device")"
  done
  step same-series 60 same_series "$out/runs/quickstart-cuda" "$out/runs/quickstart-cpu"
fi
if asked ahead; then
  for setting in "1 0" "16 0" "1000000 0" "16 1" "64 1" "1000000 1"; do
    read -r ahead graphs <<<"$setting"
    name=ahead-$ahead-graphs-$graphs
    step "$name" 150 run_ahead "$name" "$ahead" "$graphs" &&
      say "      $(speed_of "$out/runs/$name")" && say "      $(traffic_of "$out/runs/$name")" &&
      step "$name-bits" 60 same_series "$out/runs/$name" "$out/runs/ahead-1-graphs-0"
  done
fi
if asked speed; then
  for device in cuda cpu; do
    step "primary-$device" 150 run_case "primary-$device" mkii-62-75/case.yaml --until "2 ms" --device $device &&
      say "      $(speed_of "$out/runs/primary-$device")"
  done
  say "      $(traffic_of "$out/runs/primary-cuda")"
  GYRO_CUDA_SYNC=1 step primary-phases 100 run_case primary-phases mkii-62-75/case.yaml --until "1 ms" --device cuda &&
    grep phase "$out/runs/primary-phases/log.txt" | tee -a "$out/summary.txt"
fi
if asked size; then
  step size 200 run_case size mkii-62-75/case.yaml --until "1 ms" --device cuda --set "feed.initial=16 t" &&
    say "      $(speed_of "$out/runs/size")"
fi
exit $worst

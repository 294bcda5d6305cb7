#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configures build/release once and builds targets there (default: all). Messages go to
# standard error. A folder that is configured already is kept as it is, so options given
# with `cmake --preset release -D...` stay.
#   scripts/build.sh [target]...
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

# A file with CGAL, VTK or CLI11 takes up to 1.5 GB to compile.
parallel_jobs() {
  local cores memory limit jobs
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo)
  if limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null) && [[ $limit =~ ^[0-9]+$ ]]; then
    limit=$((limit / 1048576))
    memory=$((limit < memory ? limit : memory))
  fi
  jobs=$((memory / 1536))
  jobs=$((jobs < cores ? jobs : cores))
  echo $((jobs > 1 ? jobs : 1))
}

is_configured() { [ -f "$build/build.ninja" ] || [ -f "$build/Makefile" ]; }

# True when AUTO found no CUDA compiler, but one appeared since it was last looked for.
cuda_appeared() {
  [ -n "$nvcc" ] && [ "$nvcc" != "$(cat "$build/.nvcc" 2>/dev/null)" ] &&
    grep -q '^GYRO_CUDA:[A-Z]*=AUTO$' "$build/CMakeCache.txt" &&
    ! compgen -G "$build/CMakeFiles/*/CMakeCUDACompiler.cmake" >/dev/null
}

mkdir -p "$build"
exec 9>"$build/.lock"
flock 9  # two calls at once would build over each other

nvcc=$(command -v nvcc || ls /usr/local/cuda/bin/nvcc 2>/dev/null || true)
if ! is_configured; then
  (cd "$root" && cmake --preset release) >&2
elif cuda_appeared; then
  cmake -UCMAKE_CUDA_COMPILER "$build" >&2
fi
echo "$nvcc" >"$build/.nvcc"

targets=()
if [ $# -gt 0 ]; then targets=(--target "$@"); fi
cmake --build "$build" --parallel "$(parallel_jobs)" "${targets[@]}" >&2

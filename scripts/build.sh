#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configures build/release once and builds targets there (default: all). Messages go to
# standard error. A folder that is configured already is kept as it is, so options given
# with `cmake --preset release -D...` stay.
#   scripts/build.sh [--cuda] [target]...
# GYRO_CMAKE_OPTIONS: options for the first configuration, e.g. "-DGYRO_WERROR=ON -DGYRO_PRECOMPILE=OFF".
# --cuda: with the CUDA engine wherever nvcc is found; otherwise only where there is a device, too.
set -euo pipefail

wanted_cuda=no
if [ "${1-}" = --cuda ]; then wanted_cuda=yes; shift; fi

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

# True when the folder leaves the choice to us and is configured without CUDA.
cuda_is_open() {
  grep -q '^GYRO_CUDA:[A-Z]*=AUTO$' "$build/CMakeCache.txt" &&
    ! compgen -G "$build/CMakeFiles/*/CMakeCUDACompiler.cmake" >/dev/null
}

mkdir -p "$build"
exec 9>"$build/.lock"
flock 9  # two calls at once would build over each other

nvcc=$(command -v nvcc || ls /usr/local/cuda/bin/nvcc 2>/dev/null || true)
found="$nvcc $("$root/scripts/cuda_device.sh" 2>/dev/null || true)"
with_cuda=()
if [ $wanted_cuda = yes ] && [ -n "$nvcc" ]; then with_cuda=(-DGYRO_CUDA=ON); fi
if ! is_configured; then
  # shellcheck disable=SC2086  # options are separated by spaces
  (cd "$root" && cmake --preset release "${with_cuda[@]}" ${GYRO_CMAKE_OPTIONS-}) >&2
elif cuda_is_open && { [ ${#with_cuda[@]} -gt 0 ] || [ "$found" != "$(cat "$build/.cuda" 2>/dev/null)" ]; }; then
  cmake -UCMAKE_CUDA_COMPILER "${with_cuda[@]}" "$build" >&2  # a compiler or a device appeared
fi
echo "$found" >"$build/.cuda"

targets=()
if [ $# -gt 0 ]; then targets=(--target "$@"); fi
cmake --build "$build" --parallel "$(parallel_jobs)" "${targets[@]}" >&2

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds everything (CUDA wherever nvcc is found, device or not) and runs every test but the
# nightly ones.
# Arguments go to ctest:
#   scripts/test.sh [-L unit] [-R bond] [-L nightly] ...
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$scripts")

"$scripts/setup.sh"
"$scripts/build.sh" --cuda

# Two -LE options would exclude only what matches both.
select=(-LE nightly)
for argument in "$@"; do
  case $argument in
    -LE* | --label-exclude* | *nightly*) select=() ;;
  esac
done

exec ctest --test-dir "$root/build/release" --output-on-failure --no-tests=error -j "$(nproc)" "${select[@]}" "$@"

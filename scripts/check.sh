#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The check before a commit, about a minute when little has changed: format, lints, build
# (with CUDA where nvcc is installed) and the tests labelled unit.
#   scripts/check.sh          check
#   scripts/check.sh --fix    format the sources first
#   scripts/check.sh --tidy   clang-tidy as well (slow)
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$scripts")
cd "$root"

fix=no tidy=no tools=(git clang-format)
for argument in "$@"; do
  case $argument in
    --fix) fix=yes ;;
    --tidy) tidy=yes tools+=(clang-tidy) ;;
    *) sed -n '3,7s/^# //p' "$0"; echo "unknown argument: $argument; use --fix or --tidy" >&2; exit 2 ;;
  esac
done

"$scripts/setup.sh" "${tools[@]}"

failed=()
step() {  # NAME COMMAND...: continues after a failure, so that one call shows all problems
  echo "== $1"
  "${@:2}" || failed+=("$1")
}

# Existing files that match the patterns: those in git, and new ones that git does not ignore.
sources() { git ls-files -z --cached --others --exclude-standard -- "$@" | xargs -0 -r ls -d 2>/dev/null; }
mapfile -t code < <(sources '*.hpp' '*.cpp' '*.cuh' '*.cu')

format_sources() { clang-format --dry-run -Werror "${code[@]}"; }
# A second compiler's eyes; it knows neither all of GCC's options nor nvcc's.
tidy_sources() {
  sources '*.cpp' | xargs -r -n 1 -P "$(nproc)" clang-tidy --quiet -p build/release \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument \
    2> >(grep -v ' warnings\? generated' >&2)
}

if [ $fix = yes ]; then clang-format -i "${code[@]}"; fi
step "format" format_sources
step "text" "$scripts/text_lint.py"
step "words" "$scripts/words_lint.py"
step "length of functions" "$scripts/function_lint.py"
step "include directions" "$scripts/include_lint.py"
step "device code" "$scripts/hd_lint.py"
step "build and unit tests" "$scripts/test.sh" -L unit
if [ $tidy = yes ]; then step "clang-tidy" tidy_sources; fi

if [ ${#failed[@]} -gt 0 ]; then
  (IFS=,; echo "check: FAILED: ${failed[*]}")
  exit 1
fi
echo "check: passed"

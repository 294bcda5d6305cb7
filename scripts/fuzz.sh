#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail

usage() {
  cat <<'END'
scripts/fuzz.sh [SECONDS [TARGET...]]
  Feeds everything that reads files of users with any bytes, each target (case, table, fmu, mesh, state, summary,
  library, vtp) for SECONDS (default 60), with address and undefined-behaviour sanitizers. Inputs that reached new code
  are kept in build/fuzz/corpus/TARGET, so that a later call goes on from them. An input that crashed, leaked or took
  more than 10 s lies in build/fuzz/found/TARGET-*: mend the cause, and put the input into tests/fuzz/corpus/TARGET.
  Exit code 1 if there is one. Needs the package clang.
END
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1-} in -h | --help) usage; exit 0 ;; esac
seconds=${1:-60}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(case table fmu mesh state summary library vtp)
if ! command -v clang++ > /dev/null; then echo "fuzz.sh: clang++ is missing; install the package clang" >&2; exit 2; fi

cd "$root"
cmake --preset fuzz > /dev/null
cmake --build --preset fuzz -j "$(nproc)"
found=$root/build/fuzz/found
mkdir -p "$found"

# Files of the project from which a target starts.
seeds() {
  case $1 in
    case) find cases tests -name '*.yaml' ;;
    table) find cases tests -name '*.csv' ;;
    mesh) find build tests -name '*.stl' -size -40k -o -name '*.obj' -size -40k ;;
    fmu) find build -name 'modelDescription.xml' -o -name '*.fmu' -size -40k ;;
    summary) find build runs -name 'summary.json' 2> /dev/null || true ;;
    vtp) find build runs -name '*.vtp' -size -40k 2> /dev/null || true ;;
  esac
}

failed=0
for target in "${targets[@]}"; do
  corpus=build/fuzz/corpus/$target
  mkdir -p "$corpus"
  if [ -d "tests/fuzz/corpus/$target" ]; then cp tests/fuzz/corpus/"$target"/* "$corpus"; fi
  seeds "$target" | while read -r file; do cp "$file" "$corpus/$(echo "$file" | tr / _)"; done
  echo "== $target, $seconds s"
  ASAN_OPTIONS=allocator_may_return_null=1 \
    build/fuzz/tests/fuzz/fuzz_"$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=4096 -max_len=65536 \
    -print_final_stats=1 -artifact_prefix="$found/$target-" "$corpus" > "$found/$target.log" 2>&1 || failed=1
  grep -E "stat::number_of_executed_units|stat::average_exec|ERROR|SUMMARY" "$found/$target.log" || true
done
exit $failed

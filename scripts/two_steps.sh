#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail

usage() {
  cat <<'END'
scripts/two_steps.sh COARSE.yaml FINE.yaml [--out DIR] [--error ERROR] [--compare] [--threads N]
  Runs the coarse case until it is steady, fills the chamber of the fine case with what the coarse one holds up, and runs the
  fine case until it is steady: runs DIR/coarse and DIR/fine (default DIR: runs/two-steps). feed.initial of the fine
  case is not used. ERROR: relative standard error of throughput, crushing power and P80 at which a run ends (default
  5%); time.duration of each case is the longest that it runs.
  --compare  runs the fine case from two other starts too, an empty chamber (DIR/empty) and one that holds 1.6 times
             as much, all of it unbroken rocks (DIR/full), and compares the three: exit code 1 where figures differ by more
             than 3 standard errors.
  A call that was interrupted is repeated with the same arguments. GYROSIM: the program; else build/release/gyrosim,
  which is built.
END
}

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$scripts")
out=runs/two-steps error=5% compare=no cases=() options=()
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --out | --error | --threads)
      if [ $# -lt 2 ]; then echo "two_steps.sh: $1 needs a value" >&2; exit 2; fi
      case $1 in --out) out=$2 ;; --error) error=$2 ;; --threads) options+=(--threads "$2") ;; esac
      shift ;;
    --compare) compare=yes ;;
    -*) echo "two_steps.sh: there is no $1; --help lists the options" >&2; exit 2 ;;
    *) cases+=("$1") ;;
  esac
  shift
done
if [ ${#cases[@]} -ne 2 ]; then usage >&2; exit 2; fi

if [ -z "${GYROSIM-}" ]; then
  "$scripts/setup.sh"
  "$scripts/build.sh" gyrosim
  GYROSIM=$root/build/release/gyrosim
fi
mkdir -p "$out"
out=$(cd "$out" && pwd)

# run NAME CASE [options]: to the steady state; a run that is done already is left as it is.
run() {
  local name=$1 case=$2
  shift 2
  echo "== $name" >&2
  "$GYROSIM" run "$case" "$@" "${options[@]}" --until "steady=$error" --out "$out/$name" --resume
}

bare=(--set feed.initial=null --set feed.initial_top=null)
run coarse "${cases[0]}"
run fine "${cases[1]}" "${bare[@]}" --set "feed.initial_from=$out/coarse"
if [ $compare = no ]; then exit 0; fi
run empty "${cases[1]}" "${bare[@]}"
held=$(/usr/bin/python3 -c 'import json, sys; print(1.6 * json.load(open(sys.argv[1]))["holdup_mass"])' "$out/coarse/summary.json")
run full "${cases[1]}" --set "feed.initial=$held" --set feed.initial_top=null
exec "$scripts/compare_runs.py" "$out/fine" "$out/empty" "$out/full"

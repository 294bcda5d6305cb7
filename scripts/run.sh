#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail

usage() {
  cat <<'END'
scripts/run.sh [CASE] [options]
  Installs what is missing (Debian packages), builds build/release/gyrosim, and runs
  `gyrosim run CASE [options]`. Without CASE: cases/quickstart.yaml.
  `build/release/gyrosim run --help` lists the options.
END
}

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$scripts")

if [ $# -eq 0 ] || [[ $1 == -* ]]; then
  if [[ ${1-} == -h || ${1-} == --help ]]; then usage; exit 0; fi
  set -- "$root/cases/quickstart.yaml" "$@"
fi

"$scripts/setup.sh"
"$scripts/build.sh" gyrosim
exec "$root/build/release/gyrosim" run "$@"

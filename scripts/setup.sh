#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages that gyrosim needs and that are missing. Never asks; does
# nothing, and needs no rights, when all are there.
#   scripts/setup.sh [more packages]
set -euo pipefail

packages=(build-essential cmake ninja-build python3
          libeigen3-dev libsundials-dev libyaml-cpp-dev libcli11-dev libspdlog-dev
          libzip-dev libpugixml-dev libhdf5-dev libvtk9-dev libcgal-dev catch2 nlohmann-json3-dev libxxhash-dev zlib1g-dev "$@")

say() { echo "setup: $*" >&2; }

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  say "no apt here, so nothing is checked; gyrosim needs what Debian 12 calls: ${packages[*]}"
  exit 0
fi

# Debian's python3-paraview conflicts with python3-vtk9, which libvtk9-dev needs. Without it snapshots are the same.
if [ "$(dpkg-query -W -f='${db:Status-Status}' python3-paraview 2>/dev/null || true)" = installed ]; then
  say "python3-paraview is installed, beside which Debian has no libvtk9-dev: snapshots are written without VTK's library"
  kept=()
  for package in "${packages[@]}"; do [ "$package" = libvtk9-dev ] || kept+=("$package"); done
  packages=("${kept[@]}")
fi

# Fails, beyond printing the others, when it does not know one of them.
known=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qxF "installed $package" <<<"$known" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

as_root=(env DEBIAN_FRONTEND=noninteractive)
if [ "$(id -u)" -ne 0 ]; then
  # -n: a password prompt would be a question.
  if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null; then
    say "packages are missing, and installing them needs root or sudo without a password. As root, run:"
    say "  apt-get install --no-install-recommends ${missing[*]}"
    exit 1
  fi
  as_root=(sudo -n "${as_root[@]}")
fi

apt() { "${as_root[@]}" apt-get -y -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" </dev/null >&2; }
install() { apt install --no-install-recommends "${missing[@]}"; }

say "installing ${missing[*]}"
# Slim images lack this folder, and Java (which libvtk9-dev pulls in) fails without it.
"${as_root[@]}" mkdir -p /usr/share/man/man1
updated=no
# On a fresh machine apt knows no packages yet.
if ! apt-cache show "${missing[@]}" >/dev/null 2>&1; then
  apt update
  updated=yes
fi
if ! install; then
  # The lists may be older than the archive.
  if [ $updated = no ] && apt update && install; then exit 0; fi
  say "apt could not install ${missing[*]}; its messages are above"
  exit 1
fi

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Succeeds, and prints what was found, where this machine has an NVIDIA device.
set -euo pipefail

# Of the driver, of the driver in Windows' Linux, and asked of the driver itself.
if compgen -G '/dev/nvidia[0-9]*' || compgen -G /dev/dxg; then exit 0; fi
command -v nvidia-smi >/dev/null && nvidia-smi -L 2>/dev/null | grep '^GPU'

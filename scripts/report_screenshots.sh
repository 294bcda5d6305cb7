#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of a page of `gyrosim report --out` as readers see it, made with a headless Chromium: on a desktop, light and
# dark, on a phone, and as printed. Fails if one is blank, if the browser reported an error, or if the view in three
# dimensions did not start. Exit code 77 without Chromium (apt-get install --no-install-recommends chromium).
#   scripts/report_screenshots.sh PAGE.html DIRECTORY
#   scripts/report_screenshots.sh --test GYROSIM      runs the quickstart for 40 ms first
set -euo pipefail

fail() { echo "$1" >&2; exit "${2:-2}"; }

[ $# -eq 2 ] || fail "usage: $0 PAGE.html DIRECTORY, or $0 --test GYROSIM"
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || fail "Chromium is missing; install the package chromium" 77
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

page=$1 out=$2
if [ "$1" = --test ]; then
  gyrosim=$2 out=$work/pictures page=$work/page.html
  XDG_CACHE_HOME=$work/cache "$gyrosim" run "$root/cases/quickstart.yaml" --until '40 ms' --quiet --out "$work/run" \
    --set 'output.liners={interval: 10 ms, wear_coefficient: 1e-12}'
  "$gyrosim" report "$work/run" --out "$page"
fi
[ -f "$page" ] || fail "$page does not exist; write it with gyrosim report RUNDIR --out $page"
mkdir -p "$out"
url=file://$(realpath "$page")

# Software rendering, so that WebGL works without a GPU. No sandbox: it is refused to root, and the page is our own.
flags=(--headless=new --no-sandbox --user-data-dir="$work/profile" --hide-scrollbars --no-first-run --disable-extensions
       --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --enable-logging=stderr
       --virtual-time-budget=8000)

browse() {  # NAME OPTION...: calls the browser; its messages go to $work/NAME.log
  timeout --kill-after=5 120 "$browser" "${flags[@]}" "${@:2}" "$url" >"$work/$1.out" 2>"$work/$1.log" ||
    fail "Chromium failed on $1: $(tail -3 "$work/$1.log")" 1
  if grep -E 'CONSOLE.*(Error|error|WebGL)' "$work/$1.log"; then fail "the browser reported an error on $1" 1; fi
}

# A blank picture has hardly any different rows of pixels.
require_picture() {
  /usr/bin/python3 - "$1" <<'PYTHON' || fail "$1 is blank" 1
import struct, sys, zlib
data = open(sys.argv[1], "rb").read()
at, packed, channels = 8, b"", {0: 1, 2: 3, 3: 1, 6: 4}
while at < len(data):
    length, kind = struct.unpack(">I4s", data[at:at + 8])
    if kind == b"IHDR":
        width, height, _, colour = struct.unpack(">IIBB", data[at + 8:at + 18])
    if kind == b"IDAT":
        packed += data[at + 8:at + 8 + length]
    at += 12 + length
rows, step = zlib.decompress(packed), 1 + width * channels[colour]
different = len({rows[k:k + step] for k in range(0, len(rows), step)})
print(f"{sys.argv[1]}: {width} x {height}, {different} different rows")
sys.exit(different < 300)
PYTHON
}

browse desktop --window-size=1280,7600 --screenshot="$out/desktop.png"
browse dark --window-size=1280,7600 --blink-settings=preferredColorScheme=0 --screenshot="$out/dark.png"
browse phone --window-size=390,6000 --screenshot="$out/phone.png"
for name in desktop dark phone; do require_picture "$out/$name.png"; done
browse print --no-pdf-header-footer --print-to-pdf="$out/print.pdf"
[ "$(stat -c %s "$out/print.pdf")" -gt 20000 ] || fail "$out/print.pdf is blank" 1
echo "$out/print.pdf: $(stat -c %s "$out/print.pdf") bytes"
browse dom --window-size=1280,900 --dump-dom
if grep -q 'class="view3d' "$work/dom.out"; then
  grep -q 'class="view3d running"' "$work/dom.out" || fail "the view in three dimensions did not start" 1
fi

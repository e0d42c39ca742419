#!/usr/bin/env bash
# make.sh TAMIS START.ply END.ply: makes the pages and pictures of docs/looking.md. The frames are those of cloth-ball
# (Sample-Scalable-CCD-Data, Apache-2.0). Needs the packages of scripts/setup.sh --tests.
set -euo pipefail
tamis=$(realpath "$1") start=$(realpath "$2") end=$(realpath "$3")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
shoot() { node ../../tools/viewer/shoot.mjs "$@"; }

"$tamis" scene cloth-ball --triangles 6000 --frames 60 --out "$work/ball"
"$tamis" view "$work/ball/frame_005?.ply" --scale 10 --out cloth-ball.html
"$tamis" scene bunny --triangles 3000 --frames 20 --out "$work/bunny"
"$tamis" view "$work/bunny/frame_0018.ply" "$work/bunny/frame_0019.ply" --scale 10 --out bunny.html

"$tamis" view "$start" "$end" --out "$work/step.html"
shoot "$work/step.html" overview.png 1280x720 dark
shoot "$work/step.html" sieve.png 1280x720 light v
shoot cloth-ball.html pair.png 1280x720 dark s

# The example of docs/audit.md, run with the module for Python, makes audit.html.
python=${PYTHON:-python3}
sed -n '/^```python$/,/^```$/p' ../audit.md | sed '/^```/d' >"$work/audit.py"
echo 'report.save("audit.html")' >>"$work/audit.py"
"$python" "$work/audit.py" >"$work/answer.txt"
shoot audit.html audit.png 1280x720 dark

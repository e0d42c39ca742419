#!/usr/bin/env bash
# make.sh TAMIS START.ply END.ply OUT.png: makes the README's picture from the contacts of a step. Needs POV-Ray and NumPy
# (Debian: povray, python3-numpy).
set -euo pipefail
folder=$(dirname "$0")
contacts=$(mktemp --suffix=.csv)
trap 'rm -f "$contacts"' EXIT
"$1" contacts "$2" "$3" --out "$contacts"
/usr/bin/python3 "$folder/render.py" "$2" "$contacts" "$4" --pitch 24 --yaw 35 --size 1600x860

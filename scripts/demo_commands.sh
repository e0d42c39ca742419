#!/usr/bin/env bash
# demo_commands.sh TAMIS FOLDER: runs and prints the commands of the demo: a scene, questions and a page, in FOLDER.
set -euo pipefail
tamis=$1
frames=$2

rm -rf "$frames"
show() { printf '\n$ %s\n' "$*"; "$@"; }

show "$tamis" scene cloth-ball --triangles 6000 --frames 60 --out "$frames"
# Exit code 1: there are contacts.
show "$tamis" sequence "$frames/frame_005?.ply" --scale 10 || [[ $? == 1 ]]
show "$tamis" contacts "$frames/frame_0055.ply" "$frames/frame_0056.ply" --scale 10 --out "$frames/contacts.csv"
show head -n 3 "$frames/contacts.csv"
show "$tamis" view "$frames/frame_005?.ply" --scale 10 --out "$frames/demo.html"
printf '\nOpen this in any browser: %s\n' "$(realpath "$frames")/demo.html"

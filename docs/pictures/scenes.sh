#!/usr/bin/env bash
# scenes.sh FOLDER: makes the pictures of docs/scenes.md. FOLDER has the frames of airbag, cloth-ball, funnel, funnel-92k and
# bunny, each in a folder of its own. Needs POV-Ray, NumPy and ImageMagick (Debian: povray, python3-numpy, imagemagick).
set -euo pipefail
frames=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# strip NAME "FRAME ..." CAMERA...: draws the frames side by side into scene-NAME.png
strip() {
  local name=$1 number pictures=()
  local numbers=$2
  shift 2
  for number in $numbers; do
    pictures+=("$work/$name-$number.png")
    /usr/bin/python3 "$here/render_scene.py" "$frames/$name/frame_$number.ply" "${pictures[-1]}" --size 420 360 "$@"
  done
  montage "${pictures[@]}" -tile x1 -geometry +2+2 -define png:compression-level=9 "$here/scene-$name.png"
}

strip airbag "0000 0014 0030 0080" --from 0.8 -0.95 0.62 --at 0 0 0.12 --angle 30
strip cloth-ball "0008 0025 0045 0094" --from 3.3 -4.2 2.8 --at 0 0 0.35 --angle 32
for funnel in funnel funnel-92k; do
  strip $funnel "0020 0045 0062 0080" --from 2.6 -3.0 1.7 --at 0 0 -0.35 --angle 29 --clear 2
done
strip bunny "0000 0045 0070 0090" --from 0.3 -0.62 0.26 --at -0.01 0 0.085 --angle 30 --clear 1

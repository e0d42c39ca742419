#!/bin/sh
# bullet.sh BIN: makes docs/hosts/bullet-*.png, each the end of one step, of Bullet as it is (alone) and with Tamis.
# Features that touch in the step glow. BIN: the folder with `tamis` and `tamis-bullet`.
set -eu
bin=$1
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

shoot() { # FOLDER/NAME FRAME PICTURE
  "$bin/tamis" view "$1_$(printf %04d "$2").ply" "$1_$(printf %04d $(($2 + 1))).ply" --out "$work/step.html" > /dev/null
  node "$here/../../tools/viewer/shoot.mjs" "$work/step.html#t=1" "$here/bullet-$3.png" 960x600 light h k
}

"$bin/tamis-bullet" --throws 1 --out "$work/throws" > /dev/null
"$bin/tamis-bullet" --pile 20 --steps 60 --out "$work/pile" > /dev/null
"$bin/tamis-bullet" --cloth 31 --steps 91 --out "$work/cloth" > /dev/null
plates="$work/throws/Spinning plates"
shoot "$plates/Bullet, hull with CCD" 1 throw-alone
shoot "$plates/clamped, hull" 1 throw
shoot "$work/pile/bullet" 58 pile-alone
shoot "$work/pile/clamped" 58 pile
shoot "$work/cloth/bullet" 90 cloth-alone
shoot "$work/cloth/truncated" 90 cloth

#!/bin/sh
# bullet.sh BIN: makes docs/hosts/bullet-*.png, each the start of one step, of Bullet as it is (alone) and with Tamis.
# Features that touch in the step glow. BIN: the folder with `tamis` and `tamis-bullet`.
set -eu
bin=$1
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

shoot() { # FOLDER/NAME FRAME FROM PICTURE
  "$bin/tamis" view "$1_$(printf %04d "$2").ply" "$1_$(printf %04d $(($2 + 1))).ply" --from="$3" --size 480,360 \
    --out "$here/bullet-$4.png" > /dev/null
}

"$bin/tamis-bullet" --throws 1 --out "$work/throws" > /dev/null
"$bin/tamis-bullet" --pile 20 --steps 60 --out "$work/pile" > /dev/null
"$bin/tamis-bullet" --cloth 31 --steps 91 --out "$work/cloth" > /dev/null
plates="$work/throws/Spinning plates"
shoot "$plates/Bullet, hull with CCD" 1 1,0.05,-0.08 throw-alone
shoot "$plates/clamped, hull" 1 1,0.05,-0.08 throw
shoot "$work/pile/bullet" 58 1,0.05,0.6 pile-alone
shoot "$work/pile/clamped" 58 1,0.05,0.6 pile
shoot "$work/cloth/bullet" 90 0,-1,0.7 cloth-alone
shoot "$work/cloth/truncated" 90 0,-1,0.7 cloth

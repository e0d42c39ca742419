#!/usr/bin/env bash
# benchmarks/peers/run.sh BUILD FRAMES OUT.csv: measures Tamis on the steps of peers.csv. FRAMES: the folder with cloth-ball,
# cloth-funnel and kick. benchmarks/peers/plot.py then compares both.
set -euo pipefail
build=$1 frames=$2 out=$3

echo "question,scene,who,ms,note" >"$out"
time_step() {  # SCENE START END
  "$build/bin/tamis" bench "$2" "$3" --question contacts,earliest --repeat 15 --json | python3 -c '
import json, sys
words = {"contacts": "all contacts", "earliest": "first contact"}
for row in json.load(sys.stdin)["rows"]:
    print(words[row["question"]], sys.argv[1], "Tamis", round(1e3 * row["seconds"], 2), "exact", sep=",")' "$1" >>"$out"
}
time_step cloth-funnel "$frames"/cloth-funnel/{227,228}.ply
time_step cloth-ball "$frames"/cloth-ball/cloth_ball{92,93}.ply
time_step "kick 62-63" "$frames"/kick/frame_{62,63}.ply
time_step "kick 64-65" "$frames"/kick/frame_{64,65}.ply

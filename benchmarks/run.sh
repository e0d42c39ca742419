#!/usr/bin/env bash
# benchmarks/run.sh BUILD FRAMES OUT: takes the measurements of docs/performance.md, as benchmarks/run.sh build ../shared/data/frames
# out/bench. SIZES may list numbers of triangles. Each size has a process of its own, so that its peak memory is measured.
set -euo pipefail
build=${1:?folder of the build} frames=${2:?folder with cloth-ball and cloth-funnel} out=${3:?folder for the results}
read -ra sizes <<<"${SIZES:-10000 30000 100000 300000 1000000 2000000 4000000}"
mkdir -p "$out"
ball=("$frames/cloth-ball/cloth_ball92.ply" "$frames/cloth-ball/cloth_ball93.ply")
funnel=("$frames/cloth-funnel/227.ply" "$frames/cloth-funnel/228.ply")
bench() { "$build/bin/tamis" bench "$@"; }

bench "${ball[@]}" --threads 1,2 --repeat 11 --out "$out/ball.csv"
bench "${funnel[@]}" --threads 1,2 --repeat 51 --cold 11 --out "$out/funnel.csv"
bench "${ball[@]}" --question contacts --isa best,avx2,baseline --repeat 7 --out "$out/isa.csv"
bench "${ball[@]}" --question contacts,earliest --scale 1,2,3,4,5,6,7,8,9,10 --cold 1 --repeat 3 --out "$out/step.csv"
for scene in folded-cloth colliding-bodies; do
  for size in "${sizes[@]}"; do
    bench --scene "$scene" --triangles "$size" --question contacts --cold 1 --repeat 3 --out "$out/size-$scene-$size.csv"
  done
done
"$build/bin/tamis_contenders" "${funnel[@]}" --threads 1,2 --repeat 9 --json >"$out/contenders-funnel.json"
"$build/bin/tamis_contenders" "${ball[@]}" --threads 1,2 --repeat 3 --json >"$out/contenders-ball.json"

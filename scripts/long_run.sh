#!/usr/bin/env bash
# long_run.sh [--build FOLDER] [--seed S] [ORACLE_PAIRS [EXACT_PAIRS]]: makes the long differential runs of docs/reliability.md,
# by default 10^7 pairs against the oracle and 10^8 against the exact decision; half of each are decided one by one, half
# many in a mesh. Four processes run with a lower priority. Their counts so far are in FOLDER/long_run/*.txt, the pairs of
# broken promises in *.err. Exit code 1 if there are any. FOLDER (default: build/dev) must have been built.
set -euo pipefail
cd "$(dirname "$0")/.."

build=build/dev seed=$(date +%s)
while [[ ${1-} == --* ]]; do
  case $1 in
    --build) build=$2; shift 2 ;;
    --seed) seed=$2; shift 2 ;;
    *) echo "long_run.sh: no option is called $1: use --build or --seed" >&2; exit 2 ;;
  esac
done
declare -A pairs=([oracle]=${1:-10000000} [exact]=${2:-100000000})

program=$build/tests/longrun/tamis_longrun
[[ -x $program ]] || { echo "long_run.sh: there is no $program: build it first" >&2; exit 2; }
out=$build/long_run
mkdir -p "$out"
echo "seed $seed; see $out"
runs=()
for judge in oracle exact; do
  for path in pair lanes; do
    nice -n 10 "$program" $path $judge $((pairs[$judge] / 2)) --seed "$seed" \
      >"$out/$path-$judge.txt" 2>"$out/$path-$judge.err" &
    runs+=($!)
    seed=$((seed + 1))  # so that each run has other pairs
  done
done
failed=0
for run in "${runs[@]}"; do wait "$run" || failed=1; done
tail -n 1 "$out"/*.txt
exit $failed

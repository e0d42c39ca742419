#!/usr/bin/env bash
# run.sh BUILD OUT.csv [LARGEST]: counts for 1 to 64 ranks of 10^4 triangles and of 10^5, to 4 of 10^6 (or as many as LARGEST).
# Ranks may be many more than cores: what is counted does not depend on that.
set -euo pipefail
program=$1/bin/tamis_distributed out=$2 largest=${3:-4}

ask() {  # triangles a rank, ranks...
  local triangles=$1 ranks
  for ranks in "${@:2}"; do
    mpirun --allow-run-as-root --oversubscribe --mca mpi_yield_when_idle 1 -n "$ranks" "$program" "$triangles" |
      if [[ -s $out ]]; then tail -n +2; else cat; fi >>"$out"
  done
}

: >"$out"
ask 10000 1 2 4 8 16 32 64
ask 100000 1 2 4 8 16 32 64
ask 1000000 1 2 "$largest"

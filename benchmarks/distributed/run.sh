#!/usr/bin/env bash
# run.sh BUILD OUT.csv [LARGEST]: writes counts for 1 to 64 ranks with 10^4 and with 10^5 triangles each, and for 1, 2 and
# LARGEST ranks (default: 4) with 10^6. There may be more ranks than cores: the counts do not depend on that.
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

#!/usr/bin/env bash
# no_memory.sh COMMAND...: runs COMMAND (no_memory under mpirun) from place 0 on. If memory that fails at a place ends all
# ranks, it runs COMMAND again from behind that place.
set -euo pipefail
readonly kEnded=12 # the exit code given to MPI_Abort
next=0 agreed=0 ended=0
while true; do
  code=0
  said=$(timeout 60 "$@" "$next" 2>&1) || code=$?
  places=$(grep -c '^place' <<<"$said" || true)
  if ((code == 0)); then
    echo "no_memory: agreed upon at $((agreed + places - 1)) places, all ranks ended at $ended"
    exit 0
  fi
  if ((code != kEnded)); then
    echo "$said" >&2
    echo "no_memory: exit code $code (124: the others waited for ever)" >&2
    exit 1
  fi
  last=$(sed -n 's/^place //p' <<<"$said" | tail -n 1)
  agreed=$((agreed + places - 1)) ended=$((ended + 1)) next=$((last + 1 + last / 12))
done

#!/usr/bin/env bash
# time.sh BUILD OUT.csv [TRIANGLES]: measures the milliseconds of questions with 1 and 2 threads and with 1 and 2 ranks, in
# turns, five times each, and prints medians. BEFORE is put before mpirun: BEFORE='chrt -f 50' if others use the machine.
set -euo pipefail
program=$1/bin/tamis_ranks_time out=$2 triangles=${3:-200000}

ask() {  # RANKS [ARGUMENTS of the program]
  ${BEFORE:-} mpirun --allow-run-as-root --bind-to none --mca mpi_yield_when_idle 1 -n "$1" "$program" "$triangles" "${@:2}" >>"$out"
}

echo "question,who,count,triangles,ms" >"$out"
for _ in 1 2 3 4 5; do
  ask 1 1
  ask 1 2
  ask 1
  ask 2
done
uptime
for question in contacts earliest safe_step; do
  for who in threads,1 threads,2 ranks,1 ranks,2; do
    grep "^$question,$who," "$out" | cut -d, -f5 | sort -n | sed -n 3p | sed "s/^/$question $who: /"
  done
done

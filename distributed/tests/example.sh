#!/usr/bin/env bash
# example.sh EXAMPLE MPIRUN...: the example prints the same on 1 and on 3 ranks, and finds contacts.
set -euo pipefail
example=$1
shift
one=$("$@" -n 1 "$example") three=$("$@" -n 3 "$example")
[[ $one =~ ^[1-9][0-9]*\ contacts ]] || { echo "no contacts: $one"; exit 1; }
[[ $one == "$three" ]] || { echo "on one rank: $one"; echo "on three:    $three"; exit 1; }

#!/usr/bin/env bash
# hostile.sh SECONDS: attacks the built command for SECONDS, with new cases in each round: every verb and option, streams,
# names, files, outputs, signals, limits of the system.
#   --build FOLDER   the command's build (default: build/dev)
# Further arguments go to tools/command/tests/hostile/hostile.py: `--seed S --only FAMILY:NUMBER` repeats a case that it named. Exit code
# 1 if a promise of docs/reliability.md was broken.
set -euo pipefail
cd "$(dirname "$0")/.."

build=build/dev
seconds=${1:?give the seconds}
shift
if [[ ${1-} == --build ]]; then build=$2; shift 2; fi
[[ -x $build/bin/tamis ]] || { echo "hostile.sh: there is no $build/bin/tamis: build it first, as by cmake --preset dev && cmake --build --preset dev --target tamis_command" >&2; exit 2; }
exec nice -n 10 python3 tools/command/tests/hostile/hostile.py --tamis "$build/bin/tamis" --seconds "$seconds" "$@"

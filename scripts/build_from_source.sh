#!/usr/bin/env bash
# build_from_source.sh: as root on a Debian that has nothing yet (scripts/try_in_root.sh), installs what tests/consumer/from_source needs,
# builds it, with the library, and says how long that took.
set -euo pipefail
cd "$(dirname "$0")/.."

apt-get update -q
DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends g++ cmake make libxsimd-dev libboost-dev
time {
  cmake -S tests/consumer/from_source -B build/from_source
  cmake --build build/from_source --parallel "$(nproc)"
}
build/from_source/simulator | diff examples/output/hello.cpp.txt -

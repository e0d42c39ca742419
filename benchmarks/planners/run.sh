#!/bin/sh
# run.sh [EDGES [TRIANGLES [THREADS]]]: a planner's edges, proven by Tamis and sampled by coal, which pip installs into
# build/coal. Prints the figures of docs/worlds.md, "Edges between configurations". Needs Eigen (libeigen3-dev).
set -e
cd "$(dirname "$0")/../.."
packages=build/coal
[ -d $packages ] || python3 -m venv $packages
$packages/bin/pip install -q coal==3.0.3
coal=$($packages/bin/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/cmeel.prefix
cmake --preset dev -D TAMIS_COAL="$coal" >build/coal/configured.txt
ninja -C build/dev tamis_planners >build/coal/built.txt
build/dev/bin/tamis_planners "$@"

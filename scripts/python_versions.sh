#!/usr/bin/env bash
# python_versions.sh BUILD PYTHON...: builds and tests the module with other Pythons than the system's, oldest first. BUILD
# is the folder in which Tamis was built. Each PYTHON gets an environment in BUILD/python-versions, with packages of PyPI.
# The first Python that has the stable ABI builds a wheel for it; later ones install that same file.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "$1")
shift
folder=$build/python-versions
stable=
for python in "$@"; do
  version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  work=$folder/$version
  rm -rf "$work"
  "$python" -m venv "$work"
  quietly=("$work/bin/pip" --quiet --disable-pip-version-check)
  "${quietly[@]}" install numpy pytest hypothesis pandas matplotlib scikit-build-core nanobind nanobind-backend
  wheel=$stable
  if [[ -z $wheel ]]; then
    "${quietly[@]}" wheel . --no-build-isolation --no-deps --wheel-dir "$work" --config-settings="cmake.define.TAMIS_BUILT=$build"
    wheel=$(echo "$work"/*.whl)
    [[ $wheel != *-abi3-* ]] || stable=$wheel
  fi
  echo "Python $version: ${wheel##*/}"
  "${quietly[@]}" install --no-deps "$wheel"
  env --unset=PYTHONPATH MPLBACKEND=Agg TAMIS_COMMAND="$build/bin/tamis" "$work/bin/pytest"
done

#!/usr/bin/env bash
# Builds and tests the module with other Pythons than the system's: python_versions.sh BUILD PYTHON..., oldest first. BUILD is
# where Tamis was built; each PYTHON gets an environment in BUILD/python-versions, with what PyPI has for it. The first one
# that can makes the wheel for the stable ABI; later ones get that very file.
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
  # Newer pyparsing warns of what the last matplotlib for Python 3.9 does, and warnings are errors here.
  "${quietly[@]}" install numpy pytest hypothesis pandas matplotlib 'pyparsing<3.3' scikit-build-core nanobind
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

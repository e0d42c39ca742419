#!/usr/bin/env bash
# python_versions.sh WHEEL PYTHON...: tests one wheel with several Pythons. Each gets a new environment in build/python-versions, in
# which pip installs the wheel and what it needs. The README's example and the command run there, then the module's tests.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1")
shift
for python in "$@"; do
  version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  work=$PWD/build/python-versions/$version
  echo "Python $version: ${wheel##*/}"
  rm -rf "$work"
  "$python" -m venv "$work"
  pip=("$work/bin/pip" --quiet --disable-pip-version-check install)
  "${pip[@]}" "$wheel"
  "$work/bin/python" examples/hello.py | diff - examples/output/hello.py.txt
  "$work/bin/tamis" --help >/dev/null
  "${pip[@]}" pytest hypothesis pandas matplotlib
  command=$("$work/bin/python" -c 'import tamis, pathlib; print(pathlib.Path(tamis.__file__).with_name("command") / "bin/tamis")')
  env --unset=PYTHONPATH MPLBACKEND=Agg TAMIS_COMMAND="$command" "$work/bin/python" -m pytest
done

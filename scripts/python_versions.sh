#!/usr/bin/env bash
# python_versions.sh WHEEL PYTHON...: tests one wheel with several Pythons. Each gets a new environment in build/python-versions, in
# which pip installs the wheel and what it needs. The README's example and the command run there, then the module's tests. bits.txt
# there is what scripts/wheel_bits.py prints. EMULATOR runs programs of another processor, if Python is for one.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1")
shift
for python in "$@"; do
  version=$("$python" -c 'import platform, sys; print("%d.%d-%s" % (*sys.version_info[:2], platform.machine()))')
  work=$PWD/build/python-versions/$version
  echo "Python $version: ${wheel##*/}"
  rm -rf "$work"
  "$python" -m venv "$work"
  pip=("$work/bin/pip" --quiet --disable-pip-version-check install)
  "${pip[@]}" "$wheel"
  command=$("$work/bin/python" -c 'import tamis, pathlib; print(pathlib.Path(tamis.__file__).with_name("command") / "bin/tamis")')
  if [[ -n ${EMULATOR:-} ]]; then
    mv "$command" "$command.emulated"
    printf '#!/bin/sh\nexec %s "%s" "$@"\n' "$EMULATOR" "$command.emulated" >"$command"
    chmod +x "$command"
  fi
  "$work/bin/python" examples/hello.py | diff - examples/output/hello.py.txt
  "$work/bin/tamis" --version
  "$work/bin/python" scripts/wheel_bits.py | tee "$work/bits.txt"
  "${pip[@]}" pytest hypothesis pandas matplotlib
  env --unset=PYTHONPATH MPLBACKEND=Agg TAMIS_COMMAND="$command" "$work/bin/python" -m pytest
done

#!/usr/bin/env bash
# test_windows_wheel.sh WHEEL [LINUX_PYTHON]: tests the wheel for Windows with CPython 3.12 under Wine, where pip installs it: the README's
# example, an example, the command, the module's tests, and what an older Python says. With a Python of this machine that has
# Tamis, too: wheel_bits.py prints the same in both. Makes build/windows-wheel. Exit code 77 if Wine, Python for Windows
# (scripts/windows_python.sh says from where it comes) or PyPI cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1")
here=${2:-}
work=$PWD/build/windows-wheel python=$PWD/build/windows-wheel/python
export WINEDEBUG=-all WINEPREFIX=$work/wine MPLBACKEND=Agg
unset PIP_CERT PYTHONPATH  # of this machine

# Python under Wine 8 cannot write to files, only to pipes.
windows() { wine "$@" </dev/null 2>&1 | tr -d '\r'; }

# says SENTENCE COMMAND...: the command fails, and prints the sentence.
says() {
  local output
  if output=$("${@:2}"); then echo "test_windows_wheel.sh: this works: ${*:2}" >&2; exit 1; fi
  grep -qF "$1" <<<"$output" || { printf 'test_windows_wheel.sh: no "%s" in:\n%s\n' "$1" "$output" >&2; exit 1; }
  echo "says: $1"
}

scripts/setup.sh --windows || { echo "skipped: Debian's compiler for Windows, or Wine, cannot be had"; exit 77; }
rm -rf "$work"
scripts/windows_python.sh "$python" || exit $?
rm "$python/lib/_wmi.pyd"  # asks for a function that Wine 8 does not have; Python works without
windows wineboot --init >/dev/null
windows "$python/python.exe" -m ensurepip >/dev/null
pip=("$python/python.exe" -m pip --quiet --disable-pip-version-check install --no-warn-script-location)
# NumPy 2 needs a function of complex numbers (crealf) that Wine 8 does not have.
windows "${pip[@]}" 'numpy<2' || { echo "skipped: PyPI cannot be reached from Wine"; exit 77; }
windows "${pip[@]}" "$wheel"

windows "$python/python.exe" examples/hello.py | diff - examples/output/hello.py.txt
windows "$python/Scripts/tamis.exe" --version
if [[ -n $here ]]; then diff <("$here" scripts/wheel_bits.py) <(windows "$python/python.exe" scripts/wheel_bits.py); fi
says "InvalidMesh: face 0 names vertex -2" windows "$python/python.exe" -c "import tamis; tamis.Mesh([[0, 1, -2]])"
for old in 3.11 3.10; do
  says "is not a supported wheel on this platform" windows "${pip[@]}" --target "$work/old" --only-binary :all: --python-version $old "$wheel"
done
windows "${pip[@]}" pytest hypothesis 'pandas<3' 'matplotlib<3.11' 'contourpy<1.4' pygltflib usd-core
windows "$python/python.exe" -m tamis.examples.cloth --help
windows "$python/python.exe" -m pytest

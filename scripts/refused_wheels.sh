#!/usr/bin/env bash
# refused_wheels.sh WHEEL [OLD_PYTHON]: that an old pip, a missing backend, and a Python before 3.10 (if given) refuse a wheel with the
# sentences of docs/python.md. Exit code 77 if PyPI cannot be reached.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1")
old_python=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# says SENTENCE COMMAND...: the command fails, and prints the sentence.
says() {
  local output
  if output=$("${@:2}" 2>&1); then echo "refused_wheels.sh: this works: ${*:2}" >&2; exit 1; fi
  grep -qF "$1" <<<"$output" || { printf 'refused_wheels.sh: no "%s" in:\n%s\n' "$1" "$output" >&2; exit 1; }
  echo "says: $1"
}

python3 -m venv "$work/new"
pip=("$work/new/bin/pip" --disable-pip-version-check)
"${pip[@]}" --quiet install numpy || { echo "skipped: PyPI cannot be reached"; exit 77; }
"${pip[@]}" --quiet install --no-deps "$wheel"
says "Install it via 'pip install nanobind-backend'" "$work/new/bin/python" -c "import tamis"
"${pip[@]}" --quiet uninstall --yes tamis
"${pip[@]}" --quiet install pip==20.2.4
says "is not a supported wheel on this platform" "${pip[@]}" install "$wheel"
if [[ -n $old_python ]]; then
  "$old_python" -m venv "$work/old"
  says "is not a supported wheel on this platform" "$work/old/bin/pip" install "$wheel"
  python3 -m zipfile -e "$wheel" "$work/copied"
  says "tamis needs CPython 3.10 or newer with a GIL" env PYTHONPATH="$work/copied" "$work/old/bin/python" -c "import tamis"
fi

#!/usr/bin/env bash
# pinned.sh TOOL: prints the path of clang-format or clang-tidy, of the version in scripts/requirements-format.txt. They come from
# PyPI, into build/format-tools, so that the format does not depend on the system. Exit code 77, and why, if they cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$PWD/build/format-tools wanted=scripts/requirements-format.txt
mkdir -p build
exec 9>build/format-tools.lock
flock 9
if ! cmp -s "$wanted" "$folder/installed"; then
  { rm -rf "$folder" && python3 -m venv "$folder" && "$folder/bin/pip" --quiet --disable-pip-version-check install -r "$wanted" &&
    cp "$wanted" "$folder/installed"; } >&2 || { echo "skipped: no $1, as PyPI cannot be reached or python3 has no venv"; exit 77; }
fi
echo "$folder/bin/$1"

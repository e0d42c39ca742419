#!/usr/bin/env bash
# pinned.sh TOOL [FOLDER REQUIREMENTS]: prints the path of a tool from PyPI, in the version that REQUIREMENTS pins. It is installed
# into FOLDER, so it does not depend on the system. Without these: clang-format or clang-tidy, of scripts/requirements-format.txt.
# Exit code 77, and why, if the tool cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$PWD/${2:-build/format-tools} wanted=${3:-scripts/requirements-format.txt}
mkdir -p "$(dirname "$folder")"
exec 9>"$folder.lock"
flock 9
if ! cmp -s "$wanted" "$folder/installed"; then
  { rm -rf "$folder" && python3 -m venv "$folder" && "$folder/bin/pip" --quiet --disable-pip-version-check install -r "$wanted" &&
    cp "$wanted" "$folder/installed"; } >&2 || { echo "skipped: no $1, as PyPI cannot be reached or python3 has no venv"; exit 77; }
fi
echo "$folder/bin/$1"

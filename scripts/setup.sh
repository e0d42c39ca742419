#!/usr/bin/env bash
# setup.sh [OPTION]: installs the packages of Debian or Ubuntu that Tamis needs and that are missing. An option adds others:
#   --core-tests   those of scripts/test.sh
#   --all-tests    those of scripts/test.sh --all, and the viewer's tools
#   --python       those to build the module for Python
#   --compilers    the other compilers that the release has (scripts/check_compilers.sh)
#   --wheels       those of the wheels that are shipped (scripts/release_wheels.sh)
#   --blender      Blender, in which the add-on is tested (besides the module bpy)
#   --site         Doxygen and Python, which build the site (scripts/site.sh)
#   --arm64        those of the tests on 64-bit ARM
#   --windows      those of the tests on Windows
#   --wasm         those of the tests in WebAssembly; on Debian 13, as Debian 12's emscripten is too old
#   --packages     those of the Debian packages (scripts/build_debs.sh)
#   --bench        those of the benchmarks, and the libraries that Tamis is compared with
# Uses neither apt nor the network if nothing is missing. On other systems it prints what to install.
set -euo pipefail
cd "$(dirname "$0")/.."

# The release's own clang, as clang++; on Debian 12 the packages of version 14 alone do, too (scripts/clang.sh).
clang=(clang libclang-rt-dev)
release=$(. /etc/os-release 2>/dev/null && echo "${VERSION_CODENAME-}")
[[ $release != bookworm ]] || clang=(clang-14 libclang-rt-14-dev)
packages=(g++ cmake ninja-build pkg-config libtbb-dev libboost-dev libxsimd-dev
          libcli11-dev libfmt-dev nlohmann-json3-dev libeigen3-dev libmeshoptimizer-dev zlib1g-dev)
case ${1:-} in
  --core-tests) packages+=(libgtest-dev libgmp-dev python3 binutils git) ;;
  --all-tests)
    packages+=(libopenmpi-dev openmpi-bin libgtest-dev libgmp-dev libbenchmark-dev glmark2-data python3 python3-venv python3-dev
               libbullet-dev libompl-dev liburdfdom-dev libfast-float-dev binutils valgrind "${clang[@]}" git debootstrap chromium)
    # Node from elsewhere than Debian has an npm of its own, and conflicts with Debian's.
    command -v npm >/dev/null || packages+=(nodejs npm)
    ;;
  --python) packages+=(python3-venv python3-dev) ;;
  --wheels)
    packages+=(python3-venv python3-dev g++-aarch64-linux-gnu qemu-user g++-mingw-w64-x86-64-posix maven libfast-float-dev dpkg-dev)
    ;;
  --compilers)
    for version in g++-12 g++-14 clang-14 clang-19; do
      ! apt-cache show "$version" >/dev/null 2>&1 || packages+=("$version")
    done
    ;;
  --blender) packages+=(blender python3-numpy) ;;
  --site) packages=(doxygen git python3 python3-venv) ;;
  --arm64) packages+=(g++-aarch64-linux-gnu qemu-user) ;;
  --windows) packages+=(g++-mingw-w64-x86-64-posix libz-mingw-w64-dev googletest wine64 wine) ;;
  --wasm)
    [[ $release != bookworm ]] || { echo "setup: Debian 12's emscripten is 3.1.6, and 3.1.50 is needed: use Debian 13" >&2; exit 1; }
    packages+=(emscripten nodejs libfast-float-dev googletest libgtest-dev python3)
    ;;
  --packages) packages+=(python3 dpkg-dev file lintian) ;;
  --bench) packages+=(libbenchmark-dev libembree-dev libcgal-dev libbullet-dev libfcl-dev python3-matplotlib) ;;
  "") ;;
  *) echo "setup: no option is called $1: use --core-tests, --all-tests, --python, --wheels, --compilers, --blender, --site, --arm64, --windows, --wasm, --packages or --bench" >&2; exit 2 ;;
esac

is_installed() { [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

if ! command -v dpkg-query >/dev/null; then
  cat scripts/packages_elsewhere.txt
  exit 0  # the build says what it does not find
fi
missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "setup: all ${#packages[@]} packages are installed"
else
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  echo "setup: installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
fi

# The viewer's tools, in exactly the versions of its lock file.
if [[ ${1:-} == --all-tests && ! tools/viewer/node_modules/.package-lock.json -nt tools/viewer/package-lock.json ]]; then
  echo "setup: installing the viewer's tools into tools/viewer/node_modules"
  npm ci --prefix tools/viewer --ignore-scripts --no-audit --no-fund
  touch "tools/viewer/node_modules/.package-lock.json"
fi

#!/usr/bin/env bash
# try_in_root.sh [--data] [--keep] RELEASE COMMAND...: runs COMMAND in a clone of HEAD, in a new root of a release of Debian (bookworm or trixie), with
# an empty environment, as on a machine that was set up just now. Needs root, debootstrap, and some gigabytes in build/roots, where
# the bare root stays for the next time. Packages come from this machine's own source. The exit code is COMMAND's; 77 if there can
# be no such root.
#   --data   the recorded data (TAMIS_DATA, or ../shared/data) is there, too
#   --keep   leaves the root in build/roots/RELEASE, to look into
set -euo pipefail
cd "$(dirname "$0")/.."

keep= data=
while [[ ${1:-} == --* ]]; do
  case $1 in
    --data) data=${TAMIS_DATA:-$PWD/../shared/data} ;;
    --keep) keep=yes ;;
    *) echo "try_in_root.sh: no option is called $1: use --data or --keep" >&2; exit 2 ;;
  esac
  shift
done
release=${1:?say which release, bookworm or trixie}
shift
(($#)) || { echo "try_in_root.sh: give the command, too, as scripts/demo.sh" >&2; exit 2; }
skip() { echo "skipped: $1"; exit 77; }
((EUID == 0)) || skip "a root for $release can be made by root alone"
command -v debootstrap >/dev/null || skip "no debootstrap"
unshare --mount --pid --fork true 2>/dev/null || skip "this machine allows no mounts"

# Debian's archive, as this machine's apt has it.
source_of_packages() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | grep -v '^#' |
    grep -oE '[a-z+]+://[^] ]+/debian/?( |$)' | head -n 1 || true
}

roots=$PWD/build/roots
root=$roots/$release
mkdir -p "$roots"
remove() { rm -rf --one-file-system "$1"; }
if [[ ! -e $root.tar ]]; then
  echo "try_in_root: making a root of $release"
  remove "$root.new"
  mirror=$(source_of_packages)
  [[ -n $mirror ]] || skip "apt has no source of Debian's packages"
  debootstrap --variant=minbase --include=ca-certificates "$release" "$root.new" "$mirror" \
    >"$root.log" 2>&1 || { tail -n 5 "$root.log"; skip "debootstrap made no root of $release"; }
  tar -C "$root.new" -cf "$root.tar.new" .
  mv "$root.tar.new" "$root.tar"
  remove "$root.new"
fi
remove "$root"
[[ -n $keep ]] || trap 'remove "$root"' EXIT
mkdir "$root"
tar -C "$root" -xf "$root.tar"

# What this machine needs to reach the archive and PyPI: names, certificates, proxies.
copy() { [[ ! -e $1 ]] || cp -rL "$1" "$root$(dirname "$1")"; }
copy /etc/resolv.conf
copy /etc/hosts
copy /etc/pip.conf
copy /usr/local/share/ca-certificates
copy /etc/ssl/certs/ca-certificates.crt
apt-config dump | grep -E '^Acquire::(https?::|Check-)' >"$root/etc/apt/apt.conf.d/90machine" || true

git clone --quiet "$PWD" "$root/root/tamis"
mkdir -p "$root/root/shared/data"
echo "try_in_root: $release: $*"
# The mounts, and whatever still runs, end with these namespaces.
unshare --mount --pid --fork --kill-child bash -c '
  mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && { [[ ! -d $1 ]] || mount --rbind "$1" "$0/root/shared/data"; } &&
  shift && exec env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$0" sh -c '\''cd /root/tamis && exec "$@"'\'' sh "$@"' \
  "$root" "$data" "$@"

#!/usr/bin/env bash
# windows_python.sh FOLDER [VERSION]: puts CPython 3.12 (or 3.14) for 64-bit Windows into FOLDER: interpreter, headers, python3.lib.
# They come from org.bytedeco:cpython of Maven, with this SHA-256, by mvn. That package has no python3.dll, through which modules
# with the stable ABI call any Python 3; so one is made here, which forwards each name of python3.lib, as Python's own does.
# Exit code 77, and why, if the package cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(realpath -m "$1")
case ${2:-3.12} in
  3.12) version=3.12.1-1.5.10 sum=e69bc4491c311e19ea7169bafc5efbbe03b980d69c6962b049daf1fcb4913391 ;;
  3.14) version=3.14.3-1.5.13 sum=3291bf3d8f405335ac21dbe55780521fdfd295b0f9f43f7e6e8c55bedd709cb3 ;;
  *) echo "windows_python.sh: no package of Python $2 is known: use 3.12 or 3.14" >&2; exit 2 ;;
esac
[[ ! -e $folder/python3.dll ]] || exit 0
command -v mvn >/dev/null || { echo "skipped: no Python for Windows, as there is no mvn: apt install maven"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
jar=cpython-$version-windows-x86_64.jar
mvn --quiet --batch-mode dependency:copy -Dartifact="org.bytedeco:cpython:$version:jar:windows-x86_64" -DoutputDirectory="$folder" >/dev/null ||
  { echo "skipped: no Python for Windows, as Maven's org.bytedeco:cpython:$version cannot be had"; exit 77; }
sha256sum --quiet --check <<<"$sum  $folder/$jar"
python3 -m zipfile -e "$folder/$jar" "$folder"
mv "$folder"/org/bytedeco/cpython/windows-x86_64/* "$folder"
rm -r "${folder:?}"/{org,META-INF,"$jar"}

dll=$(basename "$folder"/python3??.dll .dll)
{ echo EXPORTS
  x86_64-w64-mingw32-nm "$folder/libs/python3.lib" 2>/dev/null |
    sed -n "s/.* I __imp_\(.*\)/\1 = $dll.\1/p"; } >"$folder/python3.def"
x86_64-w64-mingw32-gcc-posix -shared -nostdlib -Wl,--entry=0 -o "$folder/python3.dll" "$folder/python3.def"

#!/usr/bin/env python3
"""old_glibc.py FOLDER PROCESSOR: what Debian's g++ links against, so that programs run with glibc 2.28 and libstdc++ of GCC 8.

PROCESSOR is x86_64 or aarch64. Use the folder by the linker's options -B FOLDER -L FOLDER. It has zig's stubs of glibc 2.28, and
stubs of this machine's libstdc++ and libgcc_s without the newer symbols. Those come from libstdc++.a, as in manylinux's own
compilers. Symbols that stand in the stubs stay shared: nanobind's backend and the module must share C++'s runtime.
"""

import pathlib
import re
import subprocess
import sys

TARGET = "{}-linux-gnu.2.28"
# The newest versions that manylinux_2_28 allows (auditwheel's policy).
NEWEST = {"GLIBCXX": (3, 4, 24), "CXXABI": (1, 3, 11), "GCC": (7, 0, 0)}
# What libstdc++ and its headers call of newer glibc.
NEWER = """
#include <pthread.h>
#include <time.h>
#include <unistd.h>
__attribute__((visibility("hidden"))) char __libc_single_threaded = 0;
__attribute__((visibility("hidden"))) unsigned arc4random(void) {
  unsigned value;
  if (getentropy(&value, sizeof value) != 0) __builtin_abort();
  return value;
}
__attribute__((visibility("hidden"))) int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                                                                  const struct timespec* until) {
  struct timespec now, then;
  clock_gettime(clock, &now);
  clock_gettime(CLOCK_REALTIME, &then);
  const long nanoseconds = then.tv_nsec + until->tv_nsec - now.tv_nsec;  /* -1e9 to 2e9 */
  const long carry = nanoseconds < 0 ? -1 : nanoseconds / 1000000000;
  then.tv_sec += until->tv_sec - now.tv_sec + carry;
  then.tv_nsec = nanoseconds - carry * 1000000000;
  return pthread_cond_timedwait(condition, mutex, &then);
}
"""


def run(*command) -> str:
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"old_glibc.py: failed: {command}\n{done.stdout}")
    return done.stdout


def glibc(folder: pathlib.Path, zig: "list[str]", target: str) -> None:
    """Copy the stubs that zig makes for a program."""
    (folder / "main.c").write_text("int main(void) { return 0; }\n")
    command = [*zig, "-v", "-fPIE", "-pie", "-target", target, folder / "main.c", "-o", folder / "main"]
    made = [pathlib.Path(word) for word in run(*command).split() if word.startswith("/") and "/ld-" not in word]
    kept = {path.name: path for path in made if re.search(r"crt1\.o$|\.so\.\d$|libc_nonshared\.a$", path.name)}
    for name, path in kept.items():
        (folder / name).write_bytes(path.read_bytes())
        link = folder / name.partition(".so.")[0]
        if ".so." in name and name != "libc.so.6":
            link.with_suffix(".so").unlink(missing_ok=True)
            link.with_suffix(".so").symlink_to(name)
    (folder / "libc.so").write_text(f"GROUP({folder}/libc.so.6 {folder}/libc_nonshared.a AS_NEEDED({folder}/libpthread.so.0 {folder}/libld.so.2))\n")


def stub(folder: pathlib.Path, compiler: str, name: str) -> None:
    """Make a library with the old symbols of the compiler's own."""
    real = run(compiler, f"-print-file-name={name}").strip()
    versions: "dict[str, list[str]]" = {}
    lines = [".data"]
    for row in run("readelf", "--dyn-syms", "-W", real).splitlines():
        found = re.match(r"\s*\d+: \w+\s+(\w+) (FUNC|OBJECT)\s+(\w+)\s+\w+\s+(?!UND)\w+ ([^@]+)@@((\w+?)_([\d.]+))$", row)
        if not found or tuple(map(int, found[7].split("."))) > NEWEST.get(found[6], (0,)):
            continue
        size, kind, binding, symbol, version = int(found[1], 0), found[2], found[3], found[4], found[5]
        versions.setdefault(version, []).append(f'"{symbol}"')
        lines += [f'.{"weak" if binding == "WEAK" else "globl"} "{symbol}"', f'.type "{symbol}",%{kind.lower().replace("func", "function")}']
        lines += [f'.size "{symbol}",{size}', f'"{symbol}":', f".zero {max(size, 1) if kind == 'OBJECT' else 0}"]
    (folder / "stub.s").write_text("\n".join(lines) + "\n")
    (folder / "stub.map").write_text("".join(f"{v} {{ global: {'; '.join(names)}; }};\n" for v, names in versions.items()))
    run(compiler, "-nostdlib", "-shared", f"-Wl,-soname,{name},--version-script={folder}/stub.map", folder / "stub.s",
        "-o", folder / name)


def main() -> int:
    folder, processor = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    folder.mkdir(parents=True, exist_ok=True)
    python = run("scripts/pinned.sh", "python", "zig").strip()
    zig, target = [python, "-m", "ziglang", "cc"], TARGET.format(processor)
    compiler = f"{processor}-linux-gnu-g++"
    glibc(folder, zig, target)
    stub(folder, compiler, "libstdc++.so.6")
    stub(folder, compiler, "libgcc_s.so.1")
    (folder / "newer.c").write_text(NEWER)
    run(*zig, "-O2", "-fPIC", "-target", target, "-c", folder / "newer.c", "-o", folder / "newer.o")
    archive = run(compiler, "-print-file-name=libstdc++.a").strip()
    (folder / "libstdc++.so").write_text(f"INPUT({folder}/libstdc++.so.6 {archive} {folder}/newer.o)\n")
    (folder / "libgcc_s.so").write_text(f"GROUP({folder}/libgcc_s.so.1 -lgcc)\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

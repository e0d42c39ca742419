#!/usr/bin/env python3
"""build_host.py WORK HOST [--newest]: an environment with the wheel that build_wheel.py made and a host, a program Tamis works in.

Makes WORK/HOST: an environment with the wheel, the packages of its extra of that name, and pytest. Versions are those of
bindings/python/requirements-hosts.txt. PyPI is asked only if these or the needs of the tests have changed; exit code 77 if it
cannot be reached. With --newest it makes WORK/HOST-newest, with the host's newest version on PyPI.
"""

import pathlib
import subprocess
import sys

import build_wheel as ordinary

REQUIREMENTS = ordinary.ROOT / "bindings" / "python" / "requirements-hosts.txt"
# Packages that only the tests need.
TESTS_NEED = {"newton": ["usd-core"], "blender": ["bpy"], "robots": ["example-robot-data", "yourdfpy"]}
# bpy needs an older NumPy than the one that bindings/python/requirements.txt pins.
UNPINNED = ("blender",)


def make_newest(work: pathlib.Path, host: str, wheel: pathlib.Path, names: "list[str]") -> int:
    """Install the newest version of a host that PyPI has, and print it."""
    python = ordinary.environment(work / f"{host}-newest")
    try:
        ordinary.pip(work, "--python", python, "install", "--no-compile", wheel, host, *names)
    except subprocess.CalledProcessError:
        print(f"skipped: the newest {host} cannot be had")
        return ordinary.SKIPPED
    print(ordinary.run(python, "-c", f"from importlib import metadata; print('{host}', metadata.version('{host}'))"), end="")
    return 0


def main() -> int:
    work, host = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    wheels = sorted((work / "dist").glob("*.whl"))
    if not wheels or not (work / "user").exists():
        print("skipped: build_wheel.py has made no wheel")
        return ordinary.SKIPPED
    names = ["pytest", "hypothesis", *TESTS_NEED.get(host, [])]
    if sys.argv[3:] == ["--newest"]:
        return make_newest(work, host, wheels[0], names)
    pinned = [] if host in UNPINNED else ["-c", ordinary.REQUIREMENTS]
    wanted = [f"{wheels[0]}[{host}]", *names, "-c", REQUIREMENTS, *pinned]
    pins = [
        *map(str.encode, names),
        REQUIREMENTS.read_bytes(),
        ordinary.REQUIREMENTS.read_bytes(),
        sys.version.encode(),
    ]
    given = ordinary.Stamp(work / f"{host}.wheels.stamp", *pins)
    if not given.is_fresh():
        try:
            ordinary.pip(work, "download", "--only-binary", ":all:", "-d", work / f"wheels-{host}", *wanted)
        except subprocess.CalledProcessError:
            print(f"skipped: the packages of {host} are not here, and PyPI cannot be reached")
            return ordinary.SKIPPED
        given.set()
    made = ordinary.Stamp(work / f"{host}.stamp", wheels[0].read_bytes(), *pins)
    if not made.is_fresh() or not (work / host).exists():
        python = ordinary.environment(work / host)
        links = ("--no-index", "--find-links", work / f"wheels-{host}")
        ordinary.pip(work, "--python", python, "install", "--no-compile", *links, *wanted)
        made.set()
    print("installed into", work / host)
    return 0


if __name__ == "__main__":
    ordinary.exit_with(main)

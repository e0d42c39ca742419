#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""build_zip.py WHEEL BACKEND FOLDER: packs the add-on, the wheel of Tamis and that of nanobind-backend into one zip for Blender.

Blender up to 4.1 installs it as an add-on, later versions as an add-on or as an extension. It works with the Python and
the system that BACKEND was built for (`pip download nanobind-backend`).
"""
import pathlib
import re
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ADDON = HERE / "tamis_check"
WHEN = (1980, 1, 1, 0, 0, 0)  # a fixed date, so that the same files make the same zip


def add(archive: zipfile.ZipFile, name: str, content: bytes) -> None:
    entry = zipfile.ZipInfo(name, WHEN)
    entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
    archive.writestr(entry, content)


def check_version(version: str) -> None:
    """Exit unless the wheel's version stands in bl_info, for add-ons, and in the manifest, for extensions."""
    info = re.search(r'"version": \((.*?)\)', (ADDON / "__init__.py").read_text())[1].replace(", ", ".")
    manifest = re.search(r'^version = "(.*?)"', (ADDON / "blender_manifest.toml").read_text(), re.MULTILINE)[1]
    if {info, manifest} != {version}:
        sys.exit(f"build_zip.py: the wheel is of version {version}, bl_info says {info} and the manifest {manifest}")


def main() -> None:
    wheel, backend, folder = map(pathlib.Path, sys.argv[1:])
    _, version, _, _, platform = wheel.stem.split("-")
    python = backend.stem.split("-")[2]
    check_version(version)
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"tamis_check-{version}-{python}-{platform.split('.')[0]}.zip"
    with zipfile.ZipFile(target, "w") as archive:
        add(archive, "tamis_check/LICENSE", (HERE / "LICENSE").read_bytes())
        for path in sorted(p for p in ADDON.iterdir() if p.is_file()):
            add(archive, f"tamis_check/{path.name}", path.read_bytes())
        for each in (wheel, backend):
            with zipfile.ZipFile(each) as content:
                for name in sorted(n for n in content.namelist() if not n.endswith("/")):
                    if not name.startswith("tamis/command/"):  # the command is not used here
                        add(archive, f"tamis_check/wheel/{name}", content.read(name))
    print(target)


if __name__ == "__main__":
    main()

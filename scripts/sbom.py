#!/usr/bin/env python3
"""sbom.py VERSION COMMIT DATE [FILE...]: prints a software bill of materials, CycloneDX 1.5 as JSON.

Its components are the packages that library and command contain or link: the rows of docs/dependencies.md that INSIDE names,
in the versions that this machine has, and the files of the release with their SHA-256. DATE is in seconds since 1970."""
import datetime
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import uuid

ROOT = pathlib.Path(__file__).resolve().parent.parent
# What shipped binaries contain or link, and the package of Debian that says its version.
INSIDE = {"oneTBB": "libtbb-dev", "Boost.Multiprecision": "libboost-dev", "xsimd": "libxsimd-dev", "CLI11": "libcli11-dev",
          "fast_float": "libfast-float-dev", "fmt": "libfmt-dev", "nlohmann-json": "nlohmann-json3-dev", "Eigen": "libeigen3-dev",
          "meshoptimizer": "libmeshoptimizer-dev", "zlib": "zlib1g-dev", "three.js": None}
ROW = re.compile(r"^\| \[([^\]]+)\]\(([^)]+)\) \| .* \| ([\w.-]+) \|$", re.MULTILINE)


def version_of(name: str) -> str:
    if INSIDE[name] is None:
        return json.loads((ROOT / "tools/viewer/package-lock.json").read_text())["packages"]["node_modules/three"]["version"]
    found = subprocess.run(["dpkg-query", "-W", "-f=${source:Upstream-Version}", INSIDE[name]], capture_output=True, text=True, check=False)
    if found.returncode:
        sys.exit(f"sbom.py: {INSIDE[name]} is not installed, so the version of {name} is unknown: run scripts/setup.sh")
    return found.stdout


def packages() -> list[dict]:
    rows = {name: (site, licence) for name, site, licence in ROW.findall((ROOT / "docs/dependencies.md").read_text())}
    missing = INSIDE.keys() - rows.keys()
    if missing:
        sys.exit(f"sbom.py: docs/dependencies.md has no row of {', '.join(sorted(missing))} with one site and one licence")
    return [{"type": "library", "bom-ref": name, "name": name, "version": version_of(name), "licenses": [{"license": {"id": rows[name][1]}}],
             "externalReferences": [{"type": "website", "url": rows[name][0]}]} for name in INSIDE]


def files(names: list[str]) -> list[dict]:
    return [{"type": "file", "bom-ref": f"file:{path.name}", "name": path.name,
             "hashes": [{"alg": "SHA-256", "content": hashlib.sha256(path.read_bytes()).hexdigest()}]}
            for path in sorted(map(pathlib.Path, names))]


def main() -> None:
    version, commit, date, *names = sys.argv[1:]
    inside = packages()
    when = datetime.datetime.fromtimestamp(int(date), datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    print(json.dumps({
        "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, f'tamis/{commit}')}",
        "metadata": {"timestamp": when, "component": {
            "type": "library", "bom-ref": "tamis", "name": "tamis", "version": version, "licenses": [{"license": {"id": "MIT"}}],
            "properties": [{"name": "commit", "value": commit}]}},
        "components": inside + files(names),
        "dependencies": [{"ref": "tamis", "dependsOn": [each["bom-ref"] for each in inside]}]}, indent=2))


if __name__ == "__main__":
    main()

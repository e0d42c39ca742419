#!/usr/bin/env python3
"""build_wheel.py WORK [BUILD]: builds the module for Python as it is shipped, and installs it into a new environment.

Makes in WORK: `wheels`, the packages that bindings/python/requirements.txt pins; `tools`, a virtual environment with the tools to
build and check; `sdist`, the source distribution; `dist`, the wheel that is built from it, for this machine alone
(scripts/release_wheel.py builds wheels for others); `user`, an environment with the wheel, tried with NumPy and nanobind's
backend alone, and the packages that the tests need.

PyPI is asked only if the requirements have changed; exit code 77 if it cannot be reached. With BUILD, a folder in which
Tamis was built, the wheel takes its libraries from there, which saves minutes. Without it, the wheel is built from
scratch as by `pip install`.
"""
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import venv

ROOT = pathlib.Path(__file__).resolve().parent.parent
REQUIREMENTS = ROOT / "bindings" / "python" / "requirements.txt"
TOOLS = ("build", "mypy", "nanobind", "ruff", "scikit_build_core", "wheel")
SKIPPED = 77


def run(*command, **options) -> str:
    return subprocess.run([str(c) for c in command], check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def environment(folder: pathlib.Path, with_pip: bool = False) -> pathlib.Path:
    """Make a new, empty virtual environment; return its Python."""
    shutil.rmtree(folder, ignore_errors=True)
    venv.create(folder, with_pip=with_pip, symlinks=True)
    return folder / "bin" / "python"


def pip(work: pathlib.Path, *arguments) -> None:
    """Run the pip of the tools."""
    run(work / "tools/bin/python", "-m", "pip", "--quiet", "--disable-pip-version-check", *arguments)


def install(work: pathlib.Path, python: pathlib.Path, *what) -> None:
    """Install packages from WORK/wheels into an environment. Modules are not compiled, as most are never imported."""
    pip(work, "--python", python, "install", "--no-compile", "--no-index", "--find-links", work / "wheels", *what)


class Stamp:
    """Remembers, in a file, from which contents something was made, so that it is made again only if these change."""

    def __init__(self, path: pathlib.Path, *made_from: bytes):
        self.path, self.digest = path, hashlib.sha256(b"\0".join(made_from)).hexdigest()

    def is_fresh(self) -> bool:
        return self.path.exists() and self.path.read_text() == self.digest

    def set(self) -> None:
        self.path.write_text(self.digest)


def make_tools(work: pathlib.Path) -> None:
    stamp = Stamp(work / "tools.stamp", REQUIREMENTS.read_bytes(), sys.version.encode())
    if stamp.is_fresh():
        return
    python = environment(work / "tools", with_pip=True)
    try:
        pip(work, "download", "--only-binary", ":all:", "-r", REQUIREMENTS, "-d", work / "wheels")
    except subprocess.CalledProcessError:
        print("skipped: the tools of bindings/python/requirements.txt are not here, and PyPI cannot be reached")
        sys.exit(SKIPPED)
    install(work, python, "-c", REQUIREMENTS, *TOOLS)
    stamp.set()


def make_source(work: pathlib.Path) -> pathlib.Path:
    """Make the source distribution; return the folder where it is unpacked.

    Files that have not changed keep their times, so that only the others are compiled again.
    """
    shutil.rmtree(work / "sdist", ignore_errors=True)
    run(work / "tools/bin/python", "-m", "build", "--sdist", "--no-isolation", "--outdir", work / "sdist", ROOT)
    (archive,) = (work / "sdist").glob("*.tar.gz")
    source, here = work / "source", set()
    with tarfile.open(archive) as tar:
        for member in filter(tarfile.TarInfo.isfile, tar.getmembers()):
            path = source / pathlib.PurePath(*pathlib.PurePath(member.name).parts[1:])
            content = tar.extractfile(member).read()
            here.add(path)
            if not path.exists() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
    for path in source.rglob("*"):
        if path.is_file() and path not in here:
            path.unlink()
    return source


def source_digest(source: pathlib.Path) -> bytes:
    digest = hashlib.sha256()
    for path in sorted(p for p in source.rglob("*") if p.is_file()):
        digest.update(str(path.relative_to(source)).encode() + b"\0" + path.read_bytes())
    return digest.digest()


def search_path(work: pathlib.Path) -> "dict[str, str]":
    """Return environment variables in which PATH begins with the tools."""
    return {**os.environ, "PATH": f"{work / 'tools/bin'}:{os.environ['PATH']}"}


def with_libraries_of(build: pathlib.Path) -> "list[str]":
    """Return definitions for CMake: take the libraries of `build`, and compile the rest in one unit, which is fastest."""
    return [f"TAMIS_BUILT={build}", "CMAKE_UNITY_BUILD_BATCH_SIZE=0"]


def compile_wheel(
    work: pathlib.Path, source: pathlib.Path, name: str, defines: "list[str]", mpi: str = "OFF", objects: str = "objects"
) -> pathlib.Path:
    """Build the wheel into WORK/name; its objects stay in WORK/objects for the next time, and for the other wheel."""
    shutil.rmtree(work / name, ignore_errors=True)
    options = [f"-Ccmake.define.{define}" for define in (f"TAMIS_PYTHON_MPI={mpi}", *defines)]
    run(work / "tools/bin/python", "-m", "build", "--wheel", "--no-isolation", "--outdir", work / name,
        f"-Cbuild-dir={work / objects}", *options, source, env=search_path(work))
    (wheel,) = (work / name).glob("*.whl")
    return wheel


def make_user(work: pathlib.Path, wheel: pathlib.Path) -> None:
    """Install the wheel, which must work with NumPy alone; then install the packages of the tests."""
    python = environment(work / "user")
    install(work, python, wheel)
    run(python, "-I", "-c", "import tamis; assert len(tamis.contacts([[0,1,2]], [[0,0,0],[1,0,0],[0,1,0]], "
        "[[0,0,0],[1,0,0],[0,1,0]])) == 0")
    wanted = ("pytest", "hypothesis", "ipctk", "pandas", "matplotlib", "usd-core", "pygltflib")
    install(work, python, "-c", REQUIREMENTS, *wanted)


def exit_with(main) -> None:
    """Run a script's main function and exit with its code; if a command fails, show its output and name it."""
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as failure:
        print(failure.stdout or "", file=sys.stderr)
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: failed: {' '.join(failure.cmd)}")


def main() -> int:
    if not sys.argv[1:] or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    work, *build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    work.mkdir(parents=True, exist_ok=True)
    make_tools(work)
    source = make_source(work)
    defines = with_libraries_of(*build) if build else []
    built = [path.read_bytes() for folder in build for path in [*sorted(folder.glob("**/libtamis*.a")), folder / "bin/tamis"]]
    stamp = Stamp(work / "wheel.stamp", source_digest(source), REQUIREMENTS.read_bytes(), *built)
    if not stamp.is_fresh() or not (work / "user").exists():
        stamp.path.unlink(missing_ok=True)
        wheel = compile_wheel(work, source, "dist", defines)
        make_user(work, wheel)
        stamp.set()
    print("installed into", work / "user")
    return 0


if __name__ == "__main__":
    exit_with(main)

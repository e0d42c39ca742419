"""The wheel needs no libraries of the system, and names the licences of its own."""

from __future__ import annotations

import importlib
import importlib.metadata
import pathlib
import re
import subprocess
import sys
import sysconfig

import pytest

import tamis

ON_WINDOWS = sys.platform == "win32"
OLDEST = r"CPython 3\.12" if ON_WINDOWS else r"CPython 3\.10"


def _is_shipped() -> bool:
    """Return whether this is a wheel of scripts/release_wheel.py."""
    text = importlib.metadata.distribution("tamis").read_text("WHEEL") or ""
    return "manylinux" in text or "win_amd64" in text


def test_one_file_serves_all_pythons() -> None:
    """Would catch a module for the Python that built it."""
    compiled = [path.name for path in pathlib.Path(tamis.__file__).parent.glob("_core.*") if path.suffix != ".pyi"]
    assert compiled in (["_core.abi3.so"], ["_core.pyd"])


def test_no_library_is_shared_but_the_systems() -> None:
    """Would catch a wheel that works only where oneTBB is installed."""
    if not _is_shipped():
        pytest.skip("this wheel is for the machine that built it")
    if ON_WINDOWS:
        pytest.skip("scripts/release_wheel.py looks at the DLLs")
    # In a process of its own: other packages, such as usd-core, have a oneTBB, too.
    show = "import tamis; tamis.Detector(tamis.Mesh([[0, 1, 2]])); print(open('/proc/self/maps').read())"
    maps = subprocess.run([sys.executable, "-c", show], check=True, capture_output=True, text=True).stdout
    loaded = {pathlib.Path(path).name.partition(".so")[0] for path in re.findall(r"/\S+\.so[\w.-]*", maps)}
    assert loaded and not loaded & {"libtbb", "libfmt", "libmeshoptimizer"}


@pytest.mark.parametrize(
    ("before", "sentence"),
    [
        pytest.param(
            "sys.modules['nanobind_backend'] = None",
            "'pip install nanobind-backend'",
            marks=pytest.mark.skipif(ON_WINDOWS, reason="nanobind is inside"),
        ),
        ("sys._tamis_version = '9.9.9'", "this process has loaded tamis 9.9.9 already: start a new process"),
        ("sys.version_info = (3, 9, 18)", f"{OLDEST} or newer with a GIL, and .* is cpython 3.9: use"),
        ("sys.implementation.name = 'pypy'", f"{OLDEST} or newer with a GIL, and .* is pypy 3"),
        ("import sysconfig; sysconfig.get_config_vars()['Py_GIL_DISABLED'] = 1", "3.* without a GIL: use"),
        ("sys.modules['tamis._core'] = None", "has no compiled part for this Python: pip install --force-reinstall"),
        (
            "import types; sys.modules['tamis._version'] = types.SimpleNamespace(VERSION='9.9.9')",
            "tamis 9.9.9 has found a compiled part of version .*: pip install --force-reinstall",
        ),
    ],
)
def test_a_module_that_cannot_work_says_why(before: str, sentence: str) -> None:
    """Bugs: no word about the missing package; two versions share nanobind's classes; an old Python, half an update."""
    words = [sys.executable, "-c", f"import sys; {before}; import tamis"]
    asked = subprocess.run(words, capture_output=True, text=True)
    assert asked.returncode == 1
    assert re.search(rf"^ImportError: .*{sentence}", asked.stderr, re.MULTILINE), asked.stderr


def test_licences_are_inside() -> None:
    files = [str(file) for file in importlib.metadata.files("tamis") or []]
    licences = {pathlib.Path(name).name for name in files if "/licenses/" in name}
    assert "LICENSE" in licences
    for wanted in ("libtbb-dev", "nanobind", "Apache-2.0") if _is_shipped() else ():
        assert any(name.startswith(wanted) for name in licences), f"no licence of {wanted} in {licences}"


def test_metadata_name_every_licence() -> None:
    """Bug: a wheel that contains libraries of other licences named the MIT licence only."""
    metadata, files = importlib.metadata.metadata("tamis"), importlib.metadata.files("tamis") or []
    inside = {str(file).partition("/licenses/")[2] for file in files if "/licenses/" in str(file)}
    assert set(metadata.get_all("License-File") or []) == inside
    expression = metadata["License-Expression"].split(" AND ")
    assert not any("GPL" in licence for licence in expression)
    if _is_shipped():
        of_mingw = {"ZPL-2.1"} if ON_WINDOWS else set()
        assert {"MIT", "Apache-2.0", "MPL-2.0", "BSD-3-Clause", "BSL-1.0", "Zlib"} | of_mingw == set(expression)


def test_the_command_comes_along(tmp_path: pathlib.Path) -> None:
    """Would catch a command that is missing, not executable, or without its libraries or files."""
    command = pathlib.Path(sysconfig.get_path("scripts")) / ("tamis.exe" if ON_WINDOWS else "tamis")
    if not command.exists():
        pytest.skip("tamis was not installed into this environment")
    environment = None if ON_WINDOWS else {"PATH": "/usr/bin:/bin"}
    version = subprocess.run([command, "--version"], env=environment, check=True, capture_output=True, text=True)
    assert tamis.__version__ in version.stdout
    scene = tamis.scene("soup", 100)
    for name, positions in (("start", scene.start), ("end", scene.end)):
        tamis.write_mesh(tmp_path / f"{name}.ply", positions, scene.mesh.faces)
    for out in ("contacts.csv", "page.html"):
        words = [str(command), "contacts", "start.ply", "end.ply", "--out", out]
        asked = subprocess.run(words, env=environment, cwd=tmp_path, capture_output=True, text=True)
        assert asked.returncode in (0, 1) and not asked.stderr, asked.stderr
    rows = (tmp_path / "contacts.csv").read_text().splitlines()
    found = tamis.Detector(scene.mesh).contacts(scene.start, scene.end)
    assert len(rows) == 1 + len(found) > 10 and (tmp_path / "page.html").stat().st_size > 1000


def test_the_examples_come_along() -> None:
    shipped = pathlib.Path(tamis.__file__).with_name("examples")
    if not shipped.is_dir():
        pytest.skip("tamis was not installed from a wheel")
    ours = pathlib.Path(__file__).resolve().parents[1] / "examples"
    texts = {path.name: path.read_text() for path in ours.glob("*.py")}
    assert texts and {path.name: path.read_text() for path in shipped.glob("*.py")} == texts


def test_knows_no_mpi() -> None:
    """Would catch a wheel that loads MPI, or that cannot be imported without it."""
    package = pathlib.Path(tamis.__file__).resolve().parent
    assert not [path for path in package.glob("_distributed*") if path.suffix in (".so", ".pyd")]
    assert ON_WINDOWS or "libmpi" not in pathlib.Path("/proc/self/maps").read_text()
    with pytest.raises(ImportError):
        importlib.import_module("tamis.distributed")


def test_metadata() -> None:
    assert importlib.metadata.version("tamis") == tamis.__version__
    requires = importlib.metadata.requires("tamis") or []
    assert [needed for needed in requires if "extra ==" not in needed] == [
        "numpy>=1.21",
        'nanobind-backend>=1.0; sys_platform != "win32"',
    ]
    assert pathlib.Path(tamis.__file__).with_name("py.typed").exists()


def test_everything_public_has_a_docstring() -> None:
    for name in tamis.__all__:
        thing = getattr(tamis, name)
        assert thing.__doc__ and len(thing.__doc__) > 20, name
        for part in thing.__mro__ if isinstance(thing, type) else ():
            for attribute, value in vars(part).items() if part.__module__.startswith("tamis") else ():
                if not attribute.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert value.__doc__, f"{name}.{attribute}"

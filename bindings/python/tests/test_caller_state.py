"""Answers do not depend on the floating-point state of the calling thread, which has it again afterwards."""

from __future__ import annotations

import contextlib
import ctypes
import ctypes.util
import pathlib
import platform
import struct
from collections.abc import Callable, Iterator

import numpy as np
import pytest

import tamis

pytestmark = pytest.mark.skipif(
    platform.machine() != "x86_64" or platform.system() != "Linux", reason="knows the registers of Linux on x86-64"
)

# Of the x87 control word, and of MXCSR: the rounding direction; then both flags that take subnormal numbers for zero.
STATES = {"downward": (0x400, 0x2000), "upward": (0x800, 0x4000), "zero": (0xC00, 0x6000), "flushing": (0, 0x8040)}
MXCSR = 28  # its place in glibc's fenv_t


def _environment() -> ctypes.Array[ctypes.c_char]:
    environment = ctypes.create_string_buffer(64)
    ctypes.CDLL(ctypes.util.find_library("m")).fegetenv(environment)
    return environment


def bits_here() -> tuple[int, int]:
    environment = _environment()
    return struct.unpack_from("<H", environment)[0] & 0xC00, struct.unpack_from("<I", environment, MXCSR)[0] & 0xE040


@contextlib.contextmanager
def state(name: str) -> Iterator[None]:
    before, changed = _environment(), _environment()
    word, flags = STATES[name]
    struct.pack_into("<H", changed, 0, struct.unpack_from("<H", changed)[0] | word)
    struct.pack_into("<I", changed, MXCSR, struct.unpack_from("<I", changed, MXCSR)[0] | flags)
    libm = ctypes.CDLL(ctypes.util.find_library("m"))
    libm.fesetenv(changed)
    try:
        yield
    finally:
        libm.fesetenv(before)


def contacts_of(scene: tamis.Scene) -> list[bytes]:
    found = tamis.Detector(scene.mesh).contacts(scene.start, scene.end)
    return [found.toi_lower.tobytes(), found.toi_upper.tobytes(), found.u.tobytes(), found.normal.tobytes()]


def lengths_of(scene: tamis.Scene) -> list[bytes]:
    detector = tamis.Detector(scene.mesh)
    safe, first = detector.safe_step(scene.start, scene.end), detector.earliest(scene.start, scene.end)
    truncated = detector.truncate(scene.start, scene.end)
    return [np.array([safe.toi_lower, safe.toi_upper, first.toi_lower]).tobytes(), truncated.positions.tobytes()]


def near_of(scene: tamis.Scene) -> list[bytes]:
    near = tamis.Detector(scene.mesh).pairs_within(scene.start, 0.0625)
    return [near.distance.tobytes(), near.direction.tobytes()]


def curves_of(scene: tamis.Scene) -> list[bytes]:
    path = tamis.CatmullRomPath([scene.start, scene.end, scene.start])
    found = tamis.Detector(scene.mesh).contacts(path)
    return [found.toi_lower.tobytes(), path.points_at(0.3).tobytes()]


def poses_of(scene: tamis.Scene) -> list[bytes]:
    start = tamis.pose_of([[0.6, 0.48, 0.64, 0.0]], scene.start[:1])
    chain = tamis.chain_between(start[0], [[0.1, 0.7, 0.3], [1.1, 0.2, 0.3]], center=[0.1, 0.2, 0.3])
    return [start.tobytes(), chain.tobytes(), tamis.pose_at(chain, 0.7).tobytes()]


def pairs_of(scene: tamis.Scene) -> list[bytes]:
    vertices = np.arange(len(scene.start) // 4 * 4).reshape(-1, 4)
    found = tamis.narrow_phase(tamis.PairKind.EDGE_EDGE, vertices, scene.start, scene.end)
    return [found.touches.tobytes(), found.toi_lower.tobytes()]


QUESTIONS = [contacts_of, lengths_of, near_of, curves_of, poses_of, pairs_of]


@pytest.mark.parametrize("name", STATES)
@pytest.mark.parametrize("ask", QUESTIONS)
def test_answers_are_the_same(soup: tamis.Scene, name: str, ask: Callable[[tamis.Scene], list[bytes]]) -> None:
    expected = ask(soup)
    with state(name):
        before = bits_here()
        assert before != (0, 0)
        found = ask(soup)
        after = bits_here()
    assert after == before
    assert found == expected


@pytest.mark.parametrize("name", STATES)
def test_files_are_read_alike(tmp_path: pathlib.Path, name: str) -> None:
    """Bug: decimals were rounded as the caller's mode says, each to another double."""
    numbers = [f"{0.1 * i + 1 / 3:.17g} {i}.7 1e-310" for i in range(50)]
    file = tmp_path / "mesh.obj"
    file.write_text("".join(f"v {n}\n" for n in numbers) + "f 1 2 3\n")
    expected = tamis.read_mesh(file).positions.tobytes()
    with state(name):
        found = tamis.read_mesh(file).positions.tobytes()
    assert found == expected


@pytest.mark.parametrize("name", STATES)
def test_callables_have_the_callers_state(falling: tamis.Scene, name: str) -> None:
    seen = []

    def accepts(_kind: int, _vertices: tuple[int, ...]) -> bool:
        seen.append(bits_here())
        return True

    with state(name):
        expected = bits_here()
        tamis.Detector(falling.mesh, filter=accepts, threads=1).contacts(falling.start, falling.end)
    assert seen
    assert set(seen) == {expected}

"""Settings and fixtures of all tests."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import settings

import tamis

# Hypothesis makes the same examples every time, and has no deadline: a slow machine is no failure.
settings.register_profile("fixed", derandomize=True, deadline=None, max_examples=100, database=None)
settings.load_profile("fixed")

FACES = np.array([[0, 1, 2], [3, 4, 5]])
START = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1], [1, 0.5, 2], [0.5, 1, 2]], float)
END = START.copy()
END[3, 2] = -1

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) - 0.5
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
CUBE_FACES = np.array([corners for a, b, c, d in QUADS for corners in ((a, b, c), (a, c, d))])


def at(*places: Any) -> npt.NDArray[np.float64]:
    """Return poses at these places, without rotation."""
    return tamis.pose_of(np.zeros((len(places), 3)), np.array(places, float))


@pytest.fixture(scope="session", autouse=True)
def _pages(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Write pages without a given name into a folder that pytest removes."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("tempfile.tempdir", str(tmp_path_factory.mktemp("pages")))
        yield


@pytest.fixture
def falling() -> tamis.Scene:
    """Return two triangles: vertex 3, of the second, falls through the first at t = 0.5."""
    return tamis.Scene(tamis.Mesh(FACES), START.copy(), END.copy(), np.array([0, 0, 0, 1, 1, 1], np.int32))


@pytest.fixture
def detector(falling: tamis.Scene) -> tamis.Detector:
    """Return a detector of the falling triangle."""
    return tamis.Detector(falling.mesh)


@pytest.fixture(scope="session")
def soup() -> tamis.Scene:
    """Return triangles that cross each other, with thousands of contacts."""
    return tamis.scene("soup", 200, seed=3)


@pytest.fixture(scope="session")
def cube() -> tamis.Shape:
    """Return a cube of edge length 1, centred at its origin."""
    return tamis.Shape(tamis.Mesh(CUBE_FACES), CUBE)

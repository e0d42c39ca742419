"""What the tests share."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import settings

import tamis

# The same examples every time, and no clock: a slow machine is no failure.
settings.register_profile("fixed", derandomize=True, deadline=None, max_examples=100, database=None)
settings.load_profile("fixed")

FACES = np.array([[0, 1, 2], [3, 4, 5]])
START = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 1], [1, 0.5, 2], [0.5, 1, 2]], float)
END = START.copy()
END[3, 2] = -1


@pytest.fixture(scope="session", autouse=True)
def _pages(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Pages that nobody has named a place for are left where pytest clears up."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("tempfile.tempdir", str(tmp_path_factory.mktemp("pages")))
        yield


@pytest.fixture
def falling() -> tamis.Scene:
    """Two triangles; vertex 3 of the second falls through the first, at half of the step."""
    return tamis.Scene(tamis.Mesh(FACES), START.copy(), END.copy(), np.array([0, 0, 0, 1, 1, 1], np.int32))


@pytest.fixture
def detector(falling: tamis.Scene) -> tamis.Detector:
    """Asks about the falling triangle."""
    return tamis.Detector(falling.mesh)


@pytest.fixture(scope="session")
def soup() -> tamis.Scene:
    """Triangles that cross each other: thousands of contacts."""
    return tamis.scene("soup", 200, seed=3)

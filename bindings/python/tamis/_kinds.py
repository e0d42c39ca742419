"""Kinds of pairs of features, and which vertices of a pair belong to its first feature."""

from __future__ import annotations

import enum

import numpy as np
import numpy.typing as npt


class PairKind(enum.IntEnum):
    """Kinds of pairs of features. The last two are for loose edges and loose points, which belong to no face."""

    VERTEX_FACE = 0
    EDGE_EDGE = 1
    VERTEX_EDGE = 2
    VERTEX_VERTEX = 3

    @property
    def short_name(self) -> str:
        """The name in files and on the command line: vf, ee, ve, vv."""
        return SHORT_NAMES[self]

    @property
    def long_name(self) -> str:
        """The name in sentences: vertex-face, edge-edge, vertex-edge, vertex-vertex."""
        return self.name.lower().replace("_", "-")


SHORT_NAMES = ("vf", "ee", "ve", "vv")
# By kind: the number of vertices of a pair's first feature, which come first in its `vertices`.
FIRST_COUNTS = np.array([1, 2, 1, 1])


def both_features(
    kinds: npt.NDArray[np.uint8], vertices: npt.NDArray[np.int32]
) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
    """Return the vertices of each pair's first and second feature, shape (n, 3) each; unused entries are -1."""
    of_first = FIRST_COUNTS[kinds][:, np.newaxis]
    corners = np.arange(3)
    padded = np.pad(vertices, ((0, 0), (0, 1)), constant_values=-1)
    second = np.take_along_axis(padded, of_first + corners, 1)
    return np.where(corners < of_first, vertices[:, :3], -1), second

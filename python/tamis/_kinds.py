"""Kinds of pairs of features."""

from __future__ import annotations

import enum

import numpy as np


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
